/* SPDX-License-Identifier: MIT */
/* SSI0 (data sheet 13, Arm's PL022) as a panel's bus: 8-bit frames, mode 2 as Luminary's driver of this panel has it.
 * There is no DMA: the CPU feeds the FIFO of 8, so nothing is under way when a call returns. */
#include "display.h"
#include "lm3s/lm3s.h"

#include <stddef.h>

#define SSI_CONTROL0 LM3S_REGISTER(LM3S_SSI0, 0x000)
#define SSI_CONTROL1 LM3S_REGISTER(LM3S_SSI0, 0x004)
#define SSI_DATA     LM3S_REGISTER(LM3S_SSI0, 0x008)
#define SSI_STATUS   LM3S_REGISTER(LM3S_SSI0, 0x00C)
#define SSI_DIVIDER  LM3S_REGISTER(LM3S_SSI0, 0x010)

#define STATUS_NOT_FULL (1u << 1)
#define STATUS_RECEIVED (1u << 2)
#define STATUS_BUSY     (1u << 4)
#define CONTROL0_8BIT   7u
#define CONTROL0_MODE_2 (1u << 6)

static void ssi_put(uint8_t byte)
{
    while (!(SSI_STATUS & STATUS_NOT_FULL))
        ;
    SSI_DATA = byte;
    while (SSI_STATUS & STATUS_RECEIVED) /* nobody sends: what is received is dropped */
        (void)SSI_DATA;
}

/* D/C is sampled with the last bit of a byte: it must not change before the byte is out. */
static int ssi_wait(struct hal_bus *bus)
{
    (void)bus;
    while (SSI_STATUS & STATUS_BUSY)
        ;
    return 0;
}

static int ssi_write(struct hal_bus *bus, enum hal_bus_kind kind, const uint8_t *bytes, uint32_t count)
{
    lm3s_pins_write(((struct lm3s_bus *)bus)->dc, kind == HAL_BUS_DATA);
    while (count--)
        ssi_put(*bytes++);
    return ssi_wait(bus);
}

static int ssi_pixels(struct hal_bus *bus, const void *pixels, unsigned word, uint32_t count, uint32_t rows,
                      uint32_t stride)
{
    const uint8_t *row = pixels;
    if (word != 1 && word != 2)
        return HAL_E_ARGUMENT;
    lm3s_pins_write(((struct lm3s_bus *)bus)->dc, 1);
    for (; rows; rows--, row += stride)
        for (uint32_t i = 0; i < count * word; i++)
            ssi_put(row[word == 2 ? i ^ 1 : i]); /* a little-endian word's high byte is its second */
    return ssi_wait(bus);
}

void lm3s_bus_start(struct lm3s_bus *bus, struct lm3s_pins dc, uint8_t divider, uint8_t rate)
{
    static const struct hal_bus_ops ops = {ssi_write, ssi_pixels, ssi_wait, NULL, NULL, NULL};
    bus->bus.ops = &ops;
    bus->dc = dc;
    lm3s_pins_output(dc, 1);
    lm3s_pins_alternate((struct lm3s_pins){LM3S_GPIOA, 1u << 2 | 1u << 3 | 1u << 5});
    SSI_CONTROL1 = 0;
    SSI_CONTROL0 = CONTROL0_8BIT | CONTROL0_MODE_2 | (uint32_t)rate << 8;
    SSI_DIVIDER = divider;
    SSI_CONTROL1 = 2; /* on, master */
}
