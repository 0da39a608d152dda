# SPDX-License-Identifier: MIT
# What there is to build.
PARTS := fixed scene geometry plan shade raster stream
CORE_SRC := $(wildcard firmware/*.c $(PARTS:%=firmware/%/*.c))
# Of every bare image; then what machine.h asks for: semihost.c, or uart.c and a machine's.
CORTEXM_HAL := $(addprefix hal/cortexm/,start.c fault.c stack.c mem.c divide.c)
# Compiled for size on a board: what a picture, an object or a button calls a few times. The rest is for speed.
COLD_SRC := $(wildcard firmware/app/*.c firmware/scene/*.c firmware/stream/*.c hal/lm3s/*.c hal/rp2040/*.c boards/*.c boards/*/*.c) \
	$(addprefix hal/cortexm/,start.c fault.c stack.c uart.c) $(addprefix hal/panels/,bars.c panel.c wire.c) \
	firmware/memory.c $(filter-out %/plan.c %/fog.c,$(wildcard firmware/plan/*.c)) $(addprefix firmware/fixed/,divide.c power.c) \
	$(addprefix firmware/geometry/,clip.c light.c project.c rotation.c transform.c) \
	$(addprefix firmware/shade/,bump.c color6.c dots.c normal_quadratic.c part.c perspective.c piece.c plane_wide.c uv.c) \
	$(addprefix firmware/raster/,draw_highlight.c draw_subdivide.c draw_overveld_scan.c fine.c parts.c split.c table.c)
# What is of effects alone: a program for scenes without them needs none of these.
EFFECT_SRC := $(foreach e,texture texel uv split bump fog turn effects power,$(wildcard firmware/plan/*$(e)*.c firmware/shade/*$(e)*.c firmware/raster/*$(e)*.c)) \
	firmware/scene/texel.c firmware/fixed/exponential.c firmware/plan/highlighted.c firmware/plan/summit.c firmware/raster/draw_highlight.c
SETUP_SRC := $(wildcard tests/setups/setup_*.c)
# Of the program for Linux, what wants neither libgpiod nor a device.
LINUX_PARTS := $(filter-out hal/linux/gpio_v% %/kernel.c %/main.c,$(wildcard hal/linux/*.c boards/linux/*.c))
HOST_SRC := $(wildcard hal/host/*.c hal/panels/*.c host-tools/*/*.c) $(SETUP_SRC) tests/choices/parts.c $(LINUX_PARTS) \
	$(filter-out %/main.c %/start.c,$(wildcard firmware/app/*.c))
UNIT_SRC := $(wildcard tests/unit/test_*.c)
EXHAUSTIVE_SRC := $(wildcard tests/exhaustive/*.c)
CLI_TESTS := $(wildcard tests/cli/*.sh)
ALL_SRC = $(shell find firmware hal host-tools boards tests -name '*.[ch]')

# The scenes as C, each a symbol scene_<name>; and the lists that the golden and the bench programs walk.
export SCENE_DIR ?= $(BUILD)/scenes
GOLDEN_SCENES := mini clip back materials torus288 torus512 torus800 sphere168 sphere690 torus288-persp torus512-persp \
	torus800-persp sphere168-persp sphere690-persp serpentine zigzag strip teapot896 bulb pawn bench-torus288 demo \
	fog-linear two-sided-bowl texture-quad texture-teapot bump-nearest bump-brick
BENCH_SCENES := bench-torus288 bench-torus4000
# What `make report` measures; the first is the page's summary and the README's.
with_persp = $(foreach s,$(1),$(s) $(if $(wildcard tests/scenes/$(s)-persp.json),$(s)-persp))
REPORT_SCENES := $(call with_persp,torus288 torus512 torus800 sphere168 sphere690 serpentine zigzag strip teapot896 teapot896-grey bulb pawn)
# What it shows beside the truth.
EFFECT_JSON := $(wildcard $(addprefix tests/scenes/,texture-*.json bump-*.json fog-*.json two-sided-*.json))
# What it measures as a stream, moving.
STREAM_SCENES := demo spin-torus800 spin-teapot spin-pawns torus288 torus512 torus800 torus1000 torus800-persp bench-torus4000 sphere690 \
	bulb pawn serpentine zigzag strip teapot896
export PACK ?= $(BUILD)/glint
