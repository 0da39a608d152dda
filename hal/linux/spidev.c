/* SPDX-License-Identifier: MIT */
#include "linux/spidev.h"
#include "display.h"
#include "linux/kernel.h"

#include <errno.h>
#include <linux/spi/spidev.h>
#include <string.h>

#define BUFSIZ_PATH  "/sys/module/spidev/parameters/bufsiz"
#define BUFSIZ_LEAST 32u   /* no kernel takes less at a time */
#define BUFSIZ_USUAL 4096u /* what the module has if nobody says otherwise */

static int spidev_no(struct spidev *spi, int reason, struct problem *problem)
{
    const char *hint = "";
    if (reason == -ENOENT || reason == -ENXIO || reason == -ENODEV)
        hint = "; is SPI on (raspi-config, or dtparam=spi=on), and the module spidev there?";
    else if (reason == -EACCES || reason == -EPERM)
        hint = "; it wants root, or the group that owns it (spi)";
    spidev_close(spi);
    return problem_set(problem, "%s: %s%s", spi->path, strerror(-reason), hint);
}

int spidev_open(struct spidev *spi, const char *path, unsigned mode, uint32_t speed, struct problem *problem)
{
    uint8_t mode_bits = (uint8_t)mode, bits = 8;
    long size = kernel_number(BUFSIZ_PATH);
    *spi = (struct spidev){.path = path, .speed = speed, .chunk = size > 0 ? (uint32_t)size : BUFSIZ_USUAL};
    spi->descriptor = kernel_open(path);
    int result = spi->descriptor < 0 ? spi->descriptor : 0;
    if (result)
        return spidev_no(spi, result, problem);
    result = kernel_ioctl(spi->descriptor, SPI_IOC_WR_MODE, &mode_bits);
    if (result < 0) {
        spidev_close(spi);
        return problem_set(problem, "%s: SPI mode %u: %s", path, mode, strerror(-result));
    }
    result = kernel_ioctl(spi->descriptor, SPI_IOC_WR_BITS_PER_WORD, &bits);
    if (result >= 0)
        result = kernel_ioctl(spi->descriptor, SPI_IOC_WR_MAX_SPEED_HZ, &speed);
    return result < 0 ? spidev_no(spi, result, problem) : 0;
}

/* What the module took at load can be less than it says now: then the pieces are halved. */
int spidev_send(struct spidev *spi, const uint8_t *bytes, uint32_t count, struct problem *problem)
{
    while (count) {
        uint32_t length = count < spi->chunk ? count : spi->chunk;
        struct spi_ioc_transfer transfer = {
            .tx_buf = (uintptr_t)bytes, .len = length, .speed_hz = spi->speed, .bits_per_word = 8};
        int result = kernel_ioctl(spi->descriptor, SPI_IOC_MESSAGE(1), &transfer);
        if (result == -EMSGSIZE && length > BUFSIZ_LEAST) {
            spi->chunk = length / 2;
            continue;
        }
        if (result < 0)
            return problem_set(problem, "%s: %u bytes: %s", spi->path, (unsigned)length, strerror(-result));
        bytes += length;
        count -= length;
    }
    return 0;
}

void spidev_close(struct spidev *spi)
{
    if (spi->descriptor >= 0)
        kernel_close(spi->descriptor);
    spi->descriptor = -1;
}
