/* SPDX-License-Identifier: MIT */
/* glint-device over libgpiod 2. */
#include "gpiod_v2/gpiod.h"

#include "hal/linux/gpio_v2.c"

#include "linux_pairs.h"
