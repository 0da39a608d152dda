# SPDX-License-Identifier: MIT
# What of firmware/ the tests on the host reach: lines, branches and MC/DC, all of it but for what tests/coverage.txt lists.
COVER_CC := clang-19
# Counters are known by file and function: static functions of files of one name would be one.
COVER_FLAGS := -fprofile-instr-generate -fcoverage-mapping -fcoverage-mcdc -Xclang -main-file-name -Xclang $$<
COVER_APP := $(filter $(BUILD)/obj/firmware/app/%,$(HOST_OBJ))
COVER_OBJ := $(filter-out %/methods.o,$(CORE_OBJ) $(TEST_USES_OBJ)) $(COVER_APP)
# Unit tests, hard cases, every picture of the list of hashes, the corpus of the fuzzer, of `make test-budget` some views, and
# scenes at random.
COVER_BIN := $(UNIT_BIN) $(HARD_BIN)
COVER_RUN := $(COVER_BIN) $(BUILD)/golden $(foreach t,$(FUZZ_TARGETS),"$(BUILD)/fuzz/$(t) $(FUZZ_CORPUS)/$(t)") \
	$(foreach s,$(BUDGET_SCENES),"$(BUILD)/tests/budget/holds --views 2 $(s)") "$(BUILD)/tests/budget/random 0 15000" \
	"$(BUILD)/tests/unit/test_every_pairing 100000"

# The program of the boards is counted with the renderer.
$(COVER_APP): LIBRARY_FLAGS = $(if $(COVERAGE),$(CORE_CFLAGS))

coverage-run: $(SCENE_C) $(FUZZ_SCENE_C)
	$(Q)$(MAKE) --no-print-directory BUILD=$(BUILD)/coverage COVERAGE=1 CC=$(COVER_CC) OPT=-O1 HAL_CFLAGS= CORE_CFLAGS='$(COVER_FLAGS)' \
		LDFLAGS='$(COVER_FLAGS)' coverage-report

# Counted afresh at each run. Some tests are compiled with sources of firmware/ in them; the checked build's is another code.
coverage-report: $(COVER_BIN) $(BUILD)/golden $(FUZZ_BIN) $(BUDGET_BIN)
	@rm -rf $(BUILD)/profile
	@printf '%s\n' $(COVER_RUN) | LLVM_PROFILE_FILE=$(CURDIR)/$(BUILD)/profile/%m.profraw xargs -P "$$(nproc)" -I{} \
		sh -c '{} >/dev/null 2>&1 || { echo "FAIL {}"; exit 1; }'; status=$$?; \
	llvm-profdata-19 merge -o $(BUILD)/profile.data $(BUILD)/profile/*.profraw && \
	python3 tests/tools/coverage.py tests/coverage.txt $(BUILD)/profile.data $(COVER_OBJ) \
		$$(grep -lE ' (./)?firmware/[^ ]*\.c' $(filter-out %/test_checked.d,$(COVER_BIN:=.d)) | sed 's/\.d$$//') && exit $$status

.PHONY: coverage-run coverage-report
