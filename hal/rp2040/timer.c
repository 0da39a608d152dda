/* SPDX-License-Identifier: MIT */
/* The timer counts microseconds; its first alarm wakes the core. */
#include "clock.h"
#include "rp2040/registers.h"
#include "rp2040/rp2040.h"

#define IDLE_US     2000u
#define SLEEP_MIN   50u /* us: less is waited for awake */
#define ALARM       1u
#define TIMER_IRQ_0 1u /* its bit in the NVIC */

void rp2040_timer_alarm(void)
{
    REG(TIMER_INTR) = ALARM;
}

void rp2040_timer_start(void)
{
    rp2040_reset(RESET_TIMER);
    REG(TIMER_INTE) = ALARM;
    REG(NVIC_ENABLE) = TIMER_IRQ_0;
}

uint32_t clock_us(void)
{
    return REG(TIMER_RAW_LOW);
}

/* An alarm that has passed by the time it is set would come in an hour; SLEEP_MIN keeps it ahead. One that rings before
 * the sleep begins is taken at once, and the sleep then lasts until the next: so interrupts wait until it has begun. */
static void timer_sleep(uint32_t us)
{
    __asm volatile("cpsid i" : : : "memory");
    REG(TIMER_ALARM0) = clock_us() + us;
    __asm volatile("wfi\n cpsie i" : : : "memory");
}

void clock_wait_us(uint32_t us)
{
    uint32_t begin = clock_us(), gone;
    while ((gone = clock_us() - begin) < us)
        if (us - gone > SLEEP_MIN)
            timer_sleep(us - gone);
}

void clock_idle(void)
{
    timer_sleep(IDLE_US);
}
