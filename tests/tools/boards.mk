# SPDX-License-Identifier: MIT
# The program in firmware/app for a board: build/<board>/app.elf. boards/<board>/board.mk gives CPU_, HAL_ (sources),
# SCENES_ and how it is run, here QEMU_. Objects are a board's own.
BOARDS := lm3s6965evb
include $(BOARDS:%=boards/%/board.mk)
APP_SRC := $(wildcard firmware/app/*.c)

define board_rules
$(call cpu_rules,$(1))
$(SCENE_DIR)/$(1)_list.c: tests/tools/scene_list.sh boards/$(1)/board.mk
	@mkdir -p $$(@D)
	$$(Q)tests/tools/scene_list.sh $$(SCENES_$(1)) >$$@
$(BUILD)/$(1)/app.elf: $$(patsubst %.c,$(BUILD)/$(1)/%.o,$$(APP_SRC) $$(HAL_$(1)) $$(SCENE_DIR)/$(1)_list.c \
		$$(SCENES_$(1):%=$$(SCENE_DIR)/%.c)) $$(ARM_OBJ_$(1)) boards/$(1)/link.ld boards/cortexm.ld
	$$(call say,LINK,$$@)
	$$(Q)$$(ARM)gcc $$(CPU_$(1)) $$(ARM_LINK) -T boards/$(1)/link.ld -Wl,-Map=$$(@:.elf=.map) $$(filter %.o,$$^) -lgcc -o $$@
endef
$(foreach b,$(BOARDS),$(eval $(call board_rules,$(b))))

# With a screen in QEMU's window; else three seconds, and then a picture of what the panel shows.
BOARD_ELF := $(BUILD)/$(BOARD)/app.elf
board-image: $(if $(filter $(BOARD),$(BOARDS)),$(BOARD_ELF))
	@[ -n "$(filter $(BOARD),$(BOARDS))" ] || { echo "give BOARD=, one of: $(BOARDS)" >&2; exit 2; }
	@$(ARM)size $(BOARD_ELF)

board-run: board-image
	@if [ -n "$$DISPLAY$$WAYLAND_DISPLAY" ]; then \
		echo "the board's keys: arrows, and Ctrl for A"; qemu-system-arm $(QEMU_$(BOARD)) -serial stdio -kernel $(BOARD_ELF); \
	else python3 tests/device/oled.py $(BOARD_ELF) $(BUILD)/$(BOARD)/screen.png; fi

.PHONY: board-image board-run
