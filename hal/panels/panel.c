/* SPDX-License-Identifier: MIT */
#include "panels/panel.h"
#include "clock.h"
#include "panels/changes.h"
#include "panels/turn.h"
#include "panels/wire.h"

#define BACKLIGHT_FULL 255
/* What a panel that has lost its registers takes to leave sleep before it listens; the longer waits of a start are for
 * supplies that are settled by then. */
#define REFRESH_MS 5

/* The picture's rows are not the memory's in order. */
static int panel_by_software(const struct panel *panel)
{
    return panel->turns && panel->controller->turning == PANEL_BY_SOFTWARE;
}

static int panel_accepts(const struct panel *panel, uint16_t width, uint16_t height, enum hal_pixel_format format)
{
    const struct panel_controller *controller = panel->controller;
    if (panel->rotation % 90 || panel->rotation > 270 || format != (enum hal_pixel_format)controller->format)
        return 0;
    int quarter = panel->rotation / 90 & 1;
    if (!width || !height || width != (quarter ? panel->height : panel->width) ||
        height != (quarter ? panel->width : panel->height))
        return 0;
    if ((uint32_t)panel->offset_x + panel->width > controller->columns ||
        (uint32_t)panel->offset_y + panel->height > controller->rows)
        return 0;
    if (format == HAL_GREY4 && ((panel->offset_x | panel->width | width) & 1))
        return 0;
    return (!panel->bgr || controller->bgr) && ((uintptr_t)panel->memory & 3) == 0;
}

/* Where the glass begins in a memory whose sides are exchanged or counted from the other end: at 90 degrees the rows,
 * at 180 both, at 270 the columns. */
static void panel_place(struct panel *panel)
{
    const struct panel_controller *controller = panel->controller;
    uint32_t turns = panel_by_software(panel) ? 0 : panel->turns;
    uint32_t x = panel->offset_x, y = panel->offset_y;
    if (turns == 2 || turns == 3)
        x = (uint32_t)controller->columns - panel->width - x;
    if (turns == 1 || turns == 2)
        y = (uint32_t)controller->rows - panel->height - y;
    panel->left = (uint16_t)(turns & 1 ? y : x);
    panel->top = (uint16_t)(turns & 1 ? x : y);
}

static uint8_t panel_asked(struct panel *panel)
{
    return atomic_load_explicit(&panel->asked, memory_order_relaxed);
}

/* All registers. Everything a panel can lose is here, so that sending it again mends it. */
static int panel_registers(struct panel *panel, uint32_t longest)
{
    const struct panel_controller *controller = panel->controller;
    int error = wire_table(panel, controller->start, longest);
    if (!error)
        error = wire_table(panel, panel->extra, longest);
    uint8_t orient = (uint8_t)(controller->turn[panel->turns] ^ (panel->bgr ? controller->bgr : 0));
    if (!error)
        error = wire_command(panel, controller->orient, &orient, 1);
    if (!error)
        error = wire_command(panel, panel->invert ? controller->inverted : controller->normal, 0, 0);
    if (!error && panel->bus->ops->tearing && controller->tearing)
        error = wire_command(panel, controller->tearing, (const uint8_t[]){0}, 1);
    panel->age = 0;
    panel->begun = (uint8_t)(panel_asked(panel) - 1);
    return error;
}

static int panel_open(struct hal_display *display, uint16_t width, uint16_t height, enum hal_pixel_format format)
{
    struct panel *panel = (struct panel *)display;
    struct hal_bus *bus = panel->bus;
    if (!panel_accepts(panel, width, height, format))
        return HAL_E_ARGUMENT;
    panel->across = width;
    panel->down = height;
    panel->row_bytes = (uint16_t)(format == HAL_RGB565 ? width * 2u : width / 2u);
    panel->turns = (uint8_t)(panel->rotation / 90);
    panel->shown = 0;
    panel->sent = 0;
    if (!panel->memory)
        panel->memory_size = 0;
    panel_place(panel);
    if (bus->ops->backlight)
        bus->ops->backlight(bus, 0);
    if (bus->ops->reset) {
        bus->ops->reset(bus, 0);
        clock_wait_us(10000);
        bus->ops->reset(bus, 1);
        clock_wait_us(120000);
    }
    int error = wire_table(panel, panel->controller->reset, UINT16_MAX);
    return error ? error : panel_registers(panel, UINT16_MAX);
}

static int panel_begin(struct hal_display *display, uint32_t index, uint32_t delay_ms)
{
    struct panel *panel = (struct panel *)display;
    struct hal_bus *bus = panel->bus;
    int error = 0;
    (void)index, (void)delay_ms;
    panel->sent = 0;
    panel->next = PANEL_NO_ROW;
    if (panel->refresh && panel->age >= panel->refresh) {
        error = panel_registers(panel, REFRESH_MS);
        if (!error)
            error = wire_table(panel, panel->controller->on, 0);
    }
    panel->age = (uint16_t)(panel->age < UINT16_MAX ? panel->age + 1 : UINT16_MAX);
    uint8_t asked = panel_asked(panel); /* once: another may come at any time, and is the next picture's */
    panel->all = asked != panel->begun;
    panel->begun = asked;
    if (error || !bus->ops->tearing)
        return error ? error : bus->ops->wait(bus);
    bus->ops->tearing(bus);
    return 0;
}

/* Sends rows that belong together. The window reaches to the picture's end, so that what follows needs none. */
static int panel_send(struct panel *panel, const uint8_t *pixels, uint32_t y, uint32_t rows, uint32_t stride)
{
    if (panel_by_software(panel))
        return turn_send(panel, pixels, y, rows, stride);
    int error = panel->next == y ? 0 : wire_window(panel, 0, y, panel->across, panel->down - y);
    panel->next = (uint16_t)(y + rows);
    return error ? error : wire_pixels(panel, pixels, panel->row_bytes, rows, stride);
}

static int panel_flush(struct hal_display *display, const void *pixels, uint16_t y, uint16_t rows, uint32_t stride)
{
    struct panel *panel = (struct panel *)display;
    uint32_t unit = panel_by_software(panel) && (panel->turns & 1) ? 2 : 1;
    if ((uint32_t)y + rows > panel->down || (unit == 2 && ((y | rows) & 1)))
        return HAL_E_ARGUMENT;
    uint32_t cost = panel->window_cost ? panel->window_cost : wire_window_bytes(panel->controller);
    uint32_t gap = cost / panel->row_bytes; /* unchanged rows that are cheaper than a window */
    uint32_t first = 0, end = 0;            /* the rows first .. end - 1 wait to be sent */
    for (uint32_t row = 0; row < rows; row += unit) {
        const uint8_t *at = (const uint8_t *)pixels + row * stride;
        int changed = changes_row(panel, at, y + row);
        if (unit == 2)
            changed |= changes_row(panel, at + stride, y + row + 1);
        if (!changed)
            continue;
        if (first != end && row > end + gap) {
            int error = panel_send(panel, (const uint8_t *)pixels + first * stride, y + first, end - first, stride);
            if (error)
                return error;
            first = row;
        } else if (first == end)
            /* A short gap since the band before is sent with this one, as far as it lies in it. */
            first = panel->next == y && row <= gap ? 0 : row;
        end = row + unit;
    }
    if (first == end)
        return panel->bus->ops->wait(panel->bus); /* for the band before: its pixels are the caller's again */
    return panel_send(panel, (const uint8_t *)pixels + first * stride, y + first, end - first, stride);
}

static int panel_end(struct hal_display *display)
{
    struct panel *panel = (struct panel *)display;
    struct hal_bus *bus = panel->bus;
    panel->sent_last = panel->sent;
    if (panel->shown)
        return 0; /* the last band is on its way, while the next picture is begun */
    panel->shown = 1;
    int error = wire_table(panel, panel->controller->on, UINT16_MAX);
    if (bus->ops->backlight)
        bus->ops->backlight(bus, BACKLIGHT_FULL);
    return error;
}

static int panel_close(struct hal_display *display, int keep)
{
    struct panel *panel = (struct panel *)display;
    struct hal_bus *bus = panel->bus;
    (void)keep;
    if (bus->ops->backlight)
        bus->ops->backlight(bus, 0);
    int error = wire_table(panel, panel->controller->off, UINT16_MAX);
    return error ? error : bus->ops->wait(bus);
}

void panel_repaint(struct panel *panel)
{
    atomic_store_explicit(&panel->asked, (unsigned char)(panel_asked(panel) + 1), memory_order_relaxed);
}

const struct hal_display_ops panel_display = {panel_open, panel_begin, panel_flush, panel_end, panel_close};
