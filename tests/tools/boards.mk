# SPDX-License-Identifier: MIT
# The program in firmware/app for a board: build/<board>/app.elf. boards/<board>/board.mk gives, as in boards/README.md, CPU_
# HAL_ (sources) SCENES_ FORMATS_, and where they differ from what stands below OBJ_ LINK_ EXTRA_ IMAGE_ (ending) RUN_ FLASH_
# WITHOUT_ (methods that are linked only where METHODS= names them). mps2 and microbit are arm.mk's.
BOARDS := $(filter-out mps2 microbit,$(patsubst boards/%/board.mk,%,$(wildcard boards/*/board.mk)))
include boards/rp2040.mk $(BOARDS:%=boards/%/board.mk)
APP_SRC := $(wildcard firmware/app/*.c)
$(foreach s,$(filter-out $(SCENES) $(REPORT_SCENES),$(sort $(foreach b,$(BOARDS),$(SCENES_$(b))))),$(eval $(call scene_rule,$(s))))

# Hal, board and app go to the board's own folder, or to that of a CPU in arm.mk; the renderer is compiled for what the
# board's scenes and formats need, in a folder that boards with the same needs share. $(1) board, $(2) program, $(3) its
# sources, $(4) objects of the renderer that they stand for, $(5) the folder, if not the board's:
define board_program
$(BUILD)/$(1)/$(2).elf: $$(patsubst %.c,$(BUILD)/$$(OBJ_$(1))/%.o,$(3) $$(HAL_$(1))) $$(filter-out $(4),$$(ARM_OBJ_$(or $(5),$(call set_of,$(1))))) \
		$$(EXTRA_$(1)) boards/$(1)/link.ld $$(LINK_$(1)) boards/cortexm.ld
	$$(call say,LINK,$$@)
	@mkdir -p $$(@D)
	$$(Q)$$(ARM)gcc $$(CPU_$(1)) $$(ARM_LINK) -T boards/$(1)/link.ld -Wl,-Map=$$(@:.elf=.map) $$(filter %.o,$$^) -lgcc -o $$@
endef
# The renderer in folder $(1) for board $(2) and the scenes in files $(3), whose list $(4) is `always` if it can change.
define set_rules
CPU_$(1) := $(CPU_$(2))
USES_$(1) := $(BUILD)/$(1)/uses.h
$(BUILD)/$(1)/uses.h: $(3) $(PACK) $(4)
	@mkdir -p $$(@D)
	$$(Q)$(PACK) pack --uses $(FORMATS_$(2)) $(3) >$$@.new && { cmp -s $$@.new $$@ && rm $$@.new || mv $$@.new $$@; }
$(call cpu_rules,$(1))
endef
empty :=
set_key = $(subst $(empty) $(empty),+,$(OBJ_$(1)) $(FORMATS_$(1)) $(SCENES_$(1)))
set_of = $(firstword $(foreach b,$(BOARDS),$(if $(filter $(call set_key,$(1)),$(call set_key,$(b))),$(b)-set)))
scene_list = $(1:%=$(SCENE_DIR)/%.c)
# The image $(2) of board $(1), which links the methods $(3), or all that its scenes can use but the board's WITHOUT_:
# firmware/methods.c with fewer lines decides. $(4) the scenes, as C; $(5) the renderer's folder, if not the board's.
define app_rule
$(BUILD)/$(1)/$(2)-methods.c: firmware/methods.c tests/tools/method_list.sh $(BUILD)/$(or $(5),$(call set_of,$(1)))/uses.h always
	@mkdir -p $$(@D)
	$$(Q)tests/tools/method_list.sh $$< $(BUILD)/$(or $(5),$(call set_of,$(1)))/uses.h $(or $(3),$(WITHOUT_$(1):%=-%)) >$$@.new || { rm $$@.new; exit 2; }; cmp -s $$@.new $$@ && rm $$@.new || mv $$@.new $$@
$(BUILD)/$(1)/$(2)-scenes.c: tests/tools/scene_list.sh always
	@mkdir -p $$(@D)
	$$(Q)tests/tools/scene_list.sh $(basename $(notdir $(4))) >$$@.new; cmp -s $$@.new $$@ && rm $$@.new || mv $$@.new $$@
$(call board_program,$(1),$(2),$(APP_SRC) $(BUILD)/$(1)/$(2)-methods.c $(BUILD)/$(1)/$(2)-scenes.c $(4),%/firmware/methods.o,$(5))
endef
define board_rules
$(if $(filter $(1),$(OBJ_$(1))),$(call cpu_rules,$(1)))
$(if $(filter $(1)-set,$(call set_of,$(1))),$(call set_rules,$(1)-set,$(1),$(foreach s,$(SCENES_$(1)),$(call scene_file,$(s)))))
$(call app_rule,$(1),app,,$(call scene_list,$(SCENES_$(1))))
endef
$(foreach b,$(BOARDS),$(eval OBJ_$(b) ?= $(b)))
$(foreach b,$(BOARDS),$(eval $(call board_rules,$(b))))

# x alone with one scene.
X_BOARDS := lm3s6965evb picosystem
X_SCENE := torus288
$(foreach b,$(X_BOARDS),$(eval $(call set_rules,$(b)-x,$(b),$(call scene_file,$(X_SCENE)))) \
	$(eval $(call app_rule,$(b),app-x,x,$(call scene_list,$(X_SCENE)),$(b)-x)))

# With SCENE= (files, models too) or METHODS= the image is own.elf, of these alone.
BOARD_KNOWN := $(and $(filter 1,$(words $(BOARD))),$(filter $(BOARD),$(BOARDS)))
OWN_FILES := $(if $(filter command environment,$(firstword $(origin SCENE))),$(SCENE))
OWN := $(if $(OWN_FILES)$(METHODS),$(BOARD_KNOWN))
OWN_C := $(patsubst %,$(BUILD)/$(BOARD)/own/%.c,$(basename $(notdir $(OWN_FILES))))
define own_scene_rule
$(BUILD)/$(BOARD)/own/$(basename $(notdir $(1))).c: $(1) $(PACK) always
	@mkdir -p $$(@D)
	$$(Q)tests/tools/own_scene.sh $(PACK) $$< $$@
endef
$(if $(OWN),$(foreach f,$(OWN_FILES),$(eval $(call own_scene_rule,$(f)))) \
	$(if $(OWN_FILES),$(eval $(call set_rules,$(BOARD)-own,$(BOARD),$(OWN_FILES),always))) \
	$(eval $(call app_rule,$(BOARD),own,$(METHODS),$(or $(OWN_C),$(call scene_list,$(SCENES_$(BOARD)))),$(if $(OWN_FILES),$(BOARD)-own))))

scene_objects = $(patsubst %.c,$(BUILD)/$(OBJ_$(1))/%.o,$(2))
image_size = tests/tools/image_size.sh $(1) $(BUILD)/$(1)/$(2).elf $(3) $(call scene_objects,$(1),$(4))
# The most flash that the program may take without its scenes: 64 KiB, and of x alone with one scene.
SIZE_LIMITS := lm3s6965evb:app:65536 lm3s6965evb:app-x:33280 picosystem:app:65536 picosystem:app-x:39936
size_fields = $(subst :, ,$(1))
size_scenes = $(if $(filter app-x,$(2)),$(X_SCENE),$(SCENES_$(1)))
size_check = $(call image_size,$(1),$(2),$(3),$(call scene_list,$(call size_scenes,$(1),$(2))))
apply = $(call $(1),$(word 1,$(2)),$(word 2,$(2)),$(word 3,$(2)))
SIZE_ELF := $(foreach l,$(SIZE_LIMITS),$(BUILD)/$(word 1,$(call size_fields,$(l)))/$(word 2,$(call size_fields,$(l))).elf)
suite-size: $(SIZE_ELF)
	@status=0; $(foreach l,$(SIZE_LIMITS),$(call apply,size_check,$(call size_fields,$(l))) || status=1;) exit $$status

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

BOARD_NAME := $(if $(OWN),own,app)
BOARD_ELF := $(BUILD)/$(BOARD)/$(BOARD_NAME).elf
BOARD_IMAGE := $(BUILD)/$(BOARD)/$(BOARD_NAME)$(or $(IMAGE_$(BOARD)),.elf)
board-known:
	@[ -n "$(BOARD_KNOWN)" ] || { echo "give BOARD=, one of: $(BOARDS) $(LINUX_BOARDS)" >&2; exit 2; }

# What was linked, and what an image of one's own saves against the board's program.
app_size = $(call image_size,$(BOARD),app,$(1),$(call scene_list,$(SCENES_$(BOARD))))
own_size = $(call image_size,$(BOARD),own,$(1),$(or $(OWN_C),$(call scene_list,$(SCENES_$(BOARD)))))
board-image: board-known $(if $(BOARD_KNOWN),$(BOARD_ELF) $(BOARD_IMAGE) $(if $(OWN),$(BUILD)/$(BOARD)/app.elf))
	@$(if $(OWN),$(call own_size,-$$($(call app_size,code))),$(call app_size,0))
	@tests/tools/linked.sh $(BUILD)/$(or $(if $(OWN_FILES),$(BOARD)-own),$(call set_of,$(BOARD)))/uses.h $(BOARD_ELF:.elf=-methods.c)

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
