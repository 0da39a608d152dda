/* SPDX-License-Identifier: MIT */
/*
 * Texas Instruments (Luminary Micro) LM3S6965 and its like: Cortex-M3 at 50 MHz, no DMA. Registers as in the data sheet
 * DS-LM3S6965. The bases name the blocks; which pins a board uses is the board's.
 */
#ifndef HAL_LM3S_H
#define HAL_LM3S_H

#include "bus.h"

#define LM3S_REGISTER(base, offset) (*(volatile uint32_t *)((base) + (offset)))

#define LM3S_GPIOA  0x40004000u
#define LM3S_GPIOC  0x40006000u
#define LM3S_GPIOD  0x40007000u
#define LM3S_GPIOE  0x40024000u
#define LM3S_GPIOF  0x40025000u
#define LM3S_SSI0   0x40008000u
#define LM3S_UART0  0x4000C000u
#define LM3S_SYSTEM 0x400FE000u

#define LM3S_HZ 50000000u

/* Interrupts: vectors.c has what serves them. All have the same priority, so none interrupts another. */
#define LM3S_IRQ_UART0 5
#define LM3S_IRQ_SSI0  7
static inline void lm3s_interrupt_enable(unsigned irq)
{
    LM3S_REGISTER(0xE000E100u, 0) = 1u << irq;
}
void lm3s_ssi_interrupt(void);

/* Pins of one port. */
struct lm3s_pins {
    uint32_t port; /* LM3S_GPIO... */
    uint32_t mask;
};

/* The CPU to LM3S_HZ from a crystal of 8 MHz, SSI0 and the ports on, and time running. First of all. */
void lm3s_clock_start(void);

/* Sleeps until an interrupt unless the word is 0. An interrupt that makes it so cannot come between look and sleep: a
 * masked one wakes too. */
static inline void lm3s_sleep_while(const volatile uint32_t *word)
{
    __asm volatile("cpsid i" ::: "memory");
    if (*word)
        __asm volatile("wfi");
    __asm volatile("cpsie i" ::: "memory");
}

/* Their levels: the data register's address masks the pins (data sheet 8.2.1.2). */
static inline void lm3s_pins_write(struct lm3s_pins pins, int high)
{
    LM3S_REGISTER(pins.port, pins.mask << 2) = high ? pins.mask : 0;
}
static inline uint32_t lm3s_pins_read(struct lm3s_pins pins)
{
    return LM3S_REGISTER(pins.port, pins.mask << 2);
}

void lm3s_pins_output(struct lm3s_pins, int high);
void lm3s_pins_pulled_up(struct lm3s_pins);
/* Given to the block that the data sheet's table 8-1 names for them. */
void lm3s_pins_alternate(struct lm3s_pins);

/* UART0 at 115200 baud, 8 bits, no parity, on PA0 and PA1; uart_awake() starts it if nobody did. */
void lm3s_uart_start(void);

/* SSI0 as a bus, on PA2 (clock), PA3 (chip select, by the block) and PA5 (data out); `dc` is the board's D/C pin. */
struct lm3s_bus {
    struct hal_bus bus;
    struct lm3s_pins dc;
};
/* `divider` is even, 2..254, and `rate` 0..255: LM3S_HZ / (divider (1 + rate)) bits a second. */
void lm3s_bus_start(struct lm3s_bus *, struct lm3s_pins dc, uint8_t divider, uint8_t rate);

/* Keys to ground, one a button; a list of them ends with an empty mask. input_buttons() reads lm3s_keys, which is the
 * board's. */
struct lm3s_key {
    struct lm3s_pins pin;
    uint32_t button; /* enum hal_button */
};
extern const struct lm3s_key lm3s_keys[];
void lm3s_keys_start(void);

#endif
