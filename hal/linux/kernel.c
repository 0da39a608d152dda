/* SPDX-License-Identifier: MIT */
#include "linux/kernel.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <sys/ioctl.h>
#include <unistd.h>

int kernel_open(const char *path)
{
    int descriptor = open(path, O_RDWR | O_CLOEXEC);
    return descriptor < 0 ? -errno : descriptor;
}

int kernel_ioctl(int descriptor, unsigned long request, void *argument)
{
    int result;
    do
        result = ioctl(descriptor, request, argument);
    while (result < 0 && errno == EINTR);
    return result < 0 ? -errno : result;
}

void kernel_close(int descriptor)
{
    close(descriptor);
}

long kernel_number(const char *path)
{
    char text[24] = "";
    int descriptor = open(path, O_RDONLY | O_CLOEXEC);
    ssize_t length = descriptor < 0 ? -1 : read(descriptor, text, sizeof text - 1);
    int reason = errno;
    if (descriptor >= 0)
        close(descriptor);
    return length < 0 ? -reason : strtol(text, NULL, 10);
}
