/* SPDX-License-Identifier: MIT */
#include "scene/scene.h"

/* A nibble at a time: 64 bytes of table instead of 1 KiB; this runs once over a scene. Entry i is the remainder of
 * the nibble i under the reflected polynomial 0xEDB88320. */
static const uint32_t nibble[16] = {
    0x00000000, 0x1DB71064, 0x3B6E20C8, 0x26D930AC, 0x76DC4190, 0x6B6B51F4, 0x4DB26158, 0x5005713C,
    0xEDB88320, 0xF00F9344, 0xD6D6A3E8, 0xCB61B38C, 0x9B64C2B0, 0x86D3D2D4, 0xA00AE278, 0xBDBDF21C,
};

uint32_t scene_crc32(uint32_t crc, const void *bytes, size_t size)
{
    const uint8_t *p = bytes;
    crc = ~crc;
    /*@ loop invariant 0 <= end - p <= size && end == p + (end - p);
        loop assigns p, crc;
        loop variant end - p; */
    for (const uint8_t *end = p + size; p != end; p++) {
        crc ^= *p;
        crc = crc >> 4 ^ nibble[crc & 15];
        crc = crc >> 4 ^ nibble[crc & 15];
    }
    return ~crc;
}
