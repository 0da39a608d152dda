/* SPDX-License-Identifier: MIT */
/* The system calls that spidev takes, apart so that a test can be the kernel. Each returns a negative errno. */
#ifndef HAL_LINUX_KERNEL_H
#define HAL_LINUX_KERNEL_H

int kernel_open(const char *path); /* for reading and writing: a descriptor */
int kernel_ioctl(int descriptor, unsigned long request, void *argument);
void kernel_close(int descriptor);

/* The whole number that a file begins with. */
long kernel_number(const char *path);

#endif
