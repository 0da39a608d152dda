# SPDX-License-Identifier: MIT
MICROBIT_HAL := $(CORTEXM_HAL) hal/cortexm/semihost.c
MICROBIT_LINK := boards/microbit/link.ld
QEMU_m0 := -M microbit
