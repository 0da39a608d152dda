/* SPDX-License-Identifier: MIT */
/* glint-device over libgpiod 1. */
#include "gpiod_v1/gpiod.h"

#include "hal/linux/gpio_v1.c"

#include "linux_pairs.h"
