# SPDX-License-Identifier: MIT
# The Linux boards' program on an emulated handheld (tests/device/linux), a guest for each libgpiod.
GUESTS := v1 v2
GUEST_DIR := $(BUILD)/armhf/guest-
GUEST_KERNEL := $(LINUX_DEBIAN)/kernel
GUEST_BOARD := boards/linux-virt/board.conf

# glint-view of the guest, without a window.
GUEST_VIEW := $(BUILD)/armhf/glint-view
GUEST_VIEW_OBJ := $(patsubst %.c,$(BUILD)/armhf/%.o,$(wildcard host-tools/view/*.c hal/host/*.c) host-tools/glint/cli.c firmware/app/text.c $(CORE_SRC))
GUEST_TOOLS := $(BUILD)/armhf/bogus $(BUILD)/armhf/cable
GUEST_VIEW_HAS := $(LINUX_DEBIAN)/view/usr
GUEST_LINK = -L$(GUEST_VIEW_HAS)/lib/arm-linux-gnueabihf -L$(LINUX_DEBIAN)/view/lib/arm-linux-gnueabihf \
	-Wl,-rpath-link,$(GUEST_VIEW_HAS)/lib/arm-linux-gnueabihf:$(LINUX_DEBIAN)/view/lib/arm-linux-gnueabihf
$(filter $(BUILD)/armhf/host-tools/% $(BUILD)/armhf/hal/host/%,$(GUEST_VIEW_OBJ)) $(BUILD)/armhf/tests/device/linux/bogus.o: LINUX_FLAGS += -DHAVE_LIBUSB -isystem $(GUEST_VIEW_HAS)/include \
	-isystem $(GUEST_VIEW_HAS)/include/libusb-1.0
$(GUEST_VIEW_OBJ) $(BUILD)/armhf/tests/device/linux/bogus.o: | $(LINUX_DEBIAN)/complete
$(GUEST_VIEW): $(GUEST_VIEW_OBJ)
$(GUEST_TOOLS): $(BUILD)/armhf/%: $(BUILD)/armhf/tests/device/linux/%.o $(filter-out %/main.o,$(GUEST_VIEW_OBJ))
$(GUEST_VIEW) $(GUEST_TOOLS):
	$(call say,LINK,$@)
	$(Q)$(LINUX_CC_armhf) $(LDFLAGS) -Wl,--gc-sections $^ $(GUEST_LINK) -l:libpng16.so.16 -l:libz.so.1 -l:libusb-1.0.so.0 -lpthread -lm -o $@

define guest_rule
$(GUEST_DIR)$(1)/initrd.gz: $(BUILD)/armhf/glint-device-$(1) $(GUEST_VIEW) $(GUEST_TOOLS) $(LINUX_DEBIAN)/complete $(GUEST_BOARD) \
		tests/device/linux/guest.sh tests/device/linux/handheld.dtsi
	$$(call say,GUEST,$$(@D))
	@mkdir -p $$(@D)
	$$(Q)tests/device/linux/guest.sh $(LINUX_DEBIAN) $(1) $$(@D) $(GUEST_BOARD) $$(filter $(BUILD)/armhf/glint-% $(GUEST_TOOLS),$$^)
endef
$(foreach v,$(GUESTS),$(eval $(call guest_rule,$(v))))

# Both guests at once: each waits for the other's half of the machine only where there is one. $(1) programs, one after another
guests_run = status=0; jobs=; for version in $(GUESTS); do { code=0; for program in $(1); do \
		python3 tests/device/linux/$$program.py $(GUEST_KERNEL) $(GUEST_DIR)$$version $(GLINT) || code=1; done; exit $$code; } & \
		jobs="$$jobs $$!"; done; for job in $$jobs; do wait $$job || status=1; done; exit $$status
suite-linux suite-usb: $(GUESTS:%=$(GUEST_DIR)%/initrd.gz) $(GLINT)
suite-linux:
	@$(call guests_run,test_linux test_usb)

suite-usb:
	@$(call guests_run,test_usb)

# In a browser where there is a screen or SERVE=1, else SECONDS with KEYS pressed. ARGS are the program's options.
GUEST_RUN = $(GUEST_DIR)v$(GPIOD)
linux-run: $(if $(filter linux-virt,$(BOARD)),$(GUEST_RUN)/initrd.gz)
	@[ "$(BOARD)" = linux-virt ] || { echo "$(BOARD): runs on the board itself; emulated: make BOARD=linux-virt run" >&2; exit 2; }
	@$(if $(SERVE)$(DISPLAY)$(WAYLAND_DISPLAY),python3 tests/device/linux/serve.py $(GUEST_KERNEL) $(GUEST_RUN) $(GUEST_BOARD) \
		$(PORT) $(ARGS),python3 tests/device/linux/play.py $(GUEST_KERNEL) $(GUEST_RUN) $(GUEST_BOARD) \
		$(GUEST_RUN)/screen.png $(SECONDS) $(ARGS) $(KEYS) && echo "$(GUEST_RUN)/screen.png: what its panel shows then (live in a browser: SERVE=1)")

.PHONY: suite-linux suite-usb linux-run
