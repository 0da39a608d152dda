# SPDX-License-Identifier: MIT
# Sources are found by wildcard: a new file of the renderer, the tools or the tests needs no line here.
# `make BOARD=...` alone builds what goes on the board; one with a board.conf runs Linux.
.DEFAULT_GOAL := $(if $(BOARD),image,all)
BOARD_SORT := $(if $(wildcard boards/$(BOARD)/board.conf),linux,board)
MAKEFLAGS += --no-builtin-rules
.SUFFIXES:
.DELETE_ON_ERROR:
.SECONDARY:

ifeq ($(origin CC),default)
CC := gcc
endif
ifeq ($(origin AR),default)
AR := ar
endif
export BUILD ?= build
OPT ?= -O2
WERROR ?= -Werror
SCENE ?= tests/scenes/demo.json
Q := $(if $(V),,@)
QUIET := $(findstring s,$(filter-out --%,$(firstword $(MAKEFLAGS))))
say = $(if $(V)$(QUIET),@:,@printf '  %-7s %s\n' $(1) $(2))

include tests/tools/sources.mk

WARN := -Wall -Wextra $(WERROR)
INCLUDE := -Ifirmware -Ihal -Ihost-tools -I.
CORE_FLAGS := -std=c11 $(WARN) $(INCLUDE)
HOST_FLAGS := -std=c11 -D_XOPEN_SOURCE=700 $(WARN) $(INCLUDE)
# Asked for at the first use only: `make deps` may have to install pkg-config itself.
PACKAGES := libpng jansson assimp zlib
once = $(eval $(1) := $$(shell $(2)))$($(1))
PACKAGE_FLAGS = $(call once,PACKAGE_FLAGS,pkg-config --cflags $(PACKAGES))
PACKAGE_LIBS = $(call once,PACKAGE_LIBS,pkg-config --libs $(PACKAGES))
# glint-view has USB and a window where there are libusb and SDL2, unless LIBUSB= or SDL2= says otherwise.
LIBUSB ?= libusb-1.0
SDL2 ?= sdl2
VIEW_PACKAGES = $(call once,VIEW_PACKAGES,for p in $(LIBUSB) $(SDL2); do pkg-config --exists $$$$p && echo $$$$p; done)
VIEW_FLAGS = $(if $(filter $(LIBUSB),$(VIEW_PACKAGES)),-DHAVE_LIBUSB) $(if $(filter $(SDL2),$(VIEW_PACKAGES)),-DHAVE_SDL2) \
	$(call once,VIEW_CFLAGS,$(if $(VIEW_PACKAGES),pkg-config --cflags $(VIEW_PACKAGES)))
VIEW_LIBS = $(call once,VIEW_LDLIBS,$(if $(VIEW_PACKAGES),pkg-config --libs $(VIEW_PACKAGES)))
CMOCKA_LIBS = $(call once,CMOCKA_LIBS,pkg-config --libs cmocka)
# USB in the hands of a test: its functions, but the header of the real ones.
$(BUILD)/tests/unit/test_usb $(BUILD)/tests/unit/test_usb_find: HOST_FLAGS += $(VIEW_FLAGS)

CORE_OBJ := $(CORE_SRC:%.c=$(BUILD)/obj/%.o)
HOST_OBJ := $(HOST_SRC:%.c=$(BUILD)/obj/%.o)
CORE_LIB := $(BUILD)/libglint.a
HOST_LIB := $(BUILD)/libhost.a
GLINT := $(BUILD)/glint
VIEW := $(BUILD)/glint-view
UNIT_BIN := $(UNIT_SRC:tests/%.c=$(BUILD)/tests/%)
EXHAUSTIVE_BIN := $(EXHAUSTIVE_SRC:tests/%.c=$(BUILD)/tests/%)

all: ## Build the command line tools, build/glint and build/glint-view
	$(Q)DEPS=manual tests/tools/deps.sh demo || { echo "'make demo' installs them itself" >&2; exit 1; }
	$(Q)$(MAKE) --no-print-directory tool

demo: deps-demo ## Render the demo (or SCENE=file) into build/demo/
	$(Q)$(MAKE) --no-print-directory tool
	$(Q)$(GLINT) demo '$(SCENE)' '$(BUILD)/demo'

view: deps-view ## Build the viewer of streams, build/glint-view, with USB and a window
	$(Q)$(MAKE) --no-print-directory tool
	@echo "$(VIEW): shows the device on USB, file:PATH or what comes by a pipe; --help has all, in its window h the keys"

test: deps-test ## Run every test; the last line counts them
	$(Q)tests/tools/run.sh unit hard fuzz faults cli models budget core golden device rp2040 linux docs sanitize bench

test-unit: deps-test ## Unit tests
	$(Q)tests/tools/run.sh unit

test-hard: deps-test ## A million random and a million lattice triangles against their definition in exact numbers, and hard cases by name
	$(Q)tests/tools/run.sh hard

test-hard-arm: deps-test ## Its finished pixels once more, by the loops that are written by hand for Cortex-M, in qemu-arm (3 minutes)
	$(Q)tests/tools/run.sh hard-arm

test-fuzz: deps-test ## What `make fuzz` found of interest, given to the parsers of streams again, and that it reaches all their lines
	$(Q)tests/tools/run.sh fuzz

test-faults: deps-test ## Programs whose calls of libraries, kernel and devices fail, one after another, then some pairs
	$(Q)tests/tools/run.sh faults

test-faults-pairs: deps-test ## The same with FAULTS_PAIRS=600 pairs of each tool's calls, and 20 times as many of a machine's (16 minutes on a busy machine)
	$(Q)tests/tools/run.sh faults-pairs

test-cli: deps-test ## The command line tool against good and bad input
	$(Q)tests/tools/run.sh cli

test-models: deps-test ## Real models by every method against the double-precision renderer: a table of PSNR
	$(Q)tests/tools/run.sh models

test-budget: deps-test ## Whether every pixel by auto stays within its budget of the truth: scenes from 60 sides and at random, the bounds themselves
	$(Q)tests/tools/run.sh budget

test-core: deps-test ## What the renderer may link, include, keep and stack, on every CPU
	$(Q)tests/tools/run.sh core

test-golden: deps-test ## The one list of picture hashes: compilers, levels, band heights; 32 and 64-bit Arm, big-endian MIPS, WebAssembly
	$(Q)tests/tools/run.sh golden

test-device: deps-test ## The same list on emulated Cortex-M0, M0+, M3, M4 and M7
	$(Q)tests/tools/run.sh device

test-rp2040: deps-test ## Frames on the display wires of an emulated PicoSystem, and their cycles
	$(Q)tests/tools/run.sh rp2040

test-linux: deps-test ## The Linux boards' program on an emulated handheld, judged at its pins
	$(Q)tests/tools/run.sh linux

test-usb: deps-test ## Pictures over USB between glint-device and glint-view, with pulled cables and hostile hosts, in that handheld
	$(Q)tests/tools/run.sh usb

test-sanitize: deps-test ## Unit tests, command line and hashes in checked arithmetic (firmware/fixed/checked.h) under clang's sanitizers
	$(Q)tests/tools/run.sh sanitize

test-exhaustive: deps-test ## Whole domains of the fixed-point functions, and the plan's bounds (11 minutes of CPU)
	$(Q)tests/tools/run.sh exhaustive

coverage: deps-coverage ## Lines, branches and MC/DC of firmware/ that the tests reach, by file: all but tests/coverage.txt (some minutes)
	$(Q)$(MAKE) --no-print-directory coverage-run

mutation: deps-test ## Small changes of the renderer that tests ought to see, SAMPLE=800 of them or of FILES='firmware/plan/*': score and survivors (half an hour)
	$(Q)$(MAKE) --no-print-directory mutation-run

prove: deps-prove ## Frama-C proofs: no overflow, no access out of bounds, nothing undefined, every statement reached (10 minutes); PROOFS="fixed plane" of some
	$(Q)$(MAKE) --no-print-directory prove-run

prove-scene: deps-prove ## The contracts of the scene check, for blobs of any bytes and length (980 goals, 4 minutes)
	$(Q)$(MAKE) --no-print-directory prove-scene-run

prove-planted: deps-prove ## Whether the proofs fail on faults planted into a copy of the sources (14 minutes)
	$(Q)$(MAKE) --no-print-directory prove-planted-run

fuzz: deps-test ## Make up bytes for the parsers of streams, SECONDS=60 for each; what breaks one is kept in build/fuzz/broken
	$(Q)$(MAKE) --no-print-directory fuzz-search

fuzz-planted: deps-test ## Whether what was made up before sees faults planted into what reads files (3 minutes)
	$(Q)$(MAKE) --no-print-directory fuzz-planted-run

bench: deps-test ## Instructions a frame on Cortex-M0+, M3, M4 and the host; writes build/bench/bench.csv
	$(Q)$(MAKE) --no-print-directory bench-table

bench-boards: deps-test ## What pictures cost on the emulated boards, their RAM and flash; writes build/bench/boards.csv
	$(Q)$(MAKE) --no-print-directory bench-boards-table

report: deps-test ## Pictures, errors and costs of every method on every scene, into build/report/index.html
	$(Q)$(MAKE) --no-print-directory report-page

bench-setup: deps-test ## The papers' quadratic set-ups: operations, instructions, seconds; writes build/bench/setup.csv
	$(Q)$(MAKE) --no-print-directory bench-setup-table

bench-stream: deps-test ## Bytes a picture of a stream, and instructions to pack it, on Cortex-M0+, M3, M4; writes build/bench/stream.csv
	$(Q)$(MAKE) --no-print-directory bench-stream-table

figures: deps-test ## Write the figures of quality and cost in the README files anew
	$(Q)$(MAKE) --no-print-directory bench-table bench-boards-table report-page
	$(Q)tests/tools/figures.sh $(GLINT) $(BUILD)/bench/bench.csv $(BUILD)/report/report.csv $(BUILD)/report/stream.csv \
		$(BUILD)/bench/stream.csv $(BUILD)/report/sweep.csv README.md
	$(Q)tests/tools/figures.sh stream $(BUILD)/report/stream.csv $(BUILD)/bench/stream.csv | tests/tools/paste.sh host-tools/README.md
	$(Q){ $(MAKE) -s --no-print-directory bench-boards-table; echo; } | tests/tools/paste.sh boards/README.md
	$(Q){ echo; $(MAKE) -s --no-print-directory bench-setup-table | sed "s/^./    &/"; echo; } | tests/tools/paste.sh tests/setups/README.md

profile: deps-test ## Instructions by function: CPU=m4 RENDER="bench-torus288 x" [BANDS=8] [FIRST=1]
	$(Q)$(MAKE) --no-print-directory profile-run

size: deps-test ## Flash and RAM of the renderer by part, for each CPU
	$(Q)$(MAKE) --no-print-directory size-table

stack: deps-test ## Worst-case stack of the renderer's entry points on each CPU, and of the boards' programs
	$(Q)$(MAKE) --no-print-directory stack-table

golden: deps-test ## Write tests/golden/hashes.txt anew, showing what changed
	$(Q)$(MAKE) --no-print-directory golden-update

lint: deps-test ## Layering, tokens, cppcheck and clang-tidy
	$(Q)$(MAKE) --no-print-directory lint-run

format: ## clang-format every source in place
	$(Q)clang-format -i $(ALL_SRC)

check-format: ## Fail if clang-format would change a source
	$(Q)clang-format --dry-run -Werror $(ALL_SRC)

deps: deps-test ## Install what building and testing need (DEPS=manual only prints the command)

DEPS_LISTS := demo view test linux prove coverage
deps-demo: ## Install what building the tool needs: `make deps-demo all` in a CI job

$(DEPS_LISTS:%=deps-%):
	$(Q)tests/tools/deps.sh $(@:deps-%=%)

BOARD_DEPS := $(BOARD_SORT:board=test)
image: deps-$(BOARD_DEPS) ## The handheld's program for BOARD=picosystem, or another of boards/: build/<board>/app.elf; with SCENE="file..." or METHODS="x duff" own.elf, of these alone
	$(Q)$(MAKE) --no-print-directory $(BOARD_SORT)-image

run: deps-test ## Run it on the emulated BOARD; an RP2040 in a browser (SERVE=1), or SECONDS=3 KEYS="A@500 up@900-1500"
	$(Q)$(MAKE) --no-print-directory $(BOARD_SORT)-run

flash: deps-$(BOARD_DEPS) ## Put it on the real BOARD; DRY_RUN=1 only says how
	$(Q)$(MAKE) --no-print-directory $(BOARD_SORT)-flash

install: deps-linux ## Install it on this Linux BOARD as a service, or below DESTDIR; PREFIX=/usr/local
	$(Q)$(MAKE) --no-print-directory linux-install

clean: ## Remove the build folder
	$(Q)rm -rf $(BUILD)

help: ## List the targets
	@sed -n 's/^\([a-z0-9-]*\):.*## \(.*\)/\1\t\2/p' Makefile | awk -F '\t' '{ printf "  make %-17s %s\n", $$1, $$2 }'

# --- host build -------------------------------------------------------------------------------------------------

$(CORE_OBJ): $(BUILD)/obj/%.o: %.c
	$(call say,CC,$<)
	@mkdir -p $(@D)
	$(Q)$(CC) $(CORE_FLAGS) $(OPT) -g $(CFLAGS) $(CORE_CFLAGS) -MMD -MP -c $< -o $@

$(filter $(BUILD)/obj/hal/%,$(HOST_OBJ)): HAL_CFLAGS = $(CORE_CFLAGS)
# Compiled anew when a library has come or gone.
VIEW_OBJ := $(filter $(BUILD)/obj/host-tools/view/%,$(HOST_OBJ))
$(VIEW_OBJ): LIBRARY_FLAGS = $(VIEW_FLAGS)
$(VIEW_OBJ): $(BUILD)/view.flags
$(BUILD)/view.flags: always
	@mkdir -p $(@D); echo '$(VIEW_FLAGS)' | cmp -s - $@ || echo '$(VIEW_FLAGS)' >$@
$(HOST_OBJ): $(BUILD)/obj/%.o: %.c
	$(call say,CC,$<)
	@mkdir -p $(@D)
	$(Q)$(CC) $(HOST_FLAGS) $(PACKAGE_FLAGS) $(LIBRARY_FLAGS) $(OPT) -g $(CFLAGS) $(HAL_CFLAGS) -MMD -MP -c $< -o $@

$(CORE_LIB): $(CORE_OBJ)
$(HOST_LIB): $(filter-out %/main.o,$(HOST_OBJ))
$(CORE_LIB) $(HOST_LIB):
	$(call say,AR,$@)
	$(Q)rm -f $@; $(AR) rcs $@ $^

tool: $(GLINT) $(VIEW)
	@:

$(GLINT): $(BUILD)/obj/host-tools/glint/main.o $(HOST_LIB) $(CORE_LIB)
$(VIEW): $(BUILD)/obj/host-tools/view/main.o $(HOST_LIB) $(CORE_LIB)
$(VIEW): LIBRARIES = $(VIEW_LIBS)
$(GLINT) $(VIEW):
	$(call say,LINK,$@)
	$(Q)$(CC) $(CFLAGS) $(LDFLAGS) $^ $(PACKAGE_LIBS) $(LIBRARIES) -lm -o $@

$(BUILD)/tests/%: tests/%.c $(HOST_LIB) $(CORE_LIB)
	$(call say,TEST,$<)
	@mkdir -p $(@D)
	$(Q)$(CC) $(HOST_FLAGS) $(PACKAGE_FLAGS) $(OPT) -g $(CFLAGS) $(LDFLAGS) -MMD -MP -MF $@.d $< \
		$(HOST_LIB) $(CORE_LIB) $(PACKAGE_LIBS) -Wl,--as-needed $(VIEW_LIBS) $(CMOCKA_LIBS) -lpthread -lm -o $@

include tests/tools/arm.mk
include tests/tools/boards.mk
include boards/linux/linux.mk
include tests/tools/suites.mk
include tests/tools/choices.mk
include tests/tools/rp2040.mk
include tests/tools/linux.mk
include tests/tools/faults.mk
include tests/tools/fuzz.mk
include tests/tools/checked.mk
include tests/tools/hard.mk
include tests/tools/targets.mk
include tests/tools/prove.mk
include tests/tools/coverage.mk
include tests/tools/prove_bytes.mk
include tests/tools/seams.mk
include tests/tools/mutate.mk

-include $(CORE_OBJ:.o=.d) $(HOST_OBJ:.o=.d) $(UNIT_BIN:=.d) $(EXHAUSTIVE_BIN:=.d)

# All that have a line of help, and the lists of packages.
GOALS := $(shell sed -n 's/^\([a-z0-9-]*\):.*\#\# .*/\1/p' Makefile) $(DEPS_LISTS:%=deps-%)
.PHONY: $(GOALS) tool
# Several are made one after another, also with -j: each calls a make of its own, in the same folder.
ifneq ($(word 2,$(filter $(GOALS),$(MAKECMDGOALS))),)
.NOTPARALLEL:
endif
