# SPDX-License-Identifier: MIT
# The RP2040 board on npm's rp2040js, a program that others wrote; what stands on the panel's wires is compared.

PANEL_SCENES := demo torus288 torus800 torus1000 teapot896 sphere690 bench-torus4000
PANEL_C := tests/device/rp2040/panel.c firmware/app/share.c tests/device/program.c $(SCENE_DIR)/panel_list.c $(PANEL_SCENES:%=$(SCENE_DIR)/%.c)
PANEL_ELF := $(BUILD)/picosystem/panel.elf
RP2040JS := $(BUILD)/node

$(SCENE_DIR)/panel_list.c: tests/tools/scene_list.sh tests/tools/rp2040.mk
	@mkdir -p $(@D)
	$(Q)tests/tools/scene_list.sh $(PANEL_SCENES) >$@

$(PANEL_ELF): $(patsubst %.c,$(BUILD)/m0plus/%.o,$(PANEL_C) $(HAL_picosystem)) $(ARM_OBJ_m0plus) $(RP2040_BOOT2) \
		boards/picosystem/link.ld boards/rp2040.ld boards/cortexm.ld
	$(call say,LINK,$@)
	@mkdir -p $(@D)
	$(Q)$(ARM)gcc $(CPU_m0plus) $(ARM_LINK) -T boards/picosystem/link.ld -Wl,-Map=$(@:.elf=.map) $(filter %.o,$^) -lgcc -o $@

suite-rp2040: $(PANEL_ELF:.elf=.uf2) $(GLINT)
	@tests/tools/rp2040js.sh $(RP2040JS) && tests/tools/rp2040.sh $(GLINT) $(RP2040JS) $<

.PHONY: suite-rp2040
