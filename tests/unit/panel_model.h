/* SPDX-License-Identifier: MIT */
/*
 * Four panels as their data sheets describe them, at the end of a bus: bytes and the D/C level come in, and what an eye
 * sees on the glass comes out. Nothing here knows of hal/panels/. A byte that the controller would not take, or takes
 * too early, is counted in `faults`.
 */
#ifndef PANEL_MODEL_H
#define PANEL_MODEL_H

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum model_kind { MODEL_ST7789, MODEL_ILI9341, MODEL_SSD1351, MODEL_SSD0323 };

struct model {
    enum model_kind kind;
    uint64_t now, ready; /* us: the time, and when the next command may come */
    uint8_t command, argument[16];
    unsigned count;   /* arguments so far */
    unsigned expects; /* arguments of an SSD0323's command still to come */
    int faults, first_fault;
    int asleep, on, inverted, locked, tearing, reset_low, backlight;
    uint8_t orient, format, gates;     /* MADCTL or remap; COLMOD; the ILI9341's B6, second argument */
    unsigned column[2], row[2], at[2]; /* the window and the place in it: column, row */
    int half;                          /* a pixel's first byte has come */
    uint8_t high;                      /* it */
    uint32_t bytes;                    /* all that came */
    uint32_t windows;                  /* times a window was set */
    uint16_t memory[320][240];         /* as pixels were written, before the glass */
};

static void model_reset(struct model *m)
{
    int dcs = m->kind <= MODEL_ILI9341;
    m->asleep = dcs, m->on = 0, m->inverted = 0, m->locked = m->kind == MODEL_SSD1351, m->tearing = 0;
    m->orient = 0, m->format = 0x66, m->gates = 0x82, m->half = 0, m->expects = 0, m->command = 0, m->count = 0;
    m->column[0] = m->row[0] = m->at[0] = m->at[1] = 0;
    m->column[1] = dcs ? 239 : m->kind == MODEL_SSD1351 ? 127 : 63;
    m->row[1] = dcs ? 319 : m->kind == MODEL_SSD1351 ? 127 : 79;
}

static void model_fault(struct model *m, int line)
{
    if (!m->faults++)
        m->first_fault = line;
}
#define MODEL_CHECK(m, good) ((good) ? (void)0 : model_fault(m, __LINE__))

/* Moves on inside the window; `down` counts rows first. */
static void model_step(struct model *m, int down)
{
    unsigned *inner = down ? m->row : m->column, *outer = down ? m->column : m->row;
    unsigned *i = &m->at[down], *o = &m->at[!down];
    if (++*i > inner[1]) {
        *i = inner[0];
        if (++*o > outer[1])
            *o = outer[0];
    }
}

/* A pixel of an ST7789 or ILI9341: MADCTL decides at writing where in the memory it goes. */
static void model_dcs_pixel(struct model *m, uint16_t pixel)
{
    unsigned column = m->at[0], row = m->at[1];
    model_step(m, 0);
    if (m->orient & 0x20) {
        unsigned t = column;
        column = row, row = t;
    }
    if (column >= 240 || row >= 320) {
        model_fault(m, __LINE__);
        return;
    }
    if (m->orient & 0x40)
        column = 239 - column;
    if (m->orient & 0x80)
        row = 319 - row;
    m->memory[row][column] = pixel;
}

static void model_dcs(struct model *m, int data, uint8_t byte)
{
    if (!data) {
        MODEL_CHECK(m, m->now >= m->ready);
        m->command = byte, m->count = 0, m->half = 0;
        switch (byte) {
        case 0x01:
            model_reset(m);
            m->ready = m->now + 120000; /* before sleep out; 5 ms for the rest */
            break;
        case 0x10:
        case 0x11:
            m->asleep = byte == 0x10;
            m->ready = m->now + 5000;
            break;
        case 0x20:
        case 0x21:
            m->inverted = byte & 1;
            break;
        case 0x28:
        case 0x29:
            m->on = byte & 1;
            break;
        case 0x2C:
            m->at[0] = m->column[0], m->at[1] = m->row[0];
            break;
        }
        return;
    }
    if (m->command == 0x2C) {
        MODEL_CHECK(m, (m->format & 7) == 5);
        if (m->half)
            model_dcs_pixel(m, (uint16_t)(m->high << 8 | byte));
        m->high = byte, m->half = !m->half;
        return;
    }
    if (m->count < sizeof m->argument)
        m->argument[m->count] = byte;
    m->count++;
    unsigned *range = m->command == 0x2A ? m->column : m->row;
    switch (m->command) {
    case 0x2A:
    case 0x2B:
        MODEL_CHECK(m, m->count <= 4);
        if (m->count == 4) {
            range[0] = (unsigned)(m->argument[0] << 8 | m->argument[1]);
            range[1] = (unsigned)(m->argument[2] << 8 | m->argument[3]);
            /* Out of range is ignored by the chip: the limit depends on MV. */
            unsigned limit = (m->command == 0x2A) == !(m->orient & 0x20) ? 239 : 319;
            MODEL_CHECK(m, range[0] <= range[1] && range[1] <= limit);
            m->windows += m->command == 0x2B;
        }
        break;
    case 0x35:
        m->tearing = 1;
        break;
    case 0x36:
        m->orient = byte;
        break;
    case 0x3A:
        m->format = byte;
        break;
    case 0xB6:
        if (m->kind == MODEL_ILI9341 && m->count == 2)
            m->gates = byte;
        break;
    default:
        MODEL_CHECK(m, m->command >= 0xB0 || m->command == 0x26); /* the makers' registers */
    }
}

static void model_ssd1351_command(struct model *m)
{
    static const uint8_t locked[] = {0xA2, 0xB1, 0xB3, 0xBB, 0xBE, 0xC1};
    MODEL_CHECK(m, !m->locked || !memchr(locked, m->command, sizeof locked));
    switch (m->command) {
    case 0x5C:
        m->at[0] = m->column[0], m->at[1] = m->row[0];
        break;
    case 0xA6:
    case 0xA7:
        m->inverted = m->command & 1;
        break;
    case 0xAE:
    case 0xAF:
        m->on = m->command & 1;
        break;
    }
}

static void model_ssd1351_argument(struct model *m, uint8_t byte)
{
    unsigned *range = m->command == 0x15 ? m->column : m->row;
    switch (m->command) {
    case 0x15:
    case 0x75:
        MODEL_CHECK(m, m->count <= 2 && byte < 128 && (m->count != 2 || byte >= range[0]));
        range[m->count - 1] = byte;
        m->windows += m->count == 2 && m->command == 0x75;
        break;
    case 0xFD:
        m->locked = byte == 0xB0 ? 1 : byte == 0xB1 ? 0 : m->locked;
        break;
    case 0xA0:
        MODEL_CHECK(m, (byte & 0xE0) == 0x60); /* 65k colours, odd and even lines split */
        m->orient = byte;
        break;
    case 0xA1:
        MODEL_CHECK(m, byte == 0);
        break;
    case 0xCA:
        MODEL_CHECK(m, byte == 127);
        break;
    }
}

static void model_ssd1351(struct model *m, int data, uint8_t byte)
{
    if (!data) {
        m->command = byte, m->count = 0, m->half = 0;
        model_ssd1351_command(m);
    } else if (m->command != 0x5C) {
        m->count++;
        model_ssd1351_argument(m, byte);
    } else if (!m->half) {
        m->high = byte, m->half = 1;
    } else {
        unsigned column = m->orient & 0x02 ? 127 - m->at[0] : m->at[0];
        m->memory[m->at[1] & 127][column & 127] = (uint16_t)(m->high << 8 | byte);
        model_step(m, m->orient & 1);
        m->half = 0;
    }
}

static unsigned model_ssd0323_arguments(uint8_t command)
{
    static const uint8_t one[] = {0x81, 0xA0, 0xA1, 0xA2, 0xA8, 0xAD, 0xB0, 0xB1, 0xB2, 0xB3, 0xB4, 0xBC, 0xBE, 0xBF};
    return command == 0xB8 ? 8 : command == 0x15 || command == 0x75 ? 2 : memchr(one, command, sizeof one) ? 1 : 0;
}

static void model_ssd0323(struct model *m, int data, uint8_t byte)
{
    if (data) {
        MODEL_CHECK(m, !m->expects);
        unsigned column = m->at[0], row = m->at[1];
        m->memory[row][column * 2] = byte >> 4;
        m->memory[row][column * 2 + 1] = byte & 15;
        model_step(m, m->orient >> 2 & 1);
        return;
    }
    if (!m->expects) {
        m->command = byte, m->count = 0;
        m->expects = model_ssd0323_arguments(byte);
        if (byte == 0xA4 || byte == 0xA7)
            m->inverted = byte == 0xA7;
        else if (byte == 0xAE || byte == 0xAF)
            m->on = byte & 1;
        else
            MODEL_CHECK(m, m->expects || (byte >= 0x84 && byte <= 0x86));
        return;
    }
    m->expects--, m->count++;
    unsigned *range = m->command == 0x15 ? m->column : m->row, i = m->count - 1;
    if (m->command == 0x15 || m->command == 0x75) {
        MODEL_CHECK(m, byte < (m->command == 0x15 ? 64 : 80) && (i == 0 || byte >= range[0]));
        range[i] = byte;
        m->at[m->command == 0x75] = range[0];
        m->windows += i && m->command == 0x75;
    } else if (m->command == 0xA0) {
        /* As the 128x64 glass is wired: lines interleaved and from below, high nibble left. */
        MODEL_CHECK(m, (byte & ~0x04) == 0x52);
        m->orient = byte;
    } else if (m->command == 0xA8) {
        MODEL_CHECK(m, byte == 63);
    } else if (m->command == 0xA1) {
        MODEL_CHECK(m, byte == 0);
    }
}

static void model_byte(struct model *m, int data, uint8_t byte)
{
    m->bytes++;
    MODEL_CHECK(m, !m->reset_low);
    if (m->kind <= MODEL_ILI9341)
        model_dcs(m, data, byte);
    else if (m->kind == MODEL_SSD1351)
        model_ssd1351(m, data, byte);
    else
        model_ssd0323(m, data, byte);
}

static uint16_t model_swapped(uint16_t pixel)
{
    return (uint16_t)(pixel << 11 | (pixel & 0x07E0) | pixel >> 11);
}

/* What is seen at column x, row y of the memory's glass: red in the upper bits. `bgr` and `dark`: a module with its
 * colours exchanged, or its inversion the other way, than the usual. A dark panel shows 0. */
static uint16_t model_seen(const struct model *m, unsigned x, unsigned y, int bgr, int dark)
{
    if (!m->on || m->asleep)
        return 0;
    int blue_first = 0, complement = m->inverted != dark;
    uint16_t pixel;
    switch (m->kind) {
    case MODEL_ST7789: /* normally white: inversion shows colours as they are */
        pixel = m->memory[y][x];
        blue_first = m->orient >> 3 & 1;
        complement = !complement;
        break;
    case MODEL_ILI9341: /* gates from below, sources blue first */
        pixel = m->memory[m->gates & 0x40 ? y : 319 - y][x];
        blue_first = !(m->orient >> 3 & 1);
        break;
    case MODEL_SSD1351:
        pixel = m->memory[m->orient & 0x10 ? y : 127 - y][x];
        blue_first = !(m->orient >> 2 & 1);
        break;
    default:
        pixel = m->memory[y][x];
        return (uint16_t)(complement ? 15 - pixel : pixel);
    }
    if (blue_first != bgr)
        pixel = model_swapped(pixel);
    return complement ? (uint16_t)~pixel : pixel;
}

#endif
