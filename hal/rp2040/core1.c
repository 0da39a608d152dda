/* SPDX-License-Identifier: MIT */
/*
 * The second core: started through the boot ROM (RP2040 datasheet 2.8.2), kept apart by the spinlocks, woken by events.
 * The cores have no caches: a barrier for the compiler and one for the bus is all it takes to be seen.
 */
#include "core.h"
#include "rp2040/registers.h"
#include "rp2040/rp2040.h"

extern uint32_t link_core1_stack_top[];

static struct {
    void (*job)(void *);
    void *argument;
} core1;

static void core1_barrier(void)
{
    __asm volatile("dmb" : : : "memory");
}

static void core1_notify(void)
{
    __asm volatile("dmb\n\tsev" : : : "memory");
}

static void core1_pause(void)
{
    __asm volatile("wfe" : : : "memory");
}

static int core1_claim(enum hal_lock lock)
{
    uint32_t got = REG(SIO_SPINLOCK(lock));
    core1_barrier();
    return got != 0;
}

static void core1_release(enum hal_lock lock)
{
    core1_barrier();
    REG(SIO_SPINLOCK(lock)) = 0;
}

static void core1_main(void)
{
    core1.job(core1.argument);
    for (;;)
        core1_pause();
}

void start_stack(void);

/* Of hal/cortexm/start.c: for a fault of either core. */
__attribute__((naked)) void start_stack(void)
{
    __asm volatile(".syntax unified\n"
                   "movs r3, #0xd0\n"
                   "lsls r3, r3, #24\n"
                   "ldr r3, [r3]\n" /* SIO_CPUID */
                   "cmp r3, #0\n"
                   "bne 1f\n"
                   "ldr r3, =link_stack_top\n"
                   "bx lr\n"
                   "1: ldr r3, =link_core1_stack_top\n"
                   "bx lr\n"
                   ".ltorg");
}

/* The ROM gives every word back; one that it did not expect begins the sequence anew. */
static uint32_t core1_exchange(uint32_t word)
{
    if (word == 0)
        while (REG(SIO_FIFO_ST) & FIFO_VALID)
            (void)REG(SIO_FIFO_READ);
    while (!(REG(SIO_FIFO_ST) & FIFO_READY))
        ;
    REG(SIO_FIFO_WRITE) = word;
    core1_notify();
    while (!(REG(SIO_FIFO_ST) & FIFO_VALID))
        core1_pause();
    return REG(SIO_FIFO_READ);
}

static void core1_start(void (*job)(void *), void *argument)
{
    const uint32_t words[] = {
        0, 0, 1, REG(SCB_VTOR), (uint32_t)(uintptr_t)link_core1_stack_top, (uint32_t)(uintptr_t)core1_main};
    core1.job = job;
    core1.argument = argument;
    for (unsigned i = 0; i < HAL_LOCKS; i++)
        core1_release((enum hal_lock)i); /* whatever ran before */
    /* into the ROM's wait: a debugger may start the program without a reset */
    REG_SET(PSM_FORCE_OFF) = PSM_PROC1;
    while (!(REG(PSM_FORCE_OFF) & PSM_PROC1))
        ;
    REG_CLR(PSM_FORCE_OFF) = PSM_PROC1;
    for (unsigned i = 0; i < sizeof words / sizeof words[0];)
        i = core1_exchange(words[i]) == words[i] ? i + 1 : 0;
}

const struct hal_core rp2040_core1 = {core1_start, core1_claim, core1_release, core1_pause, core1_notify};
