# SPDX-License-Identifier: MIT
MICROBIT_HAL := hal/cortexm/start.c hal/cortexm/mem.c hal/cortexm/semihost.c
MICROBIT_LINK := boards/microbit/link.ld
QEMU_m0 := -M microbit
