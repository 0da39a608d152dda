/* SPDX-License-Identifier: MIT */
/*
 * The CRC reads the bytes that it is given, of any number, and ends.
 *
 *   proves: scene_crc32
 *   options: -eva-precision 3
 *   then: -wp -wp-rte -wp-model Typed+Cast -wp-prover cvc4 -wp-fct scene_crc32
 */
#include "bytes.h"
#include "proof.h"

#include "firmware/scene/crc32.c"

void prove(void)
{
    uint8_t bytes[100];
    any_bytes(bytes, sizeof bytes);
    scene_crc32(ANY_U32, bytes, any_u32(0, sizeof bytes));
}
