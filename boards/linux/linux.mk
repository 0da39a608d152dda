# SPDX-License-Identifier: MIT
# Boards that run Linux: firmware/app as a program, build/<flavour>/glint-device-v1 or -v2, by the libgpiod it is for. On
# an Arm machine it is built for that machine, with its own libgpiod; elsewhere crosswise, for ARMv6 (the first Pi Zero,
# and all since in 32 bits) or Debian's armhf, with libgpiod fetched into the build folder.
LINUX_BOARDS := pi-zero-waveshare13 pi-zero-displayhatmini pi-zero-usb linux-virt
LINUX_SCENES := demo spin-torus800 spin-teapot spin-pawns torus1000 torus288 torus800 sphere690 bulb pawn zigzag teapot896 bench-torus4000
LINUX_NATIVE := $(filter arm% aarch64,$(shell uname -m))
LINUX_CROSS := arm-linux-gnueabihf-
LINUX_DEBIAN := $(BUILD)/armhf/debian
# The libgpiod to build for: 1 (Debian 12) or 2 (backports, Debian 13).
GPIOD ?= $(if $(LINUX_NATIVE),$(call once,LINUX_GPIOD,pkg-config --atleast-version=2 libgpiod && echo 2 || echo 1),1)

LINUX_FLAVOUR_linux-virt := armhf
linux_flavour = $(if $(LINUX_NATIVE),native,$(or $(LINUX_FLAVOUR_$(1)),armv6))

LINUX_CC_native = $(CC)
LINUX_CC_armhf := $(LINUX_CROSS)gcc
LINUX_CC_armv6 := $(LINUX_CROSS)gcc -march=armv6kz+fp -marm
# See start.S; the compiler's own functions come from the Pi's libgcc_s for the same reason.
LINUX_START_armv6 := $(BUILD)/armv6/boards/linux/start.o
LINUX_LINK_armv6 := -nostartfiles -no-pie -shared-libgcc -Wl,--no-as-needed -lgcc_s -Wl,--as-needed -Wl,--fatal-warnings

LINUX_SRC := $(filter-out firmware/app/start.c,$(wildcard firmware/app/*.c boards/linux/*.c hal/panels/*.c)) $(CORE_SRC) \
	$(filter-out hal/linux/gpio_v%,$(wildcard hal/linux/*.c)) hal/host/null.c hal/host/numbers.c $(SCENE_DIR)/linux_list.c $(LINUX_SCENES:%=$(SCENE_DIR)/%.c)
LINUX_FLAGS := -std=c11 -D_GNU_SOURCE $(WARN) $(INCLUDE) $(OPT) -g -ffunction-sections -fdata-sections
LINUX_GPIOD_FLAGS_native = $(call once,LINUX_GPIOD_CFLAGS,pkg-config --cflags libgpiod)
LINUX_GPIOD_LIBS_native = $(call once,LINUX_GPIOD_LIBS,pkg-config --libs libgpiod)

$(foreach s,$(filter-out $(SCENES) $(REPORT_SCENES) $(foreach b,$(BOARDS),$(SCENES_$(b))),$(LINUX_SCENES)),$(eval $(call scene_rule,$(s))))

$(SCENE_DIR)/linux_list.c: tests/tools/scene_list.sh boards/linux/linux.mk
	@mkdir -p $(@D)
	$(Q)tests/tools/scene_list.sh $(LINUX_SCENES) >$@

$(LINUX_DEBIAN)/complete: tests/device/linux/fetch.sh
	$(Q)tests/device/linux/fetch.sh $(@D)

# $(1) flavour, $(2) libgpiod
define linux_program
$(BUILD)/$(1)/gpio_v$(2).o: hal/linux/gpio_v$(2).c hal/linux/gpio.h $(if $(filter native,$(1)),,$(LINUX_DEBIAN)/complete)
	$$(call say,CC-$(1),$$<)
	@mkdir -p $$(@D)
	$$(Q)$$(LINUX_CC_$(1)) $$(LINUX_FLAGS) $$(or $$(LINUX_GPIOD_FLAGS_$(1)),-I$(LINUX_DEBIAN)/v$(2)/usr/include) $$(CFLAGS) -c $$< -o $$@
$(BUILD)/$(1)/glint-device-v$(2): $$(LINUX_SRC:%.c=$(BUILD)/$(1)/%.o) $(BUILD)/$(1)/gpio_v$(2).o $$(LINUX_START_$(1))
	$$(call say,LINK,$$@)
	$$(Q)$$(LINUX_CC_$(1)) $$(LDFLAGS) -Wl,--gc-sections $$(filter %.o,$$^) \
		$$(or $$(LINUX_GPIOD_LIBS_$(1)),-L$(LINUX_DEBIAN)/v$(2)/usr/lib/arm-linux-gnueabihf -lgpiod) -lpthread $$(LINUX_LINK_$(1)) -o $$@
endef
define linux_flavour_rules
$(BUILD)/$(1)/%.o: %.c
	$$(call say,CC-$(1),$$<)
	@mkdir -p $$(@D)
	$$(Q)$$(LINUX_CC_$(1)) $$(LINUX_FLAGS) $$(CFLAGS) -MMD -MP -c $$< -o $$@
$(BUILD)/$(1)/%.o: %.S
	@mkdir -p $$(@D)
	$$(Q)$$(LINUX_CC_$(1)) -c $$< -o $$@
-include $$(shell find $(BUILD)/$(1) -name '*.d' 2>/dev/null)
endef
$(foreach f,native armhf armv6,$(eval $(call linux_flavour_rules,$(f)))$(foreach v,1 2,$(eval $(call linux_program,$(f),$(v)))))

LINUX_KNOWN := $(filter $(BOARD),$(LINUX_BOARDS))
LINUX_PROGRAM = $(BUILD)/$(call linux_flavour,$(BOARD))/glint-device-v$(GPIOD)
PREFIX ?= /usr/local

linux-known:
	@[ -n "$(LINUX_KNOWN)" ] || { echo "give BOARD=, one of: $(LINUX_BOARDS)" >&2; exit 2; }

linux-image: linux-known $(if $(LINUX_KNOWN),$(LINUX_PROGRAM))
	@echo "$(LINUX_PROGRAM): try it with --board boards/$(BOARD)/board.conf"

linux-install: linux-image
	@boards/linux/install.sh $(LINUX_PROGRAM) boards/$(BOARD)/board.conf '$(PREFIX)' '$(DESTDIR)'

linux-flash: linux-known
	@echo "$(BOARD): runs Linux: 'make BOARD=$(BOARD) install' on it" >&2; exit 2

.PHONY: linux-known linux-image linux-install linux-flash

# A libgpiod of the tests' own stands where <gpiod.h> is asked for.
$(BUILD)/tests/unit/test_linux_v1: HOST_FLAGS += -Itests/unit/gpiod_v1
$(BUILD)/tests/unit/test_linux_v2: HOST_FLAGS += -Itests/unit/gpiod_v2
