# SPDX-License-Identifier: MIT
include hal/rp2040/rp2040.mk
PICOSYSTEM_HAL := $(RP2040_HAL) $(wildcard hal/panels/*.c) boards/picosystem/board.c
PICOSYSTEM_LINK := boards/picosystem/link.ld
