// SPDX-License-Identifier: MIT
import zlib from 'node:zlib';

function chunk(type, data) {
    const bytes = Buffer.alloc(12 + data.length);
    bytes.writeUInt32BE(data.length, 0);
    bytes.write(type, 4, 'latin1');
    data.copy(bytes, 8);
    bytes.writeUInt32BE(crc32(bytes.subarray(4, 8 + data.length)), 8 + data.length);
    return bytes;
}

function crc32(bytes) {
    let crc = -1;
    for (const byte of bytes) {
        crc ^= byte;
        for (let bit = 0; bit < 8; bit++) crc = crc >>> 1 ^ (crc & 1 ? 0xedb88320 : 0);
    }
    return ~crc >>> 0;
}

// A PNG of RGB565 pixels, widened by repeating their upper bits.
export function png({pixels, width, height}) {
    const rows = Buffer.alloc(height * (1 + 3 * width));
    for (let y = 0, at = 0; y < height; y++) {
        at++;
        for (let x = 0; x < width; x++) {
            const p = pixels[y * width + x], r = p >> 11, g = p >> 5 & 63, b = p & 31;
            rows[at++] = r << 3 | r >> 2;
            rows[at++] = g << 2 | g >> 4;
            rows[at++] = b << 3 | b >> 2;
        }
    }
    const header = Buffer.alloc(13);
    header.writeUInt32BE(width, 0);
    header.writeUInt32BE(height, 4);
    header.set([8, 2, 0, 0, 0], 8);
    return Buffer.concat([Buffer.from('\x89PNG\r\n\x1a\n', 'latin1'), chunk('IHDR', header),
        chunk('IDAT', zlib.deflateSync(rows)), chunk('IEND', Buffer.alloc(0))]);
}
