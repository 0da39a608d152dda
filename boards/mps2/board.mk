# SPDX-License-Identifier: MIT
MPS2_HAL := $(CORTEXM_HAL) hal/cortexm/semihost.c hal/cortexm/systick.c
MPS2_LINK := boards/mps2/link.ld
QEMU_m0plus := -M mps2-an385
QEMU_m3 := -M mps2-an385
QEMU_m4 := -M mps2-an386
QEMU_m7 := -M mps2-an500
