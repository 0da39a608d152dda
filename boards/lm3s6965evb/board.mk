# SPDX-License-Identifier: MIT
CPU_lm3s6965evb := -mcpu=cortex-m3
QEMU_lm3s6965evb := -M lm3s6965evb
HAL_lm3s6965evb := $(CORTEXM_HAL) hal/cortexm/uart.c $(wildcard hal/lm3s/*.c hal/panels/*.c boards/lm3s6965evb/*.c)
SCENES_lm3s6965evb := demo torus288 torus800 sphere690 bulb pawn zigzag teapot896
FORMATS_lm3s6965evb := grey4,dither
FLASH_lm3s6965evb := hal/lm3s/flash.sh
