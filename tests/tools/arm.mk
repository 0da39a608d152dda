# SPDX-License-Identifier: MIT
# The renderer and the measuring programs for Cortex-M: build/<cpu>/... with stack use and call graph beside each object.
include boards/mps2/board.mk boards/microbit/board.mk

ARM := arm-none-eabi-
CPUS := m0plus m3 m4
REPORT_CPUS := m3 m0plus
CPU_m0 := -mcpu=cortex-m0
CPU_m0plus := -mcpu=cortex-m0plus
CPU_m3 := -mcpu=cortex-m3
CPU_m4 := -mcpu=cortex-m4
CPU_m7 := -mcpu=cortex-m7
ARM_OPT := -O2
ARM_FLAGS := -mthumb -mfloat-abi=soft -std=c11 $(WARN) $(INCLUDE) $(ARM_OPT) -g -ffreestanding -ffunction-sections \
	-fdata-sections -fno-tree-loop-distribute-patterns -fstack-usage -fcallgraph-info=su
ARM_LINK := -mthumb -nostdlib -Wl,--gc-sections -Wl,--fatal-warnings
DEVICE_SRC := tests/device/program.c tests/device/program_device.c
SCENES := $(sort $(GOLDEN_SCENES) $(BENCH_SCENES))

scene_file = $(firstword $(wildcard tests/golden/$(1).json) tests/scenes/$(1).json)
define scene_rule
$(SCENE_DIR)/$(1).c: $(call scene_file,$(1)) $(PACK)
	$$(call say,PACK,$$<)
	@mkdir -p $$(@D)
	$$(Q)$(PACK) pack $$< -o $$@ --name scene_$(subst -,_,$(1)) >/dev/null
endef
$(foreach s,$(sort $(SCENES) $(REPORT_SCENES)),$(eval $(call scene_rule,$(s))))

$(SCENE_DIR)/golden_list.c: tests/tools/scene_list.sh tests/tools/sources.mk
	@mkdir -p $(@D)
	$(Q)tests/tools/scene_list.sh $(GOLDEN_SCENES) >$@
$(SCENE_DIR)/golden_small_list.c: tests/tools/scene_list.sh
	@mkdir -p $(@D)
	$(Q)tests/tools/scene_list.sh mini >$@
$(SCENE_DIR)/bench_list.c: tests/tools/scene_list.sh tests/tools/sources.mk
	@mkdir -p $(@D)
	$(Q)tests/tools/scene_list.sh $(BENCH_SCENES) >$@
# REPORT_SCENES may come from the command line: the list is made each time, and is new only when it differs.
$(SCENE_DIR)/report_list.c: tests/tools/scene_list.sh always
	@mkdir -p $(@D)
	$(Q)tests/tools/scene_list.sh $(REPORT_SCENES) >$@.new; cmp -s $@.new $@ && rm $@.new || mv $@.new $@

GOLDEN_C := tests/golden/golden.c $(SCENE_DIR)/golden_list.c $(GOLDEN_SCENES:%=$(SCENE_DIR)/%.c)
GOLDEN_SMALL_C := tests/golden/golden.c $(SCENE_DIR)/golden_small_list.c $(SCENE_DIR)/mini.c
BENCH_C := tests/device/bench.c $(SCENE_DIR)/bench_list.c $(BENCH_SCENES:%=$(SCENE_DIR)/%.c)
REPORT_C := tests/device/bench.c $(SCENE_DIR)/report_list.c $(REPORT_SCENES:%=$(SCENE_DIR)/%.c)
SETUP_C := tests/setups/bench.c $(SETUP_SRC)
STREAM_C := tests/device/stream.c $(SCENE_DIR)/bench_list.c $(BENCH_SCENES:%=$(SCENE_DIR)/%.c)

# The renderer for CPU_$(1), in folder $(1); for less than all if USES_$(1) names a header that says so (firmware/uses.h).
define cpu_rules
ARM_OBJ_$(1) := $$(CORE_SRC:%.c=$(BUILD)/$(1)/%.o)
$(BUILD)/$(1)/%.o: %.c $$(USES_$(1))
	$$(call say,CC-$(1),$$<)
	@mkdir -p $$(@D)
	$$(Q)$$(ARM)gcc $$(CPU_$(1)) $$(ARM_FLAGS) $$(if $$(filter $$<,$$(COLD_SRC)),-Os) $$(DEFS_$(1)) $$(addprefix -include ,$$(USES_$(1))) -MMD -MP -c $$< -o $$@
-include $$(shell find $(BUILD)/$(1) -name '*.d' 2>/dev/null)
endef
$(foreach c,m0 m7 $(CPUS),$(eval $(call cpu_rules,$(c))))
DEFS_m0 := -DGOLDEN_SMALL
DEFS_m0plus := -DPROGRAM_COUNTS
DEFS_m3 := -DPROGRAM_COUNTS
DEFS_m4 := -DPROGRAM_COUNTS

# $(1) CPU, $(2) program, $(3) its sources, $(4) the board's sources, $(5) the board's linker script
define image_rule
$(BUILD)/$(1)/$(2).elf: $$(patsubst %.c,$(BUILD)/$(1)/%.o,$(3) $$(DEVICE_SRC) $(4)) $$(ARM_OBJ_$(1)) $(5) boards/cortexm.ld
	$$(call say,LINK,$$@)
	$$(Q)$$(ARM)gcc $$(CPU_$(1)) $$(ARM_LINK) -T $(5) -Wl,-Map=$$(@:.elf=.map) $$(filter %.o,$$^) -lgcc -o $$@
endef
# What effects cost a scene that has none (tests/device/plain.c): a program compiled for it; the same of all objects but those
# of the effects; one that has everything; and that with two scenes, one of which has a light more that reaches nothing.
PLAIN_CPUS := m3 m0plus
BEHIND_SCENES := plain-dome plain-dome-behind
$(foreach s,plain-torus288 $(BEHIND_SCENES),$(eval $(call scene_rule,$(s))))
plain_c = tests/device/plain.c $(SCENE_DIR)/$(1)_list.c $(2:%=$(SCENE_DIR)/%.c) $(DEVICE_SRC) $(MPS2_HAL)
# $(1) CPU, $(2) program, $(3) its sources, $(4) the renderer's objects
define plain_image
$(BUILD)/$(1)/$(2).elf: $$(patsubst %.c,$(BUILD)/$(1)/%.o,$(3)) $(4) $(MPS2_LINK) boards/cortexm.ld
	$$(call say,LINK,$$@)
	$$(Q)$$(ARM)gcc $$(CPU_$(1)) $$(ARM_LINK) -T $(MPS2_LINK) -Wl,-Map=$$(@:.elf=.map) $$(filter %.o,$$^) -lgcc -o $$@
endef
define plain_rules
USES_$(1)-plain := $(BUILD)/$(1)-plain/uses.h
CPU_$(1)-plain := $(CPU_$(1))
$(call cpu_rules,$(1)-plain)
$(BUILD)/$(1)-plain/uses.h: tests/scenes/plain-torus288.json $(PACK)
	@mkdir -p $$(@D)
	$$(Q)$(PACK) pack --uses rgb565,grey8 $$< >$$@.new && { cmp -s $$@.new $$@ && rm $$@.new || mv $$@.new $$@; }
$(call plain_image,$(1),plain,$(call plain_c,plain,plain-torus288),$$(ARM_OBJ_$(1)-plain))
$(call plain_image,$(1),plain-without,$(call plain_c,plain,plain-torus288),$$(filter-out $$(EFFECT_SRC:%.c=$(BUILD)/$(1)-plain/%.o),$$(ARM_OBJ_$(1)-plain)))
$(call plain_image,$(1),plain-all,$(call plain_c,plain,plain-torus288),$$(ARM_OBJ_$(1)))
$(call plain_image,$(1),plain-behind,$(call plain_c,behind,$(BEHIND_SCENES)),$$(ARM_OBJ_$(1)))
endef
$(SCENE_DIR)/plain_list.c: tests/tools/scene_list.sh tests/tools/arm.mk
	@mkdir -p $(@D)
	$(Q)tests/tools/scene_list.sh plain-torus288 >$@
$(SCENE_DIR)/behind_list.c: tests/tools/scene_list.sh tests/tools/arm.mk
	@mkdir -p $(@D)
	$(Q)tests/tools/scene_list.sh $(BEHIND_SCENES) >$@
$(foreach c,$(PLAIN_CPUS),$(eval $(call plain_rules,$(c))))
PLAIN_ELF := $(foreach c,$(PLAIN_CPUS),$(foreach p,plain plain-without plain-all plain-behind,$(BUILD)/$(c)/$(p).elf))

$(foreach c,m7 $(CPUS),$(eval $(call image_rule,$(c),golden,$(GOLDEN_C),$(MPS2_HAL),$(MPS2_LINK))))
$(foreach c,$(CPUS),$(eval $(call image_rule,$(c),bench,$(BENCH_C),$(MPS2_HAL),$(MPS2_LINK))))
# The report's, compiled for its scenes and format as a board's program is; and for everything, as forms of the power want.
$(foreach c,$(REPORT_CPUS),$(eval $(call image_rule,$(c),report,$(REPORT_C),$(MPS2_HAL),$(MPS2_LINK))))
define report_cpu
USES_$(1)-report := $(BUILD)/$(1)-report/uses.h
CPU_$(1)-report := $(CPU_$(1))
DEFS_$(1)-report := -DPROGRAM_COUNTS
$(call cpu_rules,$(1)-report)
$(BUILD)/$(1)-report/uses.h: $(REPORT_JSON) $(PACK) always
	@mkdir -p $$(@D)
	$$(Q)$(PACK) pack --uses grey8 $(REPORT_JSON) >$$@.new && { cmp -s $$@.new $$@ && rm $$@.new || mv $$@.new $$@; }
$(call image_rule,$(1)-report,report,$(REPORT_C),$(MPS2_HAL),$(MPS2_LINK))
endef
REPORT_JSON := $(foreach s,$(REPORT_SCENES),$(call scene_file,$(s)))
$(foreach c,$(REPORT_CPUS),$(eval $(call report_cpu,$(c))))
$(foreach c,$(CPUS),$(eval $(call image_rule,$(c),stream,$(STREAM_C),$(MPS2_HAL),$(MPS2_LINK))))
$(foreach c,$(CPUS),$(eval $(call image_rule,$(c),setup,$(SETUP_C),$(MPS2_HAL),$(MPS2_LINK))))
$(eval $(call image_rule,m0,golden,$(GOLDEN_SMALL_C),$(MICROBIT_HAL),$(MICROBIT_LINK)))

# The same programs on the desktop, in this configuration's compiler and level.
HOST_PROGRAM := tests/device/program.c tests/device/program_host.c
$(BUILD)/golden: $(GOLDEN_C) $(HOST_PROGRAM) $(CORE_LIB)
	$(call say,LINK,$@)
	$(Q)$(CC) $(CORE_FLAGS) $(OPT) $(CFLAGS) $^ -o $@
$(BUILD)/bench/bench: $(BENCH_C) $(HOST_PROGRAM) $(CORE_LIB)
	$(call say,LINK,$@)
	@mkdir -p $(@D)
	$(Q)$(CC) $(CORE_FLAGS) $(OPT) -g $(CFLAGS) $^ -o $@
$(BUILD)/bench/setup: $(SETUP_C) $(HOST_PROGRAM) $(CORE_LIB)
	$(call say,LINK,$@)
	@mkdir -p $(@D)
	$(Q)$(CC) $(CORE_FLAGS) $(OPT) -g $(CFLAGS) $^ -o $@
$(BUILD)/bench/setup_real: tests/setups/bench_real.c tests/setups/setup_case.c $(CORE_LIB) $(wildcard tests/setups/*.h)
	$(call say,LINK,$@)
	@mkdir -p $(@D)
	$(Q)$(CC) $(HOST_FLAGS) -fno-math-errno $(OPT) -g $(CFLAGS) $(filter-out %.h,$^) -lm -o $@
$(BUILD)/bench/setup_count: tests/setups/count.cc $(wildcard tests/setups/*.h)
	$(call say,LINK,$@)
	@mkdir -p $(@D)
	$(Q)clang -x c++ -std=c++14 -fno-exceptions -fno-rtti $(WARN) $< -lm -o $@

QEMU = qemu-system-arm $(QEMU_$(1)) -display none -serial none -monitor none -chardev file,id=out,path=/dev/stdout \
	-semihosting-config enable=on,target=native,chardev=out
