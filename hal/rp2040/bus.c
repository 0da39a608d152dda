/* SPDX-License-Identifier: MIT */
/*
 * The SPI as a panel's bus. Pixels go out by DMA, 16-bit words as 16-bit frames: the high byte goes first without a
 * swap. What a panel answers is not wired, so the receiver overruns, and nobody reads it.
 */
#include "bus.h"
#include "clock.h"
#include "rp2040/registers.h"
#include "rp2040/rp2040.h"

#define CR0_BITS(bits) ((uint32_t)(bits)-1u)
#define CR1_ENABLE     2u
#define DMACR_TRANSMIT 2u
#define PWM_LEVELS     254u   /* the highest count, so that level 255 is always on */
#define TEARING_US     26000u /* a picture of the slowest usual rate, 39 Hz */

/* Which of the two: pins go by eights to SPI0 and SPI1 in turn (1.4.3). */
static uint32_t bus_spi(void)
{
    return rp2040_board.sck >> 3 & 1;
}

static void bus_frames(unsigned bits)
{
    uint32_t mode = rp2040_board.spi_mode == 3 ? 3u << 6 : 0;
    REG(SPI_CR1(bus_spi())) = 0;
    REG(SPI_CR0(bus_spi())) = CR0_BITS(bits) | mode;
    REG(SPI_CR1(bus_spi())) = CR1_ENABLE;
}

static int bus_wait(struct hal_bus *bus)
{
    (void)bus;
    while (REG(DMA_CTRL) & DMA_BUSY)
        ;
    while (REG(SPI_SR(bus_spi())) & SPI_SR_BSY)
        ;
    return 0;
}

static int bus_write(struct hal_bus *bus, enum hal_bus_kind kind, const uint8_t *bytes, uint32_t count)
{
    bus_wait(bus);
    bus_frames(8);
    rp2040_level(rp2040_board.dc, kind == HAL_BUS_DATA);
    for (uint32_t i = 0; i < count; i++) {
        while (!(REG(SPI_SR(bus_spi())) & SPI_SR_TNF))
            ;
        REG(SPI_DR(bus_spi())) = bytes[i];
    }
    return bus_wait(bus);
}

static void bus_dma(const void *from, unsigned word, uint32_t count)
{
    __asm volatile("" : : : "memory"); /* the pixels are written before they are sent */
    REG(DMA_READ) = (uint32_t)(uintptr_t)from;
    REG(DMA_WRITE) = SPI_DR(bus_spi());
    REG(DMA_COUNT) = count;
    REG(DMA_CTRL) =
        DREQ_SPI_TX(bus_spi()) | DMA_READ_ON | DMA_SIZE(word - 1) | DMA_ENABLE; /* chained to itself: to none */
}

static int bus_pixels(struct hal_bus *bus, const void *pixels, unsigned word, uint32_t count, uint32_t rows,
                      uint32_t stride)
{
    const uint8_t *row = pixels;
    bus_wait(bus);
    bus_frames(8 * word);
    rp2040_level(rp2040_board.dc, 1);
    if (stride == count * word) {
        count *= rows;
        rows = 1;
    }
    for (; count && rows; rows--, row += stride) {
        while (REG(DMA_CTRL) & DMA_BUSY)
            ;
        bus_dma(row, word, count);
    }
    return 0;
}

static void bus_reset(struct hal_bus *bus, int level)
{
    bus_wait(bus);
    if (rp2040_board.reset != RP2040_NO_PIN)
        rp2040_level(rp2040_board.reset, level);
}

static void bus_backlight(struct hal_bus *bus, unsigned level)
{
    unsigned pin = rp2040_board.backlight;
    bus_wait(bus);
    if (pin != RP2040_NO_PIN)
        REG(PWM_CC(pin >> 1 & 7)) = level << (pin & 1 ? 16 : 0);
}

/* The signal's rising edge; a panel that gives none costs a picture's time. */
static void bus_tearing(struct hal_bus *bus)
{
    uint32_t begin = clock_us(), mask;
    bus_wait(bus);
    if (rp2040_board.tearing == RP2040_NO_PIN)
        return;
    mask = 1u << rp2040_board.tearing;
    while (REG(SIO_GPIO_IN) & mask && clock_us() - begin < TEARING_US)
        ;
    while (!(REG(SIO_GPIO_IN) & mask) && clock_us() - begin < TEARING_US)
        ;
}

static void bus_backlight_start(unsigned pin)
{
    unsigned slice = pin >> 1 & 7;
    REG(PWM_TOP(slice)) = PWM_LEVELS;
    REG(PWM_CC(slice)) = 0;
    REG(PWM_CSR(slice)) = 1;
    rp2040_pin(pin, PIN_PWM, PAD_DRIVE_4MA);
}

struct hal_bus *rp2040_bus(void)
{
    static const struct hal_bus_ops ops = {bus_write, bus_pixels, bus_wait, bus_reset, bus_backlight, bus_tearing};
    static struct hal_bus bus = {&ops};
    const struct rp2040_board *board = &rp2040_board;
    rp2040_reset(RESET_SPI(bus_spi()) | RESET_DMA | RESET_PWM);
    if (board->backlight != RP2040_NO_PIN)
        bus_backlight_start(board->backlight);
    if (board->reset != RP2040_NO_PIN)
        rp2040_output(board->reset, 1);
    if (board->tearing != RP2040_NO_PIN)
        rp2040_pin(board->tearing, PIN_SIO, PAD_INPUT | PAD_SCHMITT);
    rp2040_output(board->dc, 1);
    REG(SPI_CPSR(bus_spi())) = board->spi_divisor;
    REG(SPI_DMACR(bus_spi())) = DMACR_TRANSMIT;
    bus_frames(8);
    rp2040_pin(board->sck, PIN_SPI, PAD_DRIVE_8MA | PAD_FAST);
    rp2040_pin(board->mosi, PIN_SPI, PAD_DRIVE_8MA | PAD_FAST);
    if (board->cs != RP2040_NO_PIN)
        rp2040_output(board->cs, 0); /* nothing else is on this bus */
    return &bus;
}
