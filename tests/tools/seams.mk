# SPDX-License-Identifier: MIT
# tests/faults: programs whose calls of libraries and machines fail, one after another (tests/faults/seam.h).
FAULTS_WRAPS := malloc calloc realloc strdup realpath fopen fdopen fmemopen open_memstream tmpfile stat fstat access mkdir mkdtemp \
	mkstemp fchmod rename pipe fork open read write deflateInit2_
FAULTS_TOOLS := $(BUILD)/faults/tools
# Both tools in one program, each with a main of another name.
FAULTS_MAINS := $(BUILD)/faults/glint_main.o $(BUILD)/faults/view_main.o
$(BUILD)/faults/glint_main.o: host-tools/glint/main.c
$(BUILD)/faults/view_main.o: host-tools/view/main.c
$(FAULTS_MAINS):
	@mkdir -p $(@D)
	$(Q)$(CC) $(HOST_FLAGS) $(PACKAGE_FLAGS) $(VIEW_FLAGS) $(OPT) -g $(CFLAGS) -Dmain=$(basename $(@F)) -MMD -MP -c $< -o $@

$(FAULTS_TOOLS): tests/faults/tools.c tests/faults/wraps.c $(FAULTS_MAINS) $(HOST_LIB) $(CORE_LIB)
	$(call say,FAULTS,$<)
	$(Q)$(CC) $(HOST_FLAGS) $(PACKAGE_FLAGS) -Itests $(OPT) -g $(CFLAGS) $(LDFLAGS) -MMD -MP -MF $@.d $(filter %.c %.o %.a,$^) \
		$(FAULTS_WRAPS:%=-Wl,--wrap=%) $(PACKAGE_LIBS) $(VIEW_LIBS) -lm -o $@
-include $(FAULTS_TOOLS).d $(FAULTS_MAINS:.o=.d)

# Models of machines are those of the unit tests.
FAULTS_MACHINES := $(patsubst tests/%.c,$(BUILD)/tests/%,$(filter-out %/tools.c %/wraps.c,$(wildcard tests/faults/*.c)))
$(FAULTS_MACHINES): HOST_FLAGS += -Itests/unit $(VIEW_FLAGS)
FAULTS_SDL := Init CreateWindow DestroyWindow CreateRenderer DestroyRenderer CreateTexture LockTexture UpdateTexture SetTextureColorMod \
	SetTextureBlendMode GetRendererOutputSize SetRenderDrawColor RenderClear RenderCopy RenderReadPixels GetDisplayUsableBounds \
	SetWindowFullscreen
$(BUILD)/tests/faults/window: LDFLAGS += $(FAULTS_SDL:%=-Wl,--wrap=SDL_%)
$(BUILD)/tests/faults/linux_v1: HOST_FLAGS += -Itests/unit/gpiod_v1
$(BUILD)/tests/faults/linux_v2: HOST_FLAGS += -Itests/unit/gpiod_v2
-include $(FAULTS_MACHINES:=.d)

# Each call, two halves of the cases at once.
faults_tools = printf '%s 2$(1)\n' 0 1 | xargs -P 2 -L 1 $(FAULTS_TOOLS) || status=1
suite-faults: $(FAULTS_TOOLS) $(FAULTS_MACHINES)
	@status=0; $(call faults_tools); for program in $(FAULTS_MACHINES); do echo "# $$program"; $$program || status=1; done; \
	$(FAULTS_SANITIZED) FAULTS_SPARSE=16 suite-faults-sanitized || status=1; exit $$status

# Under the sanitizers of suite-sanitize, whose objects these are too, a tool takes ten times as long.
FAULTS_SANITIZED := ASAN_OPTIONS=exitcode=126 UBSAN_OPTIONS=exitcode=126 $(MAKE) BUILD=$(BUILD)/sanitize CC=clang OPT=-O1 \
	CFLAGS="$(SANITIZE)" CORE_CFLAGS="$(SANITIZE_CORE)"
suite-faults-sanitized: $(FAULTS_TOOLS)
	@status=0; export FAULTS_SPARSE; $(call faults_tools); exit $$status

# FAULTS_PAIRS: how many of each tool, and 20 times as many of each machine.
suite-faults-pairs:
	@FAULTS_PAIRS=$(or $(FAULTS_PAIRS),600) $(FAULTS_SANITIZED) FAULTS_SPARSE=1 suite-faults-pairs-sanitized

suite-faults-pairs-sanitized: $(FAULTS_TOOLS) $(FAULTS_MACHINES) suite-faults-sanitized
	@status=0; $(call faults_tools, pairs); for program in $(FAULTS_MACHINES); do echo "# $$program"; \
		FAULTS_PAIRS=$$(($$FAULTS_PAIRS * 20)) $$program || status=1; done; exit $$status

.PHONY: suite-faults suite-faults-sanitized suite-faults-pairs suite-faults-pairs-sanitized
