/* SPDX-License-Identifier: MIT */
#include "linux/wires.h"
#include "display.h"

#include <string.h>

#define BACKLIGHT_ON 128u /* a line is on or off: the levels from here are on */

static int wires_send(struct wires *wires, const uint8_t *bytes, uint32_t count)
{
    int error = wires->banged ? bitbang_send(&wires->bitbang, bytes, count, &wires->problem)
                              : spidev_send(&wires->spi, bytes, count, &wires->problem);
    if (!error)
        wires->problem.text[0] = 0;
    return error;
}

/* --- the thread that sends ------------------------------------------------------------------------------------------
 */

static void *wires_thread(void *argument)
{
    struct wires *wires = argument;
    pthread_mutex_lock(&wires->mutex);
    for (;;) {
        while (!wires->waiting && !wires->stop)
            pthread_cond_wait(&wires->change, &wires->mutex);
        if (!wires->waiting)
            break;
        pthread_mutex_unlock(&wires->mutex);
        int error = wires_send(wires, wires->buffer[wires->sending], wires->waiting);
        pthread_mutex_lock(&wires->mutex);
        wires->waiting = 0;
        wires->failed = wires->failed ? wires->failed : error;
        pthread_cond_broadcast(&wires->change);
    }
    pthread_mutex_unlock(&wires->mutex);
    return NULL;
}

/* Until the thread is idle; then all of *wires is the caller's. Its error is told once. */
static int wires_wait(struct hal_bus *bus)
{
    struct wires *wires = (struct wires *)bus;
    pthread_mutex_lock(&wires->mutex);
    while (wires->waiting)
        pthread_cond_wait(&wires->change, &wires->mutex);
    int error = wires->failed;
    wires->failed = 0;
    pthread_mutex_unlock(&wires->mutex);
    return error;
}

/* The thread is idle: it sends the other buffer from now on. */
static void wires_start(struct wires *wires, unsigned index, uint32_t count)
{
    pthread_mutex_lock(&wires->mutex);
    wires->sending = (uint8_t)index;
    wires->waiting = count;
    pthread_cond_broadcast(&wires->change);
    pthread_mutex_unlock(&wires->mutex);
}

/* --- the bus --------------------------------------------------------------------------------------------------------
 */

static int wires_level(struct wires *wires, int line, unsigned level)
{
    uint32_t levels = (wires->levels & ~(1u << line)) | level << line;
    if (levels == wires->levels)
        return 0;
    int result = gpio_set(&wires->control, levels ^ wires->inverted);
    if (result)
        return problem_set(&wires->problem, "GPIO lines of '%s': %s", wires->control.label, strerror(-result));
    wires->levels = levels;
    return 0;
}

static int wires_write(struct hal_bus *bus, enum hal_bus_kind kind, const uint8_t *bytes, uint32_t count)
{
    struct wires *wires = (struct wires *)bus;
    int error = wires_wait(bus);
    if (!error)
        error = wires_level(wires, wires->dc, kind == HAL_BUS_DATA);
    return error ? error : wires_send(wires, bytes, count);
}

/* Copies in the order of the wire. */
static void wires_copy(uint8_t *to, const uint8_t *from, unsigned word, uint32_t count)
{
    if (word == 1) {
        memcpy(to, from, count);
        return;
    }
    const uint16_t *pixel = (const uint16_t *)(const void *)from;
    for (uint32_t i = 0; i < count; i++) {
        to[2 * i] = (uint8_t)(pixel[i] >> 8);
        to[2 * i + 1] = (uint8_t)pixel[i];
    }
}

/* Fills the buffer that is not being sent, and hands it over when the other is. */
static int wires_pixels(struct hal_bus *bus, const void *pixels, unsigned word, uint32_t count, uint32_t rows,
                        uint32_t stride)
{
    struct wires *wires = (struct wires *)bus;
    const uint8_t *row = pixels;
    uint32_t done = 0; /* words of the row */
    if (!(wires->levels >> wires->dc & 1)) {
        int error = wires_wait(bus);
        if (!error)
            error = wires_level(wires, wires->dc, 1);
        if (error)
            return error;
    }
    while (rows && count) {
        unsigned index = wires->sending ^ 1u;
        uint32_t filled = 0;
        while (rows && filled + word <= WIRES_BUFFER) {
            uint32_t room = (WIRES_BUFFER - filled) / word, part = count - done < room ? count - done : room;
            wires_copy(wires->buffer[index] + filled, row + (size_t)done * word, word, part);
            filled += part * word;
            done += part;
            if (done == count)
                done = 0, row += stride, rows--;
        }
        int error = wires_wait(bus);
        if (error)
            return error;
        wires_start(wires, index, filled);
    }
    return 0;
}

/* That these fail is told by the next call that can say so: they are no less needed for it. */
static void wires_reset(struct hal_bus *bus, int level)
{
    struct wires *wires = (struct wires *)bus;
    int error = wires_wait(bus), set = wires_level(wires, wires->reset, level != 0);
    wires->failed = error ? error : set;
}

static void wires_backlight(struct hal_bus *bus, unsigned level)
{
    struct wires *wires = (struct wires *)bus;
    int error = wires_wait(bus), set = wires_level(wires, wires->backlight, level >= BACKLIGHT_ON);
    wires->failed = error ? error : set;
}

/* --- open and close -------------------------------------------------------------------------------------------------
 */

/* Adds a control line, low at first: D/C says command, reset resets, the backlight is off. */
static int8_t wires_line(struct wires *wires, const struct wires_pin *pin, const char *lines[], unsigned *count)
{
    if (!pin->line)
        return -1;
    wires->inverted |= (pin->inverted ? 1u : 0u) << *count;
    lines[*count] = pin->line;
    return (int8_t)(*count)++;
}

static int wires_take(struct wires *wires, const struct wires_config *config)
{
    const char *lines[3];
    unsigned count = 0;
    wires->dc = wires_line(wires, &config->dc, lines, &count);
    wires->reset = wires_line(wires, &config->reset, lines, &count);
    wires->backlight = wires_line(wires, &config->backlight, lines, &count);
    int error = pins_take(&wires->control, config->chip, lines, count, GPIO_OUTPUTS, wires->inverted, &wires->problem);
    wires->taken = !error;
    return error;
}

static int wires_begin(struct wires *wires)
{
    pthread_mutex_init(&wires->mutex, NULL);
    pthread_cond_init(&wires->change, NULL);
    int result = pthread_create(&wires->thread, NULL, wires_thread, wires);
    if (result)
        return problem_set(&wires->problem, "the sending thread: %s", strerror(result));
    wires->threaded = 1;
    return 0;
}

int wires_open(struct wires *wires, const struct wires_config *config)
{
    memset(wires, 0, sizeof *wires);
    wires->spi.descriptor = -1;
    wires->banged = config->spi == NULL;
    wires->ops = (struct hal_bus_ops){.write = wires_write, .pixels = wires_pixels, .wait = wires_wait};
    wires->bus.ops = &wires->ops;
    /* SPI first: a panel is not touched if its bytes cannot come. */
    int error = wires->banged ? bitbang_open(&wires->bitbang, config->chip, config->sck, config->mosi, config->cs,
                                             config->mode, &wires->problem)
                              : spidev_open(&wires->spi, config->spi, config->mode, config->speed, &wires->problem);
    if (!error)
        error = wires_take(wires, config);
    if (!error)
        error = wires_begin(wires);
    if (error) {
        wires_close(wires);
        return error;
    }
    if (wires->reset >= 0)
        wires->ops.reset = wires_reset;
    if (wires->backlight >= 0)
        wires->ops.backlight = wires_backlight;
    return 0;
}

/* The thread sends what it has and ends. */
static void wires_end(struct wires *wires)
{
    pthread_mutex_lock(&wires->mutex);
    wires->stop = 1;
    pthread_cond_broadcast(&wires->change);
    pthread_mutex_unlock(&wires->mutex);
    pthread_join(wires->thread, NULL);
    pthread_cond_destroy(&wires->change);
    pthread_mutex_destroy(&wires->mutex);
    wires->threaded = 0;
}

/* The light first; twice, as it is the last that can be done. */
static int wires_safe(struct wires *wires)
{
    uint32_t light = wires->backlight >= 0 ? 1u << wires->backlight : 0;
    int dark = 0, reset = 0;
    for (int i = 0; i < 2; i++) {
        dark = gpio_set(&wires->control, wires->inverted ^ (wires->levels & ~light));
        reset = gpio_set(&wires->control, wires->inverted);
        if (!reset)
            return 0;
    }
    return problem_set(&wires->problem, "GPIO lines of '%s': %s: the panel may be lit", wires->control.label,
                       strerror(dark ? -dark : -reset));
}

int wires_close(struct wires *wires)
{
    if (wires->threaded)
        wires_end(wires);
    int error = wires->taken ? wires_safe(wires) : 0;
    gpio_close(&wires->control);
    bitbang_close(&wires->bitbang);
    spidev_close(&wires->spi);
    wires->taken = 0;
    return error;
}
