# SPDX-License-Identifier: MIT
# The program in firmware/app for a board: build/<board>/app.elf, with the METHODS that are named, or all.
# boards/<board>/board.mk gives, as in boards/README.md, CPU_ HAL_ (sources) SCENES_, and where they differ from what stands
# below OBJ_ LINK_ EXTRA_ IMAGE_ RUN_ FLASH_. mps2 and microbit are arm.mk's.
BOARDS := $(filter-out mps2 microbit,$(patsubst boards/%/board.mk,%,$(wildcard boards/*/board.mk)))
include boards/rp2040.mk $(BOARDS:%=boards/%/board.mk)
APP_SRC := $(wildcard firmware/app/*.c)
$(foreach s,$(filter-out $(SCENES) $(REPORT_SCENES),$(sort $(foreach b,$(BOARDS),$(SCENES_$(b))))),$(eval $(call scene_rule,$(s))))

# Objects go to the board's own folder, or to that of a CPU in arm.mk. $(1) board, $(2) program, $(3) its sources, $(4)
# objects of the renderer that they stand for:
define board_program
$(BUILD)/$(1)/$(2).elf: $$(patsubst %.c,$(BUILD)/$$(OBJ_$(1))/%.o,$(3) $$(HAL_$(1))) $$(filter-out $(4),$$(ARM_OBJ_$$(OBJ_$(1)))) \
		$$(EXTRA_$(1)) boards/$(1)/link.ld $$(LINK_$(1)) boards/cortexm.ld
	$$(call say,LINK,$$@)
	@mkdir -p $$(@D)
	$$(Q)$$(ARM)gcc $$(CPU_$(1)) $$(ARM_LINK) -T boards/$(1)/link.ld -Wl,-Map=$$(@:.elf=.map) $$(filter %.o,$$^) -lgcc -o $$@
endef
# The image $(2) of board $(1), which links the methods $(3), or all: firmware/methods.c with fewer lines decides.
define app_rule
$(BUILD)/$(1)/$(2)-methods.c: firmware/methods.c tests/tools/method_list.sh always
	@mkdir -p $$(@D)
	$$(Q)tests/tools/method_list.sh $$< $(3) >$$@.new || exit; cmp -s $$@.new $$@ && rm $$@.new || mv $$@.new $$@
$(call board_program,$(1),$(2),$(APP_SRC) $(SCENE_DIR)/$(1)_list.c $(SCENES_$(1):%=$(SCENE_DIR)/%.c) $(BUILD)/$(1)/$(2)-methods.c,%/firmware/methods.o)
endef
define board_rules
$(if $(OBJ_$(1)),,$(call cpu_rules,$(1)))
OBJ_$(1) ?= $(1)
$(SCENE_DIR)/$(1)_list.c: tests/tools/scene_list.sh boards/$(1)/board.mk $(LINK_$(1):%.ld=%.mk)
	@mkdir -p $$(@D)
	$$(Q)tests/tools/scene_list.sh $$(SCENES_$(1)) >$$@
$(call app_rule,$(1),app,$(METHODS))
$(call app_rule,$(1),app-x,x)
endef
board_scenes = $(SCENES_$(1):%=$(BUILD)/$(OBJ_$(1))/$(SCENE_DIR)/%.o)
image_size = tests/tools/image_size.sh $(1) $(BUILD)/$(1)/$(2).elf $(3) $(call board_scenes,$(1))
$(foreach b,$(BOARDS),$(eval $(call board_rules,$(b))))

# The most flash that the program may take without its scenes, of all methods and of x alone. 64 KiB is what is promised.
SIZE_LIMITS := lm3s6965evb:app:65536 lm3s6965evb:app-x:41472 picosystem:app:65536 picosystem:app-x:46080
size_fields = $(subst :, ,$(1))
size_check = $(call image_size,$(word 1,$(1)),$(word 2,$(1)),$(word 3,$(1)))
SIZE_ELF := $(foreach l,$(SIZE_LIMITS),$(BUILD)/$(word 1,$(call size_fields,$(l)))/$(word 2,$(call size_fields,$(l))).elf)
suite-size: $(SIZE_ELF)
	@status=0; $(foreach l,$(SIZE_LIMITS),$(call size_check,$(call size_fields,$(l))) || status=1;) exit $$status

# What pictures cost: tests/device/cost.c on the boards below.
COST_BOARDS := lm3s6965evb picosystem
COST_lm3s6965evb := torus288 torus800 spin-torus800
COST_picosystem := torus288 torus800 torus1000 spin-teapot bench-torus4000
define cost_rules
$(SCENE_DIR)/$(1)_cost_list.c: tests/tools/scene_list.sh tests/tools/boards.mk
	@mkdir -p $$(@D)
	$$(Q)tests/tools/scene_list.sh $$(COST_$(1)) >$$@
$(call board_program,$(1),cost,tests/device/cost.c firmware/app/share.c tests/device/program.c $(SCENE_DIR)/$(1)_cost_list.c $(COST_$(1):%=$(SCENE_DIR)/%.c))
endef
$(foreach b,$(COST_BOARDS),$(eval $(call cost_rules,$(b))))

$(BUILD)/bench/boards.csv: tests/tools/board_costs.py $(SIZE_ELF) $(COST_BOARDS:%=$(BUILD)/%/cost.elf) $(BUILD)/picosystem/cost.uf2 \
		$(BUILD)/armhf/guest-v1/initrd.gz $(GLINT)
	@mkdir -p $(@D)
	@tests/tools/rp2040js.sh $(RP2040JS) && python3 $< run $(BUILD) $(RP2040JS) $@

bench-boards-table: $(BUILD)/bench/boards.csv
	@python3 tests/tools/board_costs.py table $<

BOARD_KNOWN := $(and $(filter 1,$(words $(BOARD))),$(filter $(BOARD),$(BOARDS)))
BOARD_ELF := $(BUILD)/$(BOARD)/app.elf
BOARD_IMAGE := $(BUILD)/$(BOARD)/$(or $(IMAGE_$(BOARD)),app.elf)
board-known:
	@[ -n "$(BOARD_KNOWN)" ] || { echo "give BOARD=, one of: $(BOARDS) $(LINUX_BOARDS)" >&2; exit 2; }

board-image: board-known $(if $(BOARD_KNOWN),$(BOARD_ELF) $(BOARD_IMAGE))
	@$(call image_size,$(BOARD),app,0)

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

.PHONY: suite-size bench-boards-table board-known board-image board-run board-flash
