# SPDX-License-Identifier: MIT
# A board of this chip, $(1): what boards.mk asks of a board.mk.
include hal/rp2040/rp2040.mk
RP2040_SCENES := demo spin-torus800 spin-teapot spin-pawns torus1000 torus288 sphere690 bulb teapot896 bench-torus4000
# A Cortex-M0+ takes more code than 64 KiB for all of them: these are there to be compared with, on the desktop.
RP2040_WITHOUT := color6 overveld-scan $(addprefix subdivide-,recursive centre regular highlight hybrid hybrid-x)
define rp2040_board
CPU_$(1) := -mcpu=cortex-m0plus
OBJ_$(1) := m0plus
HAL_$(1) := $(RP2040_HAL) boards/rp2040.c boards/$(1)/board.c
LINK_$(1) := boards/rp2040.ld
EXTRA_$(1) := $(RP2040_BOOT2)
IMAGE_$(1) := .uf2
RUN_$(1) = $$(rp2040_run)
SCENES_$(1) ?= $(RP2040_SCENES)
FORMATS_$(1) := rgb565
WITHOUT_$(1) := $(RP2040_WITHOUT)
FLASH_$(1) := hal/rp2040/flash.sh
endef
