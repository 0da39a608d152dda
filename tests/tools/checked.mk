# SPDX-License-Identifier: MIT
# A build with -DGLINT_CHECKED in CFLAGS, as suite-sanitize's: firmware/fixed/checked.h traps into this.
CHECKED_OBJ := $(if $(findstring -DGLINT_CHECKED,$(CFLAGS)),$(BUILD)/obj/tests/checked/trap.o)
$(CHECKED_OBJ): $(BUILD)/obj/%.o: %.c
	$(call say,CC,$<)
	@mkdir -p $(@D)
	$(Q)$(CC) $(CORE_FLAGS) $(OPT) -g $(CFLAGS) -MMD -MP -c $< -o $@
$(CORE_LIB) $(FUZZ_LIB) $(BUILD)/tests/unit/test_uses: $(CHECKED_OBJ)
-include $(CHECKED_OBJ:.o=.d)
# It brings the renderer's arithmetic along, under the renderer's sanitizers.
$(BUILD)/tests/unit/test_checked: HOST_FLAGS += $(CORE_CFLAGS)
