/* SPDX-License-Identifier: MIT */
/* System clock (data sheet 6.3), and time by SysTick's interrupt every millisecond. */
#include "clock.h"
#include "lm3s/lm3s.h"

#define CLOCK_RIS   LM3S_REGISTER(LM3S_SYSTEM, 0x050)
#define CLOCK_RCC   LM3S_REGISTER(LM3S_SYSTEM, 0x060)
#define CLOCK_RCGC1 LM3S_REGISTER(LM3S_SYSTEM, 0x104)
#define CLOCK_RCGC2 LM3S_REGISTER(LM3S_SYSTEM, 0x108)

#define RIS_PLL_LOCKED (1u << 6)
#define RCC_MAIN_OFF   (1u << 0)
#define RCC_SOURCE     (3u << 4) /* 0: the crystal */
#define RCC_XTAL       (15u << 6)
#define RCC_XTAL_8MHZ  (14u << 6)
#define RCC_BYPASS     (1u << 11)
#define RCC_PLL_OFF    (3u << 12) /* PWRDN, OEN */
#define RCC_USE_DIV    (1u << 22)
#define RCC_DIV        (15u << 23)
#define RCC_DIV_4      (3u << 23) /* of the PLL's 200 MHz */

#define SYSTICK_CONTROL (*(volatile uint32_t *)0xE000E010u)
#define SYSTICK_RELOAD  (*(volatile uint32_t *)0xE000E014u)
#define SYSTICK_VALUE   (*(volatile uint32_t *)0xE000E018u)

#define SCB_ICSR    (*(volatile uint32_t *)0xE000ED04u)
#define ICSR_TICKED (1u << 26) /* SysTick's interrupt waits to be taken */

#define CLOCK_TICKS_MS (LM3S_HZ / 1000u)
#define CLOCK_TICKS_US (LM3S_HZ / 1000000u)

static volatile uint32_t clock_ms;

void start_systick(void);

void start_systick(void)
{
    clock_ms++;
}

void lm3s_clock_start(void)
{
    uint32_t rcc = (CLOCK_RCC | RCC_BYPASS) & ~RCC_USE_DIV;
    CLOCK_RCC = rcc;
    rcc = (rcc & ~(RCC_MAIN_OFF | RCC_SOURCE | RCC_XTAL | RCC_PLL_OFF)) | RCC_XTAL_8MHZ;
    CLOCK_RCC = rcc;
    rcc = (rcc & ~RCC_DIV) | RCC_DIV_4 | RCC_USE_DIV;
    CLOCK_RCC = rcc;
    /* .5 ms at most (data sheet 22.2.1): without a crystal it goes on at the oscillator's rate */
    for (uint32_t tries = 0; tries < 100000 && !(CLOCK_RIS & RIS_PLL_LOCKED); tries++)
        ;
    if (CLOCK_RIS & RIS_PLL_LOCKED)
        CLOCK_RCC = rcc & ~RCC_BYPASS;
    CLOCK_RCGC1 |= 1u << 4; /* SSI0 */
    CLOCK_RCGC2 |= 0x3fu;   /* ports A to F */
    (void)CLOCK_RCGC2;      /* three cycles until a block may be touched */
    (void)CLOCK_RCGC2;

    SYSTICK_RELOAD = CLOCK_TICKS_MS - 1;
    SYSTICK_VALUE = 0;
    SYSTICK_CONTROL = 7; /* on, the CPU's clock, interrupt */
}

/* The counter goes 0, 49999 ... 1, 0, and ticks where it reaches 0. A tick that is not yet counted, because interrupts
 * are masked or this is one, or in the few cycles until it is taken, is seen waiting: right for a millisecond of
 * masking. */
uint32_t clock_us(void)
{
    uint32_t ms, left, gone, ticked;
    do { /* until no tick was counted in between */
        ms = clock_ms;
        left = SYSTICK_VALUE;
        ticked = SCB_ICSR & ICSR_TICKED;
    } while (ms != clock_ms);
    gone = left ? CLOCK_TICKS_MS - left : 0;
    if (ticked && gone < CLOCK_TICKS_MS / 2) /* else the tick came after the counter was read */
        ms++;
    return ms * 1000u + gone / CLOCK_TICKS_US;
}

void clock_wait_us(uint32_t us)
{
    for (uint32_t begin = clock_us(); clock_us() - begin <= us;)
        ;
}

void clock_idle(void)
{
    __asm volatile("wfi" ::: "memory");
}
