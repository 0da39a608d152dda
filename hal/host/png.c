/* SPDX-License-Identifier: MIT */
/*
 * PNG and animated PNG (PNG specification, third edition). Both are one encoder: an animation is the chunks acTL and
 * fcTL around the same compressed pictures, which after the first are stored as fdAT. Rows are filtered by the
 * specification's rule of thumb, the least sum of absolute differences, and compressed as they come.
 */
#include "host/displays.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <zlib.h>

#define PNG_CHUNK    32768u /* bytes of compressed data a chunk */
#define PNG_FILTERS  5u
#define PNG_COUNT_AT (8 + 12 + 13) /* behind the signature and IHDR */

struct png_coder {
    z_stream stream;
    uint32_t sequence;            /* of the next fcTL or fdAT */
    struct host_part part;        /* under way */
    size_t row_bytes;             /* of a row of its samples */
    uint8_t *above;               /* the row before */
    uint8_t *line[2];             /* filter type and filtered row: the best so far and the one being tried */
    uint8_t chunk[PNG_CHUNK + 4]; /* room for fdAT's sequence number in front */
};

static void png_put32(uint8_t *out, uint32_t value)
{
    for (int i = 0; i < 4; i++)
        out[i] = (uint8_t)(value >> (24 - 8 * i));
}

static int png_write_chunk(struct host_display *host, const char *type, const uint8_t *data, uint32_t size)
{
    uint8_t head[8], tail[4];
    png_put32(head, size);
    memcpy(head + 4, type, 4);
    uint32_t crc = (uint32_t)crc32(crc32(0, head + 4, 4), size ? data : head, size);
    png_put32(tail, crc);
    int result = sink_write(&host->sink, head, 8);
    if (!result && size)
        result = sink_write(&host->sink, data, size);
    return result ? result : sink_write(&host->sink, tail, 4);
}

static int png_write_count(struct host_display *host, uint32_t count)
{
    uint8_t animation[8] = {0};
    png_put32(animation, count); /* repeated 0 times: for ever */
    return png_write_chunk(host, "acTL", animation, sizeof animation);
}

/* What comes before the first picture: PNG_COUNT_AT bytes, then the number of pictures. */
static int png_write_head(struct host_display *host)
{
    static const uint8_t signature[8] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
    uint8_t header[13] = {0};
    png_put32(header, host->width);
    png_put32(header + 4, host->height);
    header[8] = 8;                                               /* bits a sample */
    header[9] = host_display_samples(host->format) == 3 ? 2 : 0; /* truecolour or grey */
    int result = sink_write(&host->sink, signature, sizeof signature);
    if (!result)
        result = png_write_chunk(host, "IHDR", header, sizeof header);
    if (!result && host->frames > 1)
        result = png_write_count(host, host->frames);
    return result;
}

/* Where the number of pictures was not known before, it is now. */
static int png_write_end(struct host_display *host)
{
    int result = png_write_chunk(host, "IEND", NULL, 0);
    if (result || host->frames != HOST_FRAMES_ANY)
        return result;
    if (fseeko(host->sink.stream, PNG_COUNT_AT, SEEK_SET) != 0)
        return HAL_E_IO;
    return png_write_count(host, host->count);
}

static int png_close(struct hal_display *display, int keep)
{
    struct host_display *host = (struct host_display *)display;
    struct png_coder *coder = host->coder;
    int result = 0;
    /* a reader takes the count in acTL at its word */
    if (keep && (host->frames == HOST_FRAMES_ANY ? host->count == 0 : host->count != host->frames))
        result = HAL_E_ARGUMENT;
    else if (keep)
        result = png_write_end(host);
    if (coder) {
        deflateEnd(&coder->stream);
        free(coder->above);
        free(coder->line[0]);
        free(coder->line[1]);
        free(coder);
    }
    host->coder = NULL;
    int closed = host_display_finish(host, keep && !result);
    return result ? result : closed;
}

static int png_open(struct hal_display *display, uint16_t width, uint16_t height, enum hal_pixel_format format)
{
    struct host_display *host = (struct host_display *)display;
    size_t bytes = (size_t)host_display_samples(format) * width;
    if (host->frames == 0)
        return HAL_E_ARGUMENT;
    int result = host_display_prepare(host, width, height, format, (uint32_t)bytes);
    if (result)
        return result;
    struct png_coder *coder = host->coder = calloc(1, sizeof *coder);
    result = HAL_E_FULL;
    if (coder) {
        coder->above = malloc(bytes);
        coder->line[0] = malloc(bytes + 1);
        coder->line[1] = malloc(bytes + 1);
        if (coder->above && coder->line[0] && coder->line[1] &&
            deflateInit2(&coder->stream, 6, Z_DEFLATED, 15, 9, Z_FILTERED) == Z_OK)
            result = sink_open(&host->sink, host->path);
    }
    if (!result && host->frames == HOST_FRAMES_ANY && fseeko(host->sink.stream, 0, SEEK_CUR) != 0)
        result = HAL_E_IO;
    if (!result)
        result = png_write_head(host);
    if (result)
        png_close(display, 0);
    return result;
}

static void png_chunk_begin(struct png_coder *coder)
{
    coder->stream.next_out = coder->chunk + 4;
    coder->stream.avail_out = PNG_CHUNK;
}

static int png_chunk_end(struct host_display *host)
{
    struct png_coder *coder = host->coder;
    uint32_t size = PNG_CHUNK - coder->stream.avail_out;
    int result = 0;
    if (size && host->count == 0) {
        result = png_write_chunk(host, "IDAT", coder->chunk + 4, size);
    } else if (size) {
        png_put32(coder->chunk, coder->sequence++);
        result = png_write_chunk(host, "fdAT", coder->chunk, size + 4);
    }
    png_chunk_begin(coder);
    return result;
}

/* False if it is not within the picture, or the first that is not all of it. */
static bool png_set_part(struct host_display *host)
{
    const struct host_part all = {0, 0, host->width, host->height};
    const struct host_part *p = host->part.width ? &host->part : &all;
    if (p->x + p->width > host->width || p->y + p->height > host->height || p->height == 0 ||
        (host->count == 0 && (p->width != host->width || p->height != host->height)))
        return false;
    host->coder->part = *p;
    host->coder->row_bytes = (size_t)host_display_samples(host->format) * p->width;
    return true;
}

static int png_frame_begin(struct hal_display *display, uint32_t index, uint32_t delay_ms)
{
    struct host_display *host = (struct host_display *)display;
    struct png_coder *coder = host->coder;
    uint8_t control[26] = {0}; /* stays for the next to replace a part of, which it does, opaque or not */
    (void)index;
    if (host->count == host->frames || !png_set_part(host))
        return HAL_E_ARGUMENT;
    deflateReset(&coder->stream);
    png_chunk_begin(coder);
    memset(coder->above, 0, coder->row_bytes);
    if (host->frames == 1)
        return 0;
    png_put32(control, coder->sequence++);
    png_put32(control + 4, coder->part.width);
    png_put32(control + 8, coder->part.height);
    png_put32(control + 12, coder->part.x);
    png_put32(control + 16, coder->part.y);
    /* shown for delay / 1000 s, both in 16 bits */
    png_put32(control + 20, (delay_ms < 65535 ? delay_ms : 65535) << 16 | 1000);
    return png_write_chunk(host, "fcTL", control, sizeof control);
}

static uint8_t png_paeth(int left, int above, int corner)
{
    int estimate = left + above - corner;
    int to_left = abs(estimate - left), to_above = abs(estimate - above), to_corner = abs(estimate - corner);
    if (to_left <= to_above && to_left <= to_corner)
        return (uint8_t)left;
    return (uint8_t)(to_above <= to_corner ? above : corner);
}

/* Filters a row into line[1] and gives the sum of absolute differences. */
static uint32_t png_filter(struct png_coder *coder, unsigned filter, const uint8_t *row, unsigned samples)
{
    uint8_t *out = coder->line[1];
    uint32_t sum = 0;
    *out++ = (uint8_t)filter;
    for (size_t i = 0; i < coder->row_bytes; i++) {
        uint8_t left = i < samples ? 0 : row[i - samples], above = coder->above[i];
        uint8_t corner = i < samples ? 0 : coder->above[i - samples];
        uint8_t guess = 0;
        switch (filter) {
        case 1:
            guess = left;
            break;
        case 2:
            guess = above;
            break;
        case 3:
            guess = (uint8_t)((left + above) / 2);
            break;
        case 4:
            guess = png_paeth(left, above, corner);
            break;
        }
        uint8_t difference = (uint8_t)(row[i] - guess);
        out[i] = difference;
        sum += difference < 128 ? difference : 256u - difference;
    }
    return sum;
}

static int png_deflate(struct host_display *host, const uint8_t *bytes, size_t size, int flush)
{
    struct png_coder *coder = host->coder;
    int result = 0, state;
    coder->stream.next_in = (Bytef *)(uintptr_t)bytes; /* zlib only reads it */
    coder->stream.avail_in = (uInt)size;
    do {
        state = deflate(&coder->stream, flush);
        if (coder->stream.avail_out == 0 || state == Z_STREAM_END)
            result = png_chunk_end(host);
    } while (!result && (flush == Z_FINISH ? state != Z_STREAM_END : coder->stream.avail_in > 0));
    return result;
}

static int png_row(struct host_display *host)
{
    struct png_coder *coder = host->coder;
    uint32_t least = UINT32_MAX;
    for (unsigned filter = 0; filter < PNG_FILTERS; filter++) {
        uint32_t sum = png_filter(coder, filter, host->pixels, host_display_samples(host->format));
        if (sum < least) {
            uint8_t *best = coder->line[1];
            coder->line[1] = coder->line[0];
            coder->line[0] = best;
            least = sum;
        }
    }
    uint8_t *row = host->pixels;
    host->pixels = coder->above;
    coder->above = row;
    return png_deflate(host, coder->line[0], coder->row_bytes + 1, Z_NO_FLUSH);
}

static int png_flush(struct hal_display *display, const void *pixels, uint16_t y, uint16_t rows, uint32_t stride)
{
    struct host_display *host = (struct host_display *)display;
    int result = 0;
    (void)y;
    for (uint16_t row = 0; row < rows && !result; row++) {
        host_display_widen(host->format, (const uint8_t *)pixels + (size_t)row * stride, host->coder->part.width,
                           host->pixels);
        result = png_row(host);
    }
    return result;
}

static int png_frame_end(struct hal_display *display)
{
    struct host_display *host = (struct host_display *)display;
    int result = png_deflate(host, NULL, 0, Z_FINISH);
    host->count++;
    return result;
}

const struct hal_display_ops png_display = {png_open, png_frame_begin, png_flush, png_frame_end, png_close};
