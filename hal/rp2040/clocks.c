/* SPDX-License-Identifier: MIT */
/* 12 MHz crystal -> PLL -> 125 MHz for the cores and the peripherals. */
#include "rp2040/registers.h"
#include "rp2040/rp2040.h"

#define CRYSTAL_MHZ  12u
#define XOSC_ENABLE  0xFABAA0u /* its range is 1 to 15 MHz */
#define XOSC_STABLE  (1u << 31)
#define XOSC_DELAY   47u /* 1 ms in units of 256 clocks */
#define PLL_LOCK     (1u << 31)
#define PLL_OFF      (1u << 0)
#define PLL_POST_OFF (1u << 3)
#define PLL_VCO_OFF  (1u << 5)
#define PLL_FEEDBACK 125u                  /* VCO 1500 MHz, of 750 to 1600 */
#define PLL_DIVIDERS (6u << 16 | 2u << 12) /* 1500 / 6 / 2 */
#define REF_CRYSTAL  2u
#define SYS_AUX      1u /* its auxiliary source 0 is the PLL */
#define PERI_ENABLE  (1u << 11)
#define TICK_ENABLE  (1u << 9)

void rp2040_reset(uint32_t subsystems)
{
    REG_SET(RESETS_RESET) = subsystems;
    REG_CLR(RESETS_RESET) = subsystems;
    while ((REG(RESETS_RESET_DONE) & subsystems) != subsystems)
        ;
}

static void clocks_select(uint32_t control, uint32_t selected, uint32_t source)
{
    REG(control) = source;
    while (!(REG(selected) & 1u << source))
        ;
}

void rp2040_clocks_start(void)
{
    REG(CLK_SYS_RESUS) = 0;
    REG(XOSC_STARTUP) = XOSC_DELAY;
    REG(XOSC_CTRL) = XOSC_ENABLE;
    while (!(REG(XOSC_STATUS) & XOSC_STABLE))
        ;
    /* Off the PLL before it is touched: a debugger may start the program without a reset. */
    clocks_select(CLK_SYS_CTRL, CLK_SYS_SELECTED, 0);
    clocks_select(CLK_REF_CTRL, CLK_REF_SELECTED, REF_CRYSTAL);

    rp2040_reset(RESET_PLL_SYS);
    REG(PLL_SYS_CS) = 1;
    REG(PLL_SYS_FBDIV) = PLL_FEEDBACK;
    REG_CLR(PLL_SYS_PWR) = PLL_OFF | PLL_VCO_OFF;
    while (!(REG(PLL_SYS_CS) & PLL_LOCK))
        ;
    REG(PLL_SYS_PRIM) = PLL_DIVIDERS;
    REG_CLR(PLL_SYS_PWR) = PLL_POST_OFF;

    REG(CLK_SYS_DIV) = 1u << 8;
    clocks_select(CLK_SYS_CTRL, CLK_SYS_SELECTED, SYS_AUX);
    REG(CLK_PERI_CTRL) = PERI_ENABLE;
    REG(WATCHDOG_TICK) = TICK_ENABLE | CRYSTAL_MHZ;
}

void rp2040_start(void)
{
    rp2040_clocks_start();
    rp2040_reset(RESET_IO_BANK0 | RESET_PADS_BANK0);
    rp2040_timer_start();
    rp2040_uart_start();
    rp2040_buttons_start();
}
