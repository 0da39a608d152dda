/* SPDX-License-Identifier: MIT */
/*
 * The second stage of the boot (RP2040 datasheet 2.8.1.3): the ROM copies the flash's first 256 bytes to the end of
 * RAM, checks their CRC and enters them. They make the flash readable at 0x10000000, four bits a clock (4.10: XIP), and
 * go on to the program behind them. For the W25Q family, in which fast read quad I/O (EB) is without command after a
 * mode byte of A0. One function, without data: it must be where it was linked or anywhere else, in 252 bytes.
 */
#include "rp2040/registers.h"

#define SSI(name)      ssi[(SSI_##name - SSI_CTRLR0) / 4]
#define VECTORS        0x10000100u
#define BAUD           4u /* 125 MHz / 4: any pull of the pads and any flash of the family does */
#define SR_EMPTY       (1u << 2)
#define SR_BUSY        (1u << 0)
#define STATUS1_BUSY   1u
#define STATUS2_QUAD   2u
#define CTRLR0_BYTE    (7u << 16)                        /* frames of 8 bits, both ways */
#define CTRLR0_QUAD    (2u << 21 | 31u << 16 | 3u << 8)  /* 4 lines, 32 bits, command then read */
#define READ_QUAD_IO   (4u << 11 | 8u << 2)              /* 4 clocks idle, 8 nibbles of address and mode */
#define WITH_COMMAND   (READ_QUAD_IO | 2u << 8 | 1u)     /* 8 bits on one line, the address on four */
#define WITHOUT        (READ_QUAD_IO | 0xA0u << 24 | 2u) /* the mode byte closes each address */
#define READ_EB        0xEBu
#define MODE_CONTINUES 0xA0u

enum flash_command { WRITE_STATUS = 0x01, READ_STATUS1 = 0x05, WRITE_ENABLE = 0x06, READ_STATUS2 = 0x35 };

_Noreturn void boot2_start(void);

#define INLINE static inline __attribute__((always_inline))

/* The base of a block of registers, hidden from the compiler: addresses of their own would take 4 bytes each. */
INLINE volatile uint32_t *boot2_base(uint32_t address)
{
    __asm("" : "+l"(address));
    return (volatile uint32_t *)(uintptr_t)address;
}

INLINE void boot2_sent(volatile uint32_t *ssi)
{
    while ((SSI(SR) & (SR_EMPTY | SR_BUSY)) != SR_EMPTY)
        ;
}

/* Sends a command and `count` zero bytes, of which the last answer is returned. */
INLINE uint32_t boot2_command(volatile uint32_t *ssi, enum flash_command command, unsigned count)
{
    SSI(DR) = command;
    for (unsigned i = 0; i < count; i++)
        SSI(DR) = 0;
    boot2_sent(ssi);
    uint32_t answer = SSI(DR);
    for (unsigned i = 0; i < count; i++)
        answer = SSI(DR);
    return answer;
}

/* The quad-enable bit is kept without power: it is written once in a flash's life. */
INLINE void boot2_quad_enable(volatile uint32_t *ssi)
{
    if (boot2_command(ssi, READ_STATUS2, 1) & STATUS2_QUAD)
        return;
    boot2_command(ssi, WRITE_ENABLE, 0);
    SSI(DR) = WRITE_STATUS;
    SSI(DR) = 0;
    SSI(DR) = STATUS2_QUAD;
    boot2_sent(ssi);
    for (int i = 0; i < 3; i++)
        (void)SSI(DR);
    while (boot2_command(ssi, READ_STATUS1, 1) & STATUS1_BUSY)
        ;
}

__attribute__((section(".boot2"), used)) _Noreturn void boot2_start(void)
{
    volatile uint32_t *ssi = boot2_base(SSI_CTRLR0), *pads = boot2_base(PAD_QSPI(0));
    pads[0] = PAD_DRIVE_8MA | PAD_FAST;
    for (unsigned line = 1; line <= 4; line++)
        pads[line] = PAD_INPUT | PAD_DRIVE_4MA; /* no Schmitt trigger: less delay */
    SSI(ENABLE) = 0;
    SSI(BAUD) = BAUD;
    SSI(SAMPLE_DELAY) = 1;
    SSI(CTRLR0) = CTRLR0_BYTE;
    SSI(ENABLE) = 1;
    boot2_quad_enable(ssi);

    SSI(ENABLE) = 0;
    SSI(CTRLR0) = CTRLR0_QUAD;
    SSI(CTRLR1) = 0;
    SSI(SPI_CTRLR0) = WITH_COMMAND;
    SSI(ENABLE) = 1;
    SSI(DR) = READ_EB;
    SSI(DR) = MODE_CONTINUES;
    boot2_sent(ssi);
    SSI(ENABLE) = 0;
    SSI(SPI_CTRLR0) = WITHOUT;
    SSI(ENABLE) = 1;

    volatile uint32_t *vectors = boot2_base(VECTORS);
    REG(SCB_VTOR) = VECTORS;
    __asm volatile("msr msp, %0\n bx %1" : : "r"(vectors[0]), "r"(vectors[1]));
    __builtin_unreachable();
}
