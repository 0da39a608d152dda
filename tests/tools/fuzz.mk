# SPDX-License-Identifier: MIT
# tests/fuzz: each fuzz_<thing>.c is a target, the files of corpus/fuzz_<thing>/ are its inputs (tests/fuzz/README.md).
FUZZ_TARGETS := $(patsubst tests/fuzz/%.c,%,$(wildcard tests/fuzz/fuzz_*.c))
FUZZ_CORPUS := tests/fuzz/corpus
# Whose lines the corpus reaches, all of them.
FUZZ_SRC := host-tools/view/parser.c host-tools/view/frames.c host-tools/view/unpack.c firmware/stream/pack.c \
	firmware/stream/receive.c firmware/app/remote.c
# Of what reads files, but for those in tests/fuzz/lines.txt.
FUZZ_FILE_SRC := $(filter host-tools/scene/reader%,$(HOST_SRC)) \
	$(addprefix host-tools/,scene/node.c scene/picture.c scene/relief.c import/importer.c import/patch.c import/shape.c compare/image.c) \
	$(addprefix firmware/scene/,scene_check.c scene_effects.c texel.c) boards/linux/values.c
FUZZ_LIB := $(BUILD)/fuzz/libfuzz.a
FUZZ_SCENES := mini clip
FUZZ_SCENE_C := $(SCENE_DIR)/fuzz_list.c $(FUZZ_SCENES:%=$(SCENE_DIR)/%.c)
FUZZ_BIN := $(FUZZ_TARGETS:%=$(BUILD)/fuzz/%)
# Wrapping that is meant is marked in the renderer, and in the viewer too.
FUZZ_SANITIZE := $(SANITIZE) -fsanitize=fuzzer-no-link
$(filter $(BUILD)/obj/host-tools/view/%,$(HOST_OBJ)): HAL_CFLAGS = $(if $(FUZZER),$(SANITIZE_CORE))

$(SCENE_DIR)/fuzz_list.c: tests/tools/scene_list.sh tests/tools/fuzz.mk
	@mkdir -p $(@D)
	$(Q)tests/tools/scene_list.sh $(FUZZ_SCENES) >$@

$(FUZZ_LIB): $(filter $(FUZZ_SRC:%.c=$(BUILD)/obj/%.o) $(BUILD)/obj/firmware/app/% $(BUILD)/obj/hal/%,$(HOST_OBJ)) $(CORE_OBJ)
	$(call say,AR,$@)
	@mkdir -p $(@D)
	$(Q)rm -f $@; $(AR) rcs $@ $^

# FUZZER: the library that makes the inputs up, or none: the corpus. Checksums are repaired by the target's mutator, where it has any.
FUZZ_MUTATE_fuzz_view := mutate.c
FUZZ_MUTATE_fuzz_receive := mutate.c
FUZZ_MUTATE_fuzz_remote := mutate.c
FUZZ_MUTATE_fuzz_scene := mutate_scene.c
FUZZ_MUTATE_fuzz_json := mutate_json.c
FUZZ_MUTATE_fuzz_picture := mutate_picture.c
FUZZ_FLAGS_fuzz_view := -Wl,--wrap=malloc -Wl,--wrap=realloc
FUZZ_FLAGS_fuzz_json := -Wl,--wrap=import_file
FUZZ_FLAGS_fuzz_mesh := -Wl,--wrap=aiImportFileExWithProperties -Wl,--wrap=freopen
# Those that read files as the tools do, with all that belongs to it.
FUZZ_FILES := fuzz_json fuzz_mesh fuzz_picture fuzz_settings
FUZZ_PART_fuzz_remote := $(FUZZ_SCENE_C)
FUZZ_PART_fuzz_settings := $(FUZZ_SCENE_C)
define fuzz_rule
$(BUILD)/fuzz/$(1): tests/fuzz/$(1).c $(addprefix tests/fuzz/,$(if $(FUZZER),$(FUZZ_MUTATE_$(1)),replay.c)) $$(FUZZ_PART_$(1)) \
		$(if $(filter $(FUZZ_FILES),$(1)),$(HOST_LIB) $(CORE_LIB),$(FUZZ_LIB))
	$$(call say,FUZZ,$$<)
	@mkdir -p $$(@D)
	$$(Q)$$(CC) $(HOST_FLAGS) -Itests $$(OPT) -g $$(CFLAGS) $$(FUZZER) -MMD -MP -MF $$@.d $$(filter %.c %.a,$$^) $$(FUZZ_FLAGS_$(1)) $(if $(filter $(FUZZ_FILES),$(1)),$$(PACKAGE_FLAGS) $$(PACKAGE_LIBS)) -lz -lm -o $$@
endef
$(foreach t,$(FUZZ_TARGETS),$(eval $(call fuzz_rule,$(t))))
-include $(FUZZ_BIN:=.d)

fuzz-search: $(FUZZ_SCENE_C)
	$(Q)$(MAKE) --no-print-directory BUILD=$(BUILD)/fuzz CC=clang CFLAGS="$(FUZZ_SANITIZE)" CORE_CFLAGS="$(SANITIZE_CORE)" FUZZER=-fsanitize=fuzzer fuzz-run

fuzz-run: $(FUZZ_BIN)
	$(Q)tests/fuzz/run.sh $(BUILD) $(FUZZ_CORPUS) $(if $(filter file,$(origin SECONDS)),60,$(SECONDS)) $(FUZZ_TARGETS)

fuzz-replay: $(FUZZ_BIN)
	@status=0; for target in $(FUZZ_TARGETS); do $(BUILD)/fuzz/$$target $(FUZZ_CORPUS)/$$target || status=1; done; exit $$status

# Counted afresh at each run.
fuzz-lines: $(FUZZ_BIN)
	@find $(BUILD) -name '*.gcda' -delete
	@$(MAKE) fuzz-replay >/dev/null && tests/fuzz/lines.sh tests/fuzz/lines.txt $(BUILD)/obj $(FUZZ_SRC) $(FUZZ_FILE_SRC)

# Under the sanitizers of suite-sanitize, whose objects these are too.
FUZZ_PLANTED := $(filter-out fuzz_pack fuzz_receive fuzz_remote fuzz_unpack fuzz_view,$(FUZZ_TARGETS))
fuzz-planted-run: $(FUZZ_SCENE_C)
	+@$(FAULTS_SANITIZED) fuzz-planted-sanitized
fuzz-planted-sanitized: $(FUZZ_PLANTED:%=$(BUILD)/fuzz/%)
	@COMPILE="$(CC) $(HOST_FLAGS) $(PACKAGE_FLAGS) -Itests $(OPT) -g -w $(CFLAGS)" \
		$(foreach t,$(FUZZ_PLANTED),FLAGS_$(t)="$(FUZZ_FLAGS_$(t))" PART_$(t)="$(FUZZ_PART_$(t))") \
		tests/fuzz/planted.sh $(BUILD)/fuzz/planted $(HOST_LIB) $(CORE_LIB) $(PACKAGE_LIBS) -lz -lm

suite-fuzz: $(FUZZ_SCENE_C)
	@status=0; $(MAKE) fuzz-replay || status=1; \
	$(MAKE) BUILD=$(BUILD)/lines CC=gcc OPT=-O0 CFLAGS=--coverage fuzz-lines || status=1; exit $$status

# The corpus once more, as unit tests are.
suite-sanitize: $(FUZZ_SCENE_C)
suite-sanitized: $(FUZZ_BIN)

.PHONY: fuzz-planted-run fuzz-planted-sanitized fuzz-search fuzz-run fuzz-replay fuzz-lines suite-fuzz
