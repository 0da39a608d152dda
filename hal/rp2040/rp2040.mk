# SPDX-License-Identifier: MIT
# What an RP2040 image is made of: the second stage with its CRC as $(RP2040_BOOT2), to be linked, and NAME.elf -> NAME.uf2.
RP2040_HAL := $(CORTEXM_HAL) hal/cortexm/uart.c $(addprefix hal/rp2040/,vectors.c clocks.c gpio.c timer.c uart.c bus.c) \
	$(wildcard hal/panels/*.c)
RP2040_BOOT2 := $(BUILD)/m0plus/hal/rp2040/boot2_crc.o
RP2040_TOOL := hal/rp2040/image.py

# Linked where the ROM puts it, at the end of RAM.
$(RP2040_BOOT2): hal/rp2040/boot2.c hal/rp2040/registers.h $(RP2040_TOOL)
	$(call say,BOOT2,$<)
	@mkdir -p $(@D)
	$(Q)$(ARM)gcc $(CPU_m0plus) $(filter-out -f%,$(ARM_FLAGS)) -Os -ffreestanding -nostdlib -Wl,--section-start=.boot2=0x20041f00 \
		-Wl,-e,boot2_start -Wl,--build-id=none $< -o $(@:.o=.elf)
	$(Q)$(ARM)objcopy -O binary -j .boot2 $(@:.o=.elf) $(@:.o=.bin)
	$(Q)python3 $(RP2040_TOOL) boot2 $(@:.o=.bin) $(@:.o=.s)
	$(Q)$(ARM)gcc $(CPU_m0plus) -mthumb -c $(@:.o=.s) -o $@

%.uf2: %.elf $(RP2040_TOOL)
	$(call say,UF2,$@)
	$(Q)$(ARM)objcopy -O binary $< $(@:.uf2=.bin)
	$(Q)python3 $(RP2040_TOOL) uf2 $(@:.uf2=.bin) $@
