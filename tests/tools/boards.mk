# SPDX-License-Identifier: MIT
# The program in firmware/app for a board: build/<board>/app.elf. boards/<board>/board.mk gives, as in boards/README.md,
# CPU_ HAL_ (sources) SCENES_, and where they differ from what stands below OBJ_ LINK_ EXTRA_ IMAGE_ RUN_ FLASH_.
BOARDS := lm3s6965evb picosystem pico-st7789 pico-display2
include boards/rp2040.mk $(BOARDS:%=boards/%/board.mk)
APP_SRC := $(wildcard firmware/app/*.c)
$(foreach s,$(filter-out $(SCENES) $(REPORT_SCENES),$(sort $(foreach b,$(BOARDS),$(SCENES_$(b))))),$(eval $(call scene_rule,$(s))))

# Objects go to the board's own folder, or to that of a CPU in arm.mk.
define board_rules
$(if $(OBJ_$(1)),,$(call cpu_rules,$(1)))
OBJ_$(1) ?= $(1)
$(SCENE_DIR)/$(1)_list.c: tests/tools/scene_list.sh boards/$(1)/board.mk $(LINK_$(1):%.ld=%.mk)
	@mkdir -p $$(@D)
	$$(Q)tests/tools/scene_list.sh $$(SCENES_$(1)) >$$@
$(BUILD)/$(1)/app.elf: $$(patsubst %.c,$(BUILD)/$$(OBJ_$(1))/%.o,$$(APP_SRC) $$(HAL_$(1)) $$(SCENE_DIR)/$(1)_list.c \
		$$(SCENES_$(1):%=$$(SCENE_DIR)/%.c)) $$(ARM_OBJ_$$(OBJ_$(1))) $$(EXTRA_$(1)) boards/$(1)/link.ld $$(LINK_$(1)) boards/cortexm.ld
	$$(call say,LINK,$$@)
	@mkdir -p $$(@D)
	$$(Q)$$(ARM)gcc $$(CPU_$(1)) $$(ARM_LINK) -T boards/$(1)/link.ld -Wl,-Map=$$(@:.elf=.map) $$(filter %.o,$$^) -lgcc -o $$@
endef
$(foreach b,$(BOARDS),$(eval $(call board_rules,$(b))))

BOARD_KNOWN := $(filter $(BOARD),$(BOARDS))
BOARD_ELF := $(BUILD)/$(BOARD)/app.elf
BOARD_IMAGE := $(BUILD)/$(BOARD)/$(or $(IMAGE_$(BOARD)),app.elf)
board-known:
	@[ -n "$(BOARD_KNOWN)" ] || { echo "give BOARD=, one of: $(BOARDS)" >&2; exit 2; }

board-image: board-known $(if $(BOARD_KNOWN),$(BOARD_ELF) $(BOARD_IMAGE))
	@$(ARM)size $(BOARD_ELF)

# A machine of QEMU's, unless RUN_<board> is another command: with a screen in its window; else three seconds, and then a
# picture of what the panel shows.
qemu_run = if [ -n "$$DISPLAY$$WAYLAND_DISPLAY" ]; then \
		echo "the board's keys: arrows, and Ctrl for A"; qemu-system-arm $(QEMU_$(BOARD)) -serial stdio -kernel $(BOARD_ELF); \
	else python3 tests/device/oled.py $(BOARD_ELF) $(BUILD)/$(BOARD)/screen.png; fi
board-run: board-image
	@$(or $(RUN_$(BOARD)),$(qemu_run))

# FLASH_<board> is a command that takes the image.
board-flash: board-image
	@[ -n "$(FLASH_$(BOARD))" ] || { echo "$(BOARD): there is no way to flash it" >&2; exit 2; }
	@$(FLASH_$(BOARD)) $(BOARD_IMAGE)

.PHONY: board-known board-image board-run board-flash
