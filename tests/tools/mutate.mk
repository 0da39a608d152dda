# SPDX-License-Identifier: MIT
# tests/mutate: the renderer as a shared library, of which mutate.py makes one a mutant, and the tests linked with it.
MUTATE := $(BUILD)/mutate
MUTATE_CORE_CC := $(CC) -std=c11 $(INCLUDE) -O2 -fPIC -fno-semantic-interposition -Werror=incompatible-pointer-types -Werror=int-conversion
MUTATE_TEST_CC = $(CC) $(HOST_FLAGS) $(PACKAGE_FLAGS) -Wno-error -O2 -fPIC
# Position independent, that the tables of methods have one address.
# Of the unit tests those of the renderer; two are linked with another build of it.
MUTATE_HOST := app checked choices compare control display gadget% linux% live mem meter numbers overlay pack% panels patch picture playback \
	queue record% remote% scene% share stream% survey tangents uses% usb% reference%
MUTATE_UNIT := $(filter-out $(MUTATE_HOST:%=tests/unit/test_%.c),$(UNIT_SRC)) $(wildcard tests/hard/test_*.c)
MUTATE_GOLDEN := $(GOLDEN_C) $(HOST_PROGRAM)
# Small pictures first; what hangs, hangs there.
MUTATE_GOLDEN_MINI := $(GOLDEN_SMALL_C) $(HOST_PROGRAM)
MUTATE_LONG := tests/budget/random.c tests/exhaustive/exhaustive_plan.c tests/hard/exact_triangles.c
MUTATE_TESTS := $(sort $(MUTATE_UNIT) $(MUTATE_GOLDEN) $(MUTATE_GOLDEN_MINI) $(MUTATE_LONG))
MUTATE_CORE_OBJ := $(CORE_SRC:%.c=$(MUTATE)/obj/%.o)
MUTATE_TEST_OBJ := $(MUTATE_TESTS:%.c=$(MUTATE)/obj/%.o)
MUTATE_LIBS = $(HOST_LIB) -L$(MUTATE) -lfirmware $(PACKAGE_LIBS) -Wl,--as-needed $(VIEW_LIBS) $(CMOCKA_LIBS) -lpthread -lm
MUTATE_BIN := $(patsubst %.c,$(MUTATE)/bin/%,$(notdir $(MUTATE_UNIT) $(MUTATE_LONG))) $(addprefix $(MUTATE)/bin/,golden golden_mini)

# Beside each object the inline functions that it calls, by a compilation that keeps them as they are.
$(MUTATE_CORE_OBJ): MUTATE_CC = $(MUTATE_CORE_CC)
$(MUTATE_TEST_OBJ): MUTATE_CC = $(MUTATE_TEST_CC)
$(MUTATE_CORE_OBJ) $(MUTATE_TEST_OBJ): $(MUTATE)/obj/%.o: %.c
	$(call say,CC,$<)
	@mkdir -p $(@D)
	$(Q)$(MUTATE_CC) -w -O0 -Dalways_inline=noinline -c $< -o $(@:.o=.calls)
	$(Q)nm $(@:.o=.calls) | awk '$$2 == "t" { print $$3 }' >$(@:.o=.inline) && rm $(@:.o=.calls)
	$(Q)$(MUTATE_CC) -MMD -MP -c $< -o $@
-include $(MUTATE_CORE_OBJ:.o=.d) $(MUTATE_TEST_OBJ:.o=.d)

$(MUTATE)/libfirmware.so: $(MUTATE_CORE_OBJ)
	$(call say,LINK,$@)
	$(Q)$(CC) -shared -Wl,-Bsymbolic $^ -o $@
# Which lines each killer runs: it is spared the mutants of the others.
MUTATE_LINES_OBJ := $(CORE_SRC:%.c=$(MUTATE)/lines/%.o)
$(MUTATE_LINES_OBJ): $(MUTATE)/lines/%.o: %.c
	$(call say,LINES,$<)
	@mkdir -p $(@D)
	$(Q)$(MUTATE_CORE_CC) -O1 -fno-inline --coverage -MMD -MP -c $< -o $@
$(MUTATE)/lines/libfirmware.so: $(MUTATE_LINES_OBJ)
	$(call say,LINK,$@)
	$(Q)$(CC) -shared --coverage -Wl,-Bsymbolic $^ -o $@
-include $(MUTATE_LINES_OBJ:.o=.d)
define mutate_rule
$(MUTATE)/bin/$(1): $(2:%.c=$(MUTATE)/obj/%.o) $(HOST_LIB) $(MUTATE)/libfirmware.so tests/tools/mutate.mk
	$$(call say,LINK,$$@)
	@mkdir -p $$(@D)
	$$(Q)$$(CC) $$(filter %.o,$$^) $$(MUTATE_LIBS) -o $$@
MUTATE_KILLERS += $(1) $(MUTATE_ARGUMENTS_$(1)) = $(2);
endef
# Of what takes long, a part.
MUTATE_ARGUMENTS_random := 0 150
MUTATE_ARGUMENTS_exhaustive_plan := 2000
MUTATE_ARGUMENTS_exact_triangles := 0 200
$(foreach t,$(MUTATE_UNIT) $(MUTATE_LONG),$(eval $(call mutate_rule,$(basename $(notdir $(t))),$(t))))
$(eval $(call mutate_rule,golden,$(MUTATE_GOLDEN)))
$(eval $(call mutate_rule,golden_mini,$(MUTATE_GOLDEN_MINI)))

mutation-run: $(MUTATE_BIN) $(MUTATE)/libfirmware.so $(MUTATE)/lines/libfirmware.so
	$(Q)python3 tests/mutate/mutate.py --folder $(MUTATE) --core '$(CORE_SRC)' --tests '$(MUTATE_TESTS)' \
		--core-cc '$(MUTATE_CORE_CC)' --test-cc '$(MUTATE_TEST_CC)' --link '$(CC) $(MUTATE_LIBS)' --killers '$(MUTATE_KILLERS)' \
		$(if $(FILES),--files '$(FILES)') $(if $(SAMPLE),--sample $(SAMPLE)) $(if $(SEED),--seed $(SEED)) $(MUTATE_OPTIONS)

.PHONY: mutation-run
