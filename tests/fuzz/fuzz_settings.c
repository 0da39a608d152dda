/* SPDX-License-Identifier: MIT */
/* Board files of the Linux program: any bytes are settings that hold what they promise, or one message that names the
 * file's line, or what is missing, and the exit code for it. */
#define _GNU_SOURCE
#include "boards/linux/settings.h"
#include "clock.h"
#include "fuzz/fuzz.h"
#include "input.h"

#include <sys/mman.h>
#include <unistd.h>

/* The program asks where it looks at the buttons and the time; settings do not. */
uint32_t input_buttons(void)
{
    return 0;
}
uint32_t clock_us(void)
{
    return 0;
}
void clock_wait_us(uint32_t us)
{
    (void)us;
}
void app_usual(struct app_start *start)
{
    *start = (struct app_start){.control = {.scenes = 1, .methods = 1, .budget = CONTROL_BUDGET, .running = 1}};
}

static void in_range(const struct settings *s)
{
    if (s->task == SETTINGS_LIST || s->task == SETTINGS_HELP || s->bare)
        return;
    const struct panel_controller *c = s->controller;
    FUZZ_CHECK(c && s->wires.chip && s->wires.dc.line && (s->wires.spi || (s->wires.sck && s->wires.mosi)));
    FUZZ_CHECK(s->width && s->height && s->offset_x + s->width <= c->columns && s->offset_y + s->height <= c->rows);
    FUZZ_CHECK(s->wires.dc.line[0] && s->wires.speed >= 1);
    FUZZ_CHECK(s->rotation % 90 == 0 && s->rotation < 360 && s->start.control.budget >= 1);
    FUZZ_CHECK(s->keys.count <= sizeof s->keys.line / sizeof *s->keys.line);
    for (unsigned i = 0; i < s->keys.count; i++)
        FUZZ_CHECK(s->keys.line[i] && s->keys.line[i][0]);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    char path[32], program[] = "glint-device", option[] = "--board", *told = NULL;
    char *arguments[] = {program, option, path, NULL};
    size_t told_size = 0;
    struct settings settings;
    FILE *was = stderr, *heard = open_memstream(&told, &told_size);
    int file = memfd_create("board", 0);
    FUZZ_CHECK(file >= 0 && write(file, data, size) == (ssize_t)size);
    snprintf(path, sizeof path, "/proc/self/fd/%d", file);
    FUZZ_CHECK(heard);
    stderr = heard;
    int code = settings_read(&settings, 3, arguments);
    fclose(heard);
    stderr = was;
    close(file);
    const char *end = strchr(told, '\n');
    if (code == -1) {
        FUZZ_CHECK(told_size == 0);
        in_range(&settings);
    } else if (code == SETTINGS_BAD_DATA) {
        FUZZ_CHECK(end && !end[1] && strncmp(told, path, strlen(path)) == 0);
    } else {
        FUZZ_CHECK(code == SETTINGS_BAD_USAGE && end && !end[1]);
    }
    free(settings.text);
    free(told);
    return 0;
}
