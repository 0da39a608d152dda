# SPDX-License-Identifier: MIT
# tests/device/faults.c for the boards with a display: build/<board>/faults.elf.
FAULTS_C := tests/device/faults.c tests/device/program.c firmware/app/crash.c firmware/app/text.c

# $(1) board, $(2) CPU, where its objects are; $(3) what else is linked
define faults_rule
$(BUILD)/$(1)/faults.elf: $$(patsubst %.c,$(BUILD)/$(2)/%.o,$$(FAULTS_C) $$(HAL_$(1))) $(3) boards/$(1)/link.ld boards/cortexm.ld
	$$(call say,LINK,$$@)
	@mkdir -p $$(@D)
	$$(Q)$$(ARM)gcc $$(CPU_$(1)) $$(ARM_LINK) -T boards/$(1)/link.ld -Wl,-Map=$$(@:.elf=.map) $$(filter %.o,$$^) -lgcc -o $$@
endef
$(eval $(call faults_rule,lm3s6965evb,lm3s6965evb,))
$(eval $(call faults_rule,picosystem,m0plus,$(RP2040_BOOT2)))
