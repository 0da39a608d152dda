# SPDX-License-Identifier: MIT
# RP2040 boards on npm's rp2040js, a program that others wrote; what stands on the panel's wires is compared.
# `make run`: in a browser where there is a screen or SERVE=1, else SECONDS of the board's time with KEYS pressed (show.mjs).
PORT ?= 8123
SECONDS ?= 3
rp2040_run = tests/tools/rp2040js.sh $(RP2040JS) && export BOARD=$(BOARD) && node tests/device/rp2040/$(if \
	$(SERVE)$(DISPLAY)$(WAYLAND_DISPLAY),serve.mjs $(RP2040JS) $(BOARD_IMAGE) $(PORT),show.mjs $(RP2040JS) $(BOARD_IMAGE) \
	$(BUILD)/$(BOARD)/screen $(SECONDS) $(KEYS) && echo "$(BUILD)/$(BOARD)/screen.png: what it shows after $(SECONDS) s (live in a browser: SERVE=1)")

PANEL_SCENES := demo torus288 torus800 sphere690 bench-torus4000
PANEL_C := tests/device/rp2040/panel.c tests/device/program.c $(SCENE_DIR)/panel_list.c $(PANEL_SCENES:%=$(SCENE_DIR)/%.c)
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

RP2040_BOARDS := $(filter-out lm3s6965evb,$(BOARDS))
suite-rp2040: $(PANEL_ELF:.elf=.uf2) $(GLINT) $(RP2040_BOARDS:%=$(BUILD)/%/app.uf2) $(BUILD)/picosystem/faults.uf2
	@tests/tools/rp2040js.sh $(RP2040JS) && status=0; \
	MAKE="$(MAKE)" tests/tools/rp2040.sh $(GLINT) $(RP2040JS) $< || status=1; \
	python3 tests/device/test_faults.py $(RP2040JS) picosystem $(BUILD)/picosystem/faults.uf2 || status=1; \
	python3 tests/device/test_rp2040.py $(RP2040JS) $(GLINT) $(BUILD) || status=1; exit $$status

.PHONY: suite-rp2040
