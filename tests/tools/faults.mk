# SPDX-License-Identifier: MIT
# tests/device/faults.c for every board: build/<board>/faults.elf.
FAULTS_C := tests/device/faults.c tests/device/program.c firmware/app/crash.c firmware/app/text.c
$(foreach b,$(BOARDS),$(eval $(call board_program,$(b),faults,$(FAULTS_C))))
