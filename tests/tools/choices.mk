# SPDX-License-Identifier: MIT
# What the fixed-point choices are worth (tests/choices/): the renderer's own objects, with what stands between them and
# the program's exchanged by the linker.
CHOICES_WRAPPED := fx_recip_norm fx_rsqrt_norm plane_setup edges_setup plane_linear plane_quadratic plane_quadratic_large
CHOICES_SCENES := torus288 torus800-persp sphere690
CHOICES_JSON := $(CHOICES_SCENES:%=tests/scenes/%.json)
CHOICES_C := tests/choices/bench.c tests/choices/parts.c
$(foreach c,$(REPORT_CPUS),$(eval $(call image_rule,$(c),choices,$(CHOICES_C),$(MPS2_HAL),$(MPS2_LINK))))

$(BUILD)/choices: $(addprefix tests/choices/,choices.c wraps.c) $(wildcard tests/choices/*.h) $(HOST_LIB) $(CORE_LIB)
	$(call say,LINK,$@)
	$(Q)$(CC) $(HOST_FLAGS) $(PACKAGE_FLAGS) $(OPT) -g $(CFLAGS) $(LDFLAGS) $(filter-out %.h,$^) $(PACKAGE_LIBS) \
		$(CHOICES_WRAPPED:%=-Wl,--wrap=%) -lm -o $@

$(REPORT_CPUS:%=$(BUILD)/report/%-choices.csv): $(BUILD)/report/%-choices.csv: $(BUILD)/%/choices.elf
	$(call say,COUNT,$<)
	@mkdir -p $(@D)
	$(Q)$(call QEMU,$*) -icount shift=0 -kernel $< | awk -F, '{ printf "%s,%s,%s,instructions,%.3f\n", $$1, $$2, "$*", $$3 / 1000 }' >$@

$(BUILD)/report/choices.csv: $(BUILD)/choices $(REPORT_CPUS:%=$(BUILD)/report/%-choices.csv) $(CHOICES_JSON)
	$(call say,MEASURE,$@)
	$(Q){ $(BUILD)/choices $(CHOICES_JSON) && cat $(REPORT_CPUS:%=$(BUILD)/report/%-choices.csv); } >$@.part && mv $@.part $@
