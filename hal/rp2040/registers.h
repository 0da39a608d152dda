/* SPDX-License-Identifier: MIT */
/* The registers used here, by the RP2040 datasheet's names and chapters. */
#ifndef HAL_RP2040_REGISTERS_H
#define HAL_RP2040_REGISTERS_H

#include <stdint.h>

#define REG(address)     (*(volatile uint32_t *)(uintptr_t)(address))
#define REG_SET(address) REG((address) + 0x2000u) /* 2.1.2: writes set or clear the bits that are 1 */
#define REG_CLR(address) REG((address) + 0x3000u)

/* 2.14 subsystem resets */
#define RESETS_RESET      0x4000C000u
#define RESETS_RESET_DONE 0x4000C008u
#define RESET_DMA         (1u << 2)
#define RESET_IO_BANK0    (1u << 5)
#define RESET_PADS_BANK0  (1u << 8)
#define RESET_PLL_SYS     (1u << 12)
#define RESET_PWM         (1u << 14)
#define RESET_SPI(spi)    (1u << (16 + (spi)))
#define RESET_TIMER       (1u << 21)
#define RESET_UART0       (1u << 22)

/* 2.15 clocks, 2.16 crystal, 2.18 PLL, 4.7 watchdog (its tick is the timer's) */
#define CLK_REF_CTRL     0x40008030u
#define CLK_REF_SELECTED 0x40008038u
#define CLK_SYS_CTRL     0x4000803Cu
#define CLK_SYS_DIV      0x40008040u
#define CLK_SYS_SELECTED 0x40008044u
#define CLK_PERI_CTRL    0x40008048u
#define CLK_SYS_RESUS    0x40008078u
#define XOSC_CTRL        0x40024000u
#define XOSC_STATUS      0x40024004u
#define XOSC_STARTUP     0x4002400Cu
#define PLL_SYS_CS       0x40028000u
#define PLL_SYS_PWR      0x40028004u
#define PLL_SYS_FBDIV    0x40028008u
#define PLL_SYS_PRIM     0x4002800Cu
#define WATCHDOG_TICK    0x4005802Cu

/* 2.19 pins: a control word and a pad each */
#define IO_CTRL(pin)  (0x40014004u + 8u * (pin))
#define PAD(pin)      (0x4001C004u + 4u * (pin))
#define PAD_INPUT     0x40u
#define PAD_DRIVE_8MA 0x20u
#define PAD_DRIVE_4MA 0x10u
#define PAD_PULL_UP   0x08u
#define PAD_SCHMITT   0x02u
#define PAD_FAST      0x01u
enum pin_function { PIN_SPI = 1, PIN_UART = 2, PIN_PWM = 4, PIN_SIO = 5 };

/* 2.3.1 single-cycle IO */
#define SIO_GPIO_IN      0xD0000004u
#define SIO_GPIO_OUT_SET 0xD0000014u
#define SIO_GPIO_OUT_CLR 0xD0000018u
#define SIO_GPIO_OE_SET  0xD0000024u

/* 2.5 DMA, channel 0 */
#define DMA_READ         0x50000000u
#define DMA_WRITE        0x50000004u
#define DMA_COUNT        0x50000008u
#define DMA_CTRL         0x5000000Cu /* writing it starts the channel */
#define DMA_BUSY         (1u << 24)
#define DMA_READ_ON      (1u << 4)
#define DMA_SIZE(log2)   ((uint32_t)(log2) << 2)
#define DMA_ENABLE       1u
#define DREQ_SPI_TX(spi) ((16u + 2 * (spi)) << 15)

/* 4.2 UART0, 4.4 SPI0 and SPI1 (PL011, PL022) */
#define UART_DR        0x40034000u
#define UART_FR        0x40034018u
#define UART_IBRD      0x40034024u
#define UART_FBRD      0x40034028u
#define UART_LCR       0x4003402Cu
#define UART_CR        0x40034030u
#define UART_FR_RXFE   (1u << 4)
#define UART_FR_TXFF   (1u << 5)
#define SPI_CR0(spi)   (0x4003C000u + 0x4000u * (spi))
#define SPI_CR1(spi)   (0x4003C004u + 0x4000u * (spi))
#define SPI_DR(spi)    (0x4003C008u + 0x4000u * (spi))
#define SPI_SR(spi)    (0x4003C00Cu + 0x4000u * (spi))
#define SPI_CPSR(spi)  (0x4003C010u + 0x4000u * (spi))
#define SPI_DMACR(spi) (0x4003C024u + 0x4000u * (spi))
#define SPI_SR_TNF     (1u << 1)
#define SPI_SR_BSY     (1u << 4)

/* 4.5 PWM: a slice for two pins, each with its half of the compare word */
#define PWM_CSR(slice) (0x40050000u + 0x14u * (slice))
#define PWM_CC(slice)  (0x4005000Cu + 0x14u * (slice))
#define PWM_TOP(slice) (0x40050010u + 0x14u * (slice))

/* 4.6 timer */
#define TIMER_ALARM0  0x40054010u
#define TIMER_ARMED   0x40054020u
#define TIMER_RAW_LOW 0x40054028u
#define TIMER_INTR    0x40054034u
#define TIMER_INTE    0x40054038u

/* 2.4 the core: interrupts (TIMER_IRQ_0 is number 0), vectors */
#define NVIC_ENABLE 0xE000E100u
#define SCB_VTOR    0xE000ED08u

/* 4.10 the flash's serial interface, and its pads */
#define SSI_CTRLR0       0x18000000u
#define SSI_CTRLR1       0x18000004u
#define SSI_ENABLE       0x18000008u
#define SSI_SER          0x18000010u
#define SSI_BAUD         0x18000014u
#define SSI_SR           0x18000028u
#define SSI_DR           0x18000060u
#define SSI_SAMPLE_DELAY 0x180000F0u
#define SSI_SPI_CTRLR0   0x180000F4u
#define PAD_QSPI(line)   (0x40020004u + 4u * (line)) /* SCLK, SD0..3, SS */

#endif
