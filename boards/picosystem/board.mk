# SPDX-License-Identifier: MIT
include hal/rp2040/rp2040.mk
CPU_picosystem := -mcpu=cortex-m0plus
HAL_picosystem := $(RP2040_HAL) $(wildcard hal/panels/*.c) boards/picosystem/board.c
SCENES_picosystem := demo torus288 torus800 sphere690 bulb pawn zigzag teapot896 bench-torus4000
# The second stage stands before the program.
$(BUILD)/picosystem/app.elf: $(RP2040_BOOT2)
