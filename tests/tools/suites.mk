# SPDX-License-Identifier: MIT
# What each suite runs. tests/tools/run.sh counts what they print.
LEVELS := O0 O2 Os
MATRIX := $(foreach c,gcc clang,$(foreach l,$(LEVELS),$(c)-$(l)))
SANITIZE := -DGLINT_CHECKED -fsanitize=address,undefined,implicit-conversion,float-cast-overflow -fno-sanitize-recover=all \
	-fno-omit-frame-pointer
# Unsigned wrap too in the renderer and hal/, where what is meant modulo 2^32 is marked (firmware/fixed/checked.h).
SANITIZE_CORE := -fsanitize=integer -fno-sanitize-recover=all
BENCH_ELF := $(foreach c,$(CPUS),$(BUILD)/$(c)/bench.elf)
GOLDEN_LIST := tests/golden/hashes.txt
RANDOM_LIST := tests/golden/random.txt
SCENE_C := $(SCENES:%=$(SCENE_DIR)/%.c) $(SCENE_DIR)/golden_list.c \
	$(SCENE_DIR)/golden_small_list.c $(SCENE_DIR)/bench_list.c

suite-unit: $(UNIT_BIN)
	@status=0; for program in $^; do echo "# $$program"; $$program || { code=$$?; status=1; \
		[ $$code -lt 126 ] || echo "FAIL $$program: status $$code"; }; done; exit $$status

# The renderer compiled for some scenes and one format: what tests/unit/test_uses.c is linked with.
TEST_USES := USES_SPECULAR|USES_ORTHOGRAPHIC|USES_GREY8
TEST_USES_SCENES := torus288 sphere168 demo teapot896 materials
TEST_USES_C := $(SCENE_DIR)/uses_list.c $(TEST_USES_SCENES:%=$(SCENE_DIR)/%.c)
TEST_USES_OBJ := $(CORE_SRC:%.c=$(BUILD)/uses/%.o)
$(TEST_USES_OBJ): $(BUILD)/uses/%.o: %.c
	$(call say,CC,$<)
	@mkdir -p $(@D)
	$(Q)$(CC) $(CORE_FLAGS) $(OPT) -g $(CFLAGS) $(CORE_CFLAGS) '-DGLINT_USES=($(TEST_USES))' -MMD -MP -c $< -o $@
-include $(TEST_USES_OBJ:.o=.d)
$(SCENE_DIR)/uses_list.c: tests/tools/scene_list.sh tests/tools/suites.mk
	@mkdir -p $(@D)
	$(Q)tests/tools/scene_list.sh $(TEST_USES_SCENES) >$@
$(BUILD)/tests/unit/test_uses: tests/unit/test_uses.c $(TEST_USES_C) $(TEST_USES_OBJ)
	$(call say,TEST,$<)
	@mkdir -p $(@D)
	$(Q)$(CC) $(HOST_FLAGS) $(OPT) -g $(CFLAGS) $(LDFLAGS) '-DGLINT_USES=($(TEST_USES))' -MMD -MP -MF $@.d $^ $(CMOCKA_LIBS) -o $@

suite-exhaustive: $(EXHAUSTIVE_BIN)
	@status=0; for program in $^; do \
		if $$program; then echo "ok $$program"; else echo "FAIL $$program"; status=1; fi; done; exit $$status

# The viewer as it is where there is neither SDL2 nor libusb.
VIEW_SRC := $(wildcard host-tools/view/*.c)
PLAIN_VIEW := $(BUILD)/plain/glint-view
$(PLAIN_VIEW): $(VIEW_SRC) $(HOST_LIB) $(CORE_LIB)
	@mkdir -p $(@D)
	$(Q)$(CC) $(HOST_FLAGS) $(PACKAGE_FLAGS) $(OPT) $(CFLAGS) $(LDFLAGS) $^ $(PACKAGE_LIBS) -lm -o $@

suite-cli: $(GLINT) $(VIEW) $(PLAIN_VIEW)
	@status=0; for script in $(CLI_TESTS); do echo "# $$script"; bash $$script $(GLINT) || status=1; done; exit $$status

suite-models: $(GLINT)
	@tests/tools/models.sh $(GLINT)

suite-core: $(BENCH_ELF) $(SIZE_ELF)
	@status=0; \
	tests/tools/check_source.sh || status=1; \
	tests/tools/check_core.sh $(CPUS) -- $(CORE_SRC) || status=1; \
	for cpu in $(CPUS); do $(call stack_tool,$$cpu) --limit 1024 || status=1; done; \
	$(MAKE) suite-size || status=1; exit $$status

# Scenes, and parts of the random ones, side by side.
BUDGET_BIN := $(patsubst tests/%.c,$(BUILD)/tests/%,$(wildcard tests/budget/*.c))
-include $(BUDGET_BIN:=.d)
BUDGET_SCENES := $(wildcard tests/scenes/*.json tests/golden/*.json)
BUDGET_RANDOM := 0 5000 10000 15000
suite-budget: $(BUDGET_BIN)
	@status=0; printf '%s\n' $(BUDGET_SCENES) | xargs -P "$$(nproc)" -n 1 $(BUILD)/tests/budget/holds || status=1; \
	printf '%s 5000\n' $(BUDGET_RANDOM) | xargs -P "$$(nproc)" -n 2 $(BUILD)/tests/budget/random || status=1; exit $$status

suite-device: $(BUILD)/lm3s6965evb/app.elf $(BUILD)/lm3s6965evb/faults.elf $(GLINT) $(VIEW)
	@status=0; $(MAKE) golden-devices || status=1; \
	bash tests/device/test_flash_lm3s.sh || status=1; \
	python3 tests/device/test_faults.py $(BUILD)/lm3s6965evb/faults.elf || status=1; \
	python3 tests/device/test_lm3s6965evb.py $(BUILD)/lm3s6965evb/app.elf $(GLINT) || status=1; \
	python3 tests/device/test_remote.py $(BUILD)/lm3s6965evb/app.elf $(GLINT) $(VIEW) || status=1; exit $$status

suite-docs: $(CORE_LIB) $(SCENE_C) $(BENCH_ELF)
	@CC="$(CC)" tests/tools/readme_example.sh $(CORE_LIB) $(SCENE_DIR)

# A status of their own, by which suite-unit names a program that they ended: its message may be in a test's hands.
suite-sanitize: $(SCENE_C)
	@ASAN_OPTIONS=exitcode=126 UBSAN_OPTIONS=exitcode=126 $(MAKE) BUILD=$(BUILD)/sanitize CC=clang OPT=-O1 CFLAGS="$(SANITIZE)" CORE_CFLAGS="$(SANITIZE_CORE)" suite-sanitized

suite-sanitized: $(BUILD)/golden $(UNIT_BIN) $(GLINT) $(VIEW) $(PLAIN_VIEW)
	@status=0; $(MAKE) suite-unit || status=1; $(MAKE) fuzz-replay || status=1; $(MAKE) suite-cli || status=1; \
	tests/tools/check_golden.sh "sanitizers on this machine" all $(BUILD)/golden || status=1; exit $$status

$(BUILD)/bench/device.csv: $(BENCH_ELF)
	@mkdir -p $(@D)
	@rm -f $@.part; $(foreach c,$(CPUS),$(call QEMU,$(c)) -icount shift=0 -kernel $(BUILD)/$(c)/bench.elf | \
		sed 's/^[^#]/$(c),&/; s/^#/# $(c):/' >>$@.part;) mv $@.part $@

plain = tests/tools/plain.sh $(1) "$(call QEMU,m3)" $(PLAIN_CPUS)
suite-bench: $(BUILD)/bench/device.csv $(PLAIN_ELF)
	@status=0; tests/tools/bench_limits.sh $< || status=1; $(call plain,check) || status=1; exit $$status

bench-table: $(BUILD)/bench/device.csv $(BUILD)/bench/bench $(PLAIN_ELF)
	@tests/tools/bench.sh $< $(BUILD)/bench/bench
	@echo; $(call plain,table)

# What the report's program counts: $(1) the columns, $(2) its argument, $(3) the file, $(4) which build of it
define report_rule
$(REPORT_CPUS:%=$(BUILD)/report/%-$(2).csv): $(BUILD)/report/%-$(2).csv: $(BUILD)/%$(4)/report.elf
	$$(call say,COUNT,'$$< $(2)')
	@mkdir -p $$(@D)
	$$(Q)$$(call QEMU,$$*) -icount shift=0 -append $(2) -kernel $$< >$$@.part || { grep '^error' $$@.part >&2; false; }
	$$(Q)sed 's/^/$$*,/' $$@.part >$$@ && rm $$@.part

$(BUILD)/report/$(3).csv: $(REPORT_CPUS:%=$(BUILD)/report/%-$(2).csv)
	$$(Q){ echo $(subst |,$(comma),$(1)); cat $$^; } >$$@
endef
comma := ,
$(eval $(call report_rule,cpu|scene|method|width|height|format|instructions|picture,grey8,costs,-report))
$(eval $(call report_rule,cpu|scene|power|exponent|instructions,power,powers,))
$(eval $(call report_rule,cpu|scene|budget_q8|instructions,budget,budgets,-report))

$(BUILD)/report/flash.csv: $(REPORT_CPUS:%=$(BUILD)/%-report/report.elf) tests/tools/flash.sh
	@mkdir -p $(@D)
	$(Q)tests/tools/flash.sh $(REPORT_CPUS) >$@

REPORT_IDEAL := $(wildcard $(REPORT_JSON:.json=-ideal.json))
STREAM_JSON := $(STREAM_SCENES:%=tests/scenes/%.json)
# With the boards' section once `make bench-boards` has measured.
REPORT_BOARDS := $(wildcard $(BUILD)/bench/boards.csv)
$(BUILD)/report/index.html: $(GLINT) $(REPORT_BOARDS) $(BUILD)/report/costs.csv $(BUILD)/report/flash.csv $(BUILD)/report/powers.csv $(BUILD)/report/budgets.csv \
		$(BUILD)/report/choices.csv $(BUILD)/bench/stream.csv \
		$(REPORT_JSON) $(REPORT_IDEAL) $(STREAM_JSON) $(EFFECT_JSON)
	$(Q)$(GLINT) report -o $(@D) --costs $(@D)/costs.csv --flash $(@D)/flash.csv --powers $(@D)/powers.csv \
		--budgets $(@D)/budgets.csv --choices $(@D)/choices.csv \
		--packing $(BUILD)/bench/stream.csv $(EFFECT_JSON:%=--effect %) $(STREAM_JSON:%=--stream %) $(REPORT_BOARDS:%=--boards %) $(REPORT_JSON)

report-page: $(BUILD)/report/index.html
	@echo "$<"

$(BUILD)/bench/setup-%.csv: $(BUILD)/%/setup.elf
	@mkdir -p $(@D)
	@$(call QEMU,$*) -icount shift=0 -kernel $< >$@.part && mv $@.part $@

bench-setup-table: $(CPUS:%=$(BUILD)/bench/setup-%.csv) $(BUILD)/bench/setup $(BUILD)/bench/setup_real $(BUILD)/bench/setup_count
	@tests/tools/bench_setup.sh $(BUILD)/bench/setup_count $(BUILD)/bench/setup $(BUILD)/bench/setup_real \
		$(foreach c,$(CPUS),$(c)=$(BUILD)/bench/setup-$(c).csv)

$(BUILD)/bench/stream.csv: $(CPUS:%=$(BUILD)/%/stream.elf)
	@mkdir -p $(@D)
	@{ echo cpu,scene,format,codec,pixels,bytes,instructions; \
	$(foreach c,$(CPUS),$(call QEMU,$(c)) -icount shift=0 -kernel $(BUILD)/$(c)/stream.elf | sed 's/^/$(c),/' &&) :; } >$@.part && mv $@.part $@

bench-stream-table: $(BUILD)/bench/stream.csv
	@tests/tools/bench_stream.sh $<

profile-run: $(BENCH_ELF)
	@tests/tools/profile.sh "$(call QEMU,$(or $(CPU),m4)) -kernel" $(BUILD)/$(or $(CPU),m4)/bench.elf \
		$(or $(RENDER),bench-torus288 x) $(or $(BANDS),1) $(or $(TABLES),1) $(if $(FIRST),1,2)

size-table: $(SCENES:%=$(BUILD)/m3/$(SCENE_DIR)/%.o) $(BENCH_ELF)
	@tests/tools/size.sh $(CPUS)

stack_tool = python3 tests/tools/stack.py --cpu $(1) --indirect tests/tools/indirect.txt $(BUILD)/$(1)
stack-table: $(BENCH_ELF) $(BOARDS:%=$(BUILD)/%/app.elf)
	@status=0; for cpu in $(CPUS); do $(call stack_tool,$$cpu) --paths --limit 1024 || status=1; done; \
	for board in $(BOARDS); do python3 tests/tools/stack_image.py $(BUILD)/$$board/app.elf --name $$board --paths \
		--indirect tests/tools/indirect.txt || status=1; done; exit $$status

golden-update: $(BUILD)/golden $(BUILD)/tests/unit/test_random_list
	@$(BUILD)/tests/unit/test_random_list --list >$(BUILD)/random.txt && { diff $(RANDOM_LIST) $(BUILD)/random.txt || \
		{ cp $(BUILD)/random.txt $(RANDOM_LIST); echo "$(RANDOM_LIST): rewritten"; }; }
	@$(BUILD)/golden >$(BUILD)/hashes.txt && { diff $(GOLDEN_LIST) $(BUILD)/hashes.txt || \
		{ cp $(BUILD)/hashes.txt $(GOLDEN_LIST); echo "$(GOLDEN_LIST): rewritten"; }; }

# Arithmetic right shifts of negative numbers are meant: fixed.c asserts that the compiler has them. Uninitialised values
# and divisions by zero are clang's analyzer's: cppcheck takes a struct's array for a value that is read.
lint-run:
	@status=0; tests/tools/check_source.sh || status=1; \
	cppcheck --quiet --std=c11 --enable=warning,performance,portability --inline-suppr --error-exitcode=1 \
		--suppress=missingIncludeSystem \
		--suppress=shiftNegativeLHS --suppress=shiftTooManyBitsSigned --suppress=uninitvar --suppress=zerodiv $(INCLUDE) $(CORE_SRC) $(HOST_SRC) $(wildcard hal/*/*.c) || status=1; \
	clang-tidy --quiet --warnings-as-errors='*' $(CORE_SRC) $(HOST_SRC) -- -std=c11 -D_XOPEN_SOURCE=700 $(INCLUDE) \
		$(PACKAGE_FLAGS) $(VIEW_FLAGS) || status=1; exit $$status

.PHONY: suite-unit suite-budget suite-exhaustive suite-cli suite-models suite-core suite-device suite-docs suite-sanitize \
	suite-sanitized suite-bench bench-table bench-setup-table bench-stream-table report-page profile-run size-table stack-table golden-update lint-run \
	always
