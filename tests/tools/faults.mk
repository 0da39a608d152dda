# SPDX-License-Identifier: MIT
# tests/device/faults.c for the boards with a display: build/<board>/faults.elf.
FAULTS_C := tests/device/faults.c tests/device/program.c firmware/app/crash.c firmware/app/text.c

define faults_rule
$(BUILD)/$(1)/faults.elf: $$(patsubst %.c,$(BUILD)/$$(OBJ_$(1))/%.o,$$(FAULTS_C) $$(HAL_$(1))) $$(EXTRA_$(1)) boards/$(1)/link.ld \
		$$(LINK_$(1)) boards/cortexm.ld
	$$(call say,LINK,$$@)
	@mkdir -p $$(@D)
	$$(Q)$$(ARM)gcc $$(CPU_$(1)) $$(ARM_LINK) -T boards/$(1)/link.ld -Wl,-Map=$$(@:.elf=.map) $$(filter %.o,$$^) -lgcc -o $$@
endef
$(foreach b,$(BOARDS),$(eval $(call faults_rule,$(b))))
