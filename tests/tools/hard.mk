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

.PHONY: suite-hard
