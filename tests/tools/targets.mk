# SPDX-License-Identifier: MIT
# The list of picture hashes on machines that are neither this one nor a bare board: build/target/<name>/golden.
TARGETS := armhf aarch64 mips wasm
TARGET_CC_armhf := arm-linux-gnueabihf-gcc -static
TARGET_CC_aarch64 := aarch64-linux-gnu-gcc -static
TARGET_CC_mips := mips-linux-gnu-gcc -static
# No operating system: what it may call of libc is hal/cortexm/mem.c, its lines go out through the only import.
TARGET_CC_wasm := clang --target=wasm32 -ffreestanding -nostdlib
TARGET_LINK_wasm := -Wl,--no-entry,--export=program_start
TARGET_RUN_armhf := qemu-arm
TARGET_RUN_aarch64 := qemu-aarch64
TARGET_RUN_mips := qemu-mips
TARGET_RUN_wasm := node tests/golden/wasm.mjs
TARGET_NAME_armhf := gcc, ARMv7-A, Linux
TARGET_NAME_aarch64 := gcc, AArch64, Linux
TARGET_NAME_mips := gcc, big-endian MIPS, Linux
TARGET_NAME_wasm := clang, WebAssembly, Node
TARGET_PROGRAM_wasm := tests/golden/wasm.c hal/cortexm/mem.c

# The scenes for a big-endian machine.
TARGET_SCENES_mips := $(BUILD)/target/mips/scenes
define big_scene
$(BUILD)/target/mips/scenes/$(1).c: $(call scene_file,$(1)) $(PACK)
	$$(call say,PACK,'$$< (big-endian)')
	@mkdir -p $$(@D)
	$$(Q)$(PACK) pack $$< -o $$@ --byte-order big --name scene_$(subst -,_,$(1)) >/dev/null
endef
$(foreach s,$(sort $(GOLDEN_SCENES)),$(eval $(call big_scene,$(s))))

# $(1) target, $(2) its folder of scenes
define target_rules
$(1)_OBJ := $$(patsubst %.c,$(BUILD)/target/$(1)/%.o,$$(filter-out firmware/stream/%,$$(CORE_SRC)) tests/golden/golden.c tests/device/program.c $$(or $$(TARGET_PROGRAM_$(1)),tests/device/program_host.c))
$$($(1)_OBJ): $(BUILD)/target/$(1)/%.o: %.c
	$$(call say,CC-$(1),$$<)
	@mkdir -p $$(@D)
	$$(Q)$$(TARGET_CC_$(1)) $$(CORE_FLAGS) -O2 -MMD -MP -c $$< -o $$@
-include $$($(1)_OBJ:.o=.d)
$(BUILD)/target/$(1)/golden: $$($(1)_OBJ) $$(SCENE_DIR)/golden_list.c $$(GOLDEN_SCENES:%=$(2)/%.c)
	$$(call say,LINK,$$@)
	$$(Q)$$(TARGET_CC_$(1)) $$(CORE_FLAGS) $$(TARGET_LINK_$(1)) $$^ -o $$@
endef
$(foreach t,$(TARGETS),$(eval $(call target_rules,$(t),$(or $(TARGET_SCENES_$(t)),$(SCENE_DIR)))))

# One list, side by side; those that differ do not end the others.
GOLDEN_CPUS := m7 $(CPUS)
$(TARGETS:%=golden-on-%): golden-on-%: $(BUILD)/target/%/golden
	@tests/tools/check_golden.sh "$(TARGET_NAME_$*)" all $(TARGET_RUN_$*) $<
$(GOLDEN_CPUS:%=golden-on-%): golden-on-%: $(BUILD)/%/golden.elf
	@tests/tools/check_golden.sh "$(subst -mcpu=,,$(CPU_$*)) on $(subst -M ,,$(QEMU_$*))" all $(call QEMU,$*) -kernel $<
golden-on-m0: $(BUILD)/m0/golden.elf
	@tests/tools/check_golden.sh "cortex-m0 on microbit" small $(call QEMU,m0) -kernel $<
$(MATRIX:%=golden-by-%): golden-by-%: $(SCENE_C)
	@$(MAKE) BUILD=$(BUILD)/matrix/$* CC=$(firstword $(subst -, ,$*)) OPT=-$(lastword $(subst -, ,$*)) $(BUILD)/matrix/$*/golden && \
	tests/tools/check_golden.sh "$* on this machine" all $(BUILD)/matrix/$*/golden

suite-golden:
	@$(MAKE) -k $(MATRIX:%=golden-by-%) $(TARGETS:%=golden-on-%)

golden-devices:
	@$(MAKE) -k golden-on-m0 $(GOLDEN_CPUS:%=golden-on-%)

.PHONY: suite-golden golden-devices golden-on-m0 $(TARGETS:%=golden-on-%) $(GOLDEN_CPUS:%=golden-on-%) $(MATRIX:%=golden-by-%)
