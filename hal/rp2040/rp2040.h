/* SPDX-License-Identifier: MIT */
/*
 * The RP2040 as machine.h, clock.h, input.h and bus.h ask for it: UART0, the timer, buttons, and an SPI with DMA
 * channel 0. The board says which pins.
 */
#ifndef HAL_RP2040_H
#define HAL_RP2040_H

#include "bus.h"

#include <stdint.h>

#define RP2040_NO_PIN 0xFFu

struct rp2040_button {
    uint8_t pin;    /* low while held */
    uint8_t button; /* enum hal_button */
};

struct rp2040_board {
    uint8_t uart_tx, uart_rx;
    uint8_t sck, mosi, dc;                 /* pins of one SPI (0 to 7 and 16 to 23: SPI0, the others SPI1), and any */
    uint8_t cs, reset, backlight, tearing; /* or RP2040_NO_PIN */
    uint8_t spi_mode;                      /* 0; 3 for modules without CS */
    uint8_t spi_divisor;                   /* of 125 MHz, even: 2 gives 62.5 MHz */
    const struct rp2040_button *buttons;
    uint8_t button_count;
};

/* Of the board that is linked. */
extern const struct rp2040_board rp2040_board;

/* Crystal, PLL, 125 MHz, timer, UART at 115,200 baud and button pins: first of all. */
void rp2040_start(void);

/* Makes the bus ready: lines idle, backlight off. */
struct hal_bus *rp2040_bus(void);

/* Parts, called by rp2040_start(). */
void rp2040_clocks_start(void);
void rp2040_uart_start(void);
void rp2040_timer_start(void);
void rp2040_buttons_start(void);

/* The timer's interrupt. */
void rp2040_timer_alarm(void);

/* Resets subsystems (RESET_ bits), whatever ran before, and lets them go. */
void rp2040_reset(uint32_t subsystems);
/* Gives a pin a function (enum pin_function) and its pad's bits. */
void rp2040_pin(unsigned pin, unsigned function, uint32_t pad);
/* Makes a pin an output at that level. */
void rp2040_output(unsigned pin, int level);
void rp2040_level(unsigned pin, int level);

#endif
