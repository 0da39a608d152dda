# SPDX-License-Identifier: MIT
# tests/hard: the renderer against its definition in exact numbers, and cases that are known to be hard.
HARD_BIN := $(patsubst tests/%.c,$(BUILD)/tests/%,$(wildcard tests/hard/test_*.c))
EXACT_BIN := $(BUILD)/tests/hard/exact_triangles
-include $(HARD_BIN:=.d) $(EXACT_BIN:=.d)
EXACT_PARTS := 4

# A million random and a million lattice triangles, parts of them side by side.
suite-hard: $(EXACT_BIN) $(HARD_BIN)
	@status=0; seq 0 $$(($(EXACT_PARTS) - 1)) | xargs -P "$$(nproc)" -I N $< N $(EXACT_PARTS) || status=1; \
	for program in $(HARD_BIN); do echo "# $$program"; $$program || { code=$$?; status=1; \
		[ $$code -lt 126 ] || echo "FAIL $$program: status $$code"; }; done; exit $$status

# The loops that are written by hand for Cortex-M, of ARMv6-M and of ARMv7-M, in a program for Linux: both are Thumb.
HARD_ARM := 6M 7M
define hard_arm_rule
$(BUILD)/hard-arm/$(1)/%.o: %.c
	$$(call say,CC,'$$< (ARMv$(1))')
	@mkdir -p $$(@D)
	$$(Q)arm-linux-gnueabihf-gcc -march=armv7-a+fp -mthumb -D__ARM_ARCH_$(1)__=1 $(HOST_FLAGS) -Itests/hard/arm $$(OPT) -MMD -MP -c $$< -o $$@
$(BUILD)/hard-arm/pictures-$(1): $(BUILD)/hard-arm/$(1)/tests/hard/test_pictures.o $(CORE_SRC:%.c=$(BUILD)/hard-arm/$(1)/%.o)
	$$(call say,LINK,$$@)
	$$(Q)arm-linux-gnueabihf-gcc -static $$^ -lm -o $$@
-include $(CORE_SRC:%.c=$(BUILD)/hard-arm/$(1)/%.d)
endef
$(foreach arm,$(HARD_ARM),$(eval $(call hard_arm_rule,$(arm))))

suite-hard-arm: $(HARD_ARM:%=$(BUILD)/hard-arm/pictures-%)
	@status=0; printf '%s\n' $^ | xargs -P "$$(nproc)" -n 1 qemu-arm || status=1; exit $$status

.PHONY: suite-hard suite-hard-arm
