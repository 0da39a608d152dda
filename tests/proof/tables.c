/* SPDX-License-Identifier: MIT */
/*
 * Tables of commands of every controller: whatever the bus says, each is read to its end and no further, and windows
 * of any place on the glass are told in the bytes of an address that the controller takes.
 *
 *   proves: wire_command wire_table wire_range wire_window wire_window_bytes wire_pixels
 *   options: hal/panels/wire.c hal/panels/st7789.c hal/panels/ili9341.c hal/panels/ssd1351.c hal/panels/ssd0323.c
 *            -eva-precision 2 -eva-slevel-function wire_table:2000
 */
#include "proof.h"

#include "clock.h"
#include "panels/panel.h"
#include "panels/wire.h"

/*@ assigns \nothing; */
void clock_wait_us(uint32_t us);

static int bus_write(struct hal_bus *bus, enum hal_bus_kind kind, const uint8_t *bytes, uint32_t count)
{
    (void)bus, (void)kind;
    //@ assert 1 <= count <= 127 && \valid_read(bytes + (0 .. count - 1)) && \initialized(bytes + (0 .. count - 1));
    return any_s32(-2, 0);
}

static int bus_pixels(struct hal_bus *bus, const void *pixels, unsigned word, uint32_t count, uint32_t rows,
                      uint32_t stride)
{
    (void)bus, (void)pixels, (void)count, (void)rows, (void)stride;
    //@ assert word == 1 || word == 2;
    return any_s32(-2, 0);
}

static void controller(const struct panel_controller *controller)
{
    static const struct hal_bus_ops ops = {.write = bus_write, .pixels = bus_pixels};
    struct hal_bus bus = {&ops};
    struct panel panel = {.controller = controller, .bus = &bus, .turns = (uint8_t)any_u32(0, 3)};
    wire_table(&panel, controller->reset, ANY_U32);
    wire_table(&panel, controller->start, ANY_U32);
    wire_table(&panel, controller->on, ANY_U32);
    wire_table(&panel, controller->off, ANY_U32);
    wire_window(&panel, any_u32(0, 2047), any_u32(0, 2047), any_u32(1, 2048), any_u32(1, 2048));
    wire_pixels(&panel, &bus, any_u32(0, 4096), any_u32(0, 2048), ANY_U32);
    const uint32_t bytes = wire_window_bytes(controller);
    //@ assert bytes >= 6;
}

void prove(void)
{
    controller(&panel_st7789);
    controller(&panel_ili9341);
    controller(&panel_ssd1351);
    controller(&panel_ssd0323);
}
