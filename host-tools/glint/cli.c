/* SPDX-License-Identifier: MIT */
#include "glint/cli.h"

#include "glint.h"
#include "host/numbers.h"

#include <math.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

const char *const cli_formats[] = {"rgb565", "rgb888", "grey8", "grey4"};
const char *const cli_textures[GLINT_TEXTURES] = {"default", "affine", "quadratic", "split", "perspective"};

int cli_usage(const char *command, const char *format, ...)
{
    va_list arguments;
    fprintf(stderr, "%s: ", command);
    va_start(arguments, format);
    vfprintf(stderr, format, arguments);
    va_end(arguments);
    fprintf(stderr, "; try '%s --help'\n", command);
    return CLI_BAD_USAGE;
}

int cli_refuse(const char *command, const char *help, const char *name, const char *value)
{
    char option[32];
    snprintf(option, sizeof option, "--%s", name);
    const char *line = strstr(help, option);
    line = line ? line : option;
    int all = (int)strcspn(line, "\n"), left = 0; /* the left column ends in two spaces */
    while (left < all && strncmp(line + left, "  ", 2) != 0)
        left++;
    int right = left + (int)strspn(line + left, " ");
    fprintf(stderr, "%s: '%s' will not do for %.*s: %.*s", command, value, left, line, all - right, line + right);
    for (line += all; *line == '\n' && strspn(line + 1, " ") >= 8; line += all) { /* goes on in that column */
        line += 1 + strspn(line + 1, " ");
        all = (int)strcspn(line, "\n");
        fprintf(stderr, " %.*s", all, line);
    }
    fputs("\n", stderr);
    return CLI_BAD_USAGE;
}

bool cli_number(const char *text, uint32_t low, uint32_t high, uint32_t *value)
{
    return numbers_whole(text, low, high, value);
}

/* Decimal digits, times 256 and rounded: false if that is outside 1..most. */
static bool cli_parts_of_256(const char *text, uint32_t most, uint32_t *value)
{
    char *end;
    size_t plain = strspn(text, "0123456789.");
    double number = strtod(text, &end) * 256;
    if (plain == 0 || text[plain] || end != text + plain || number < 1 || number >= most + .5)
        return false;
    *value = (uint32_t)(number + .5);
    return true;
}

bool cli_fraction(const char *text, uint8_t *value)
{
    uint32_t number;
    bool good = cli_parts_of_256(text, 255, &number);
    if (good)
        *value = (uint8_t)number;
    return good;
}

bool cli_budget(const char *text, uint16_t *value)
{
    uint32_t number;
    bool good = cli_parts_of_256(text, 255u << 8, &number);
    if (good)
        *value = (uint16_t)number;
    return good;
}

bool cli_size(const char *text, uint16_t *width, uint16_t *height)
{
    return numbers_size(text, GLINT_MAX_SIZE, width, height);
}

/* Decimal degrees up to `stop`; returns where it stands, or null. */
static const char *cli_angle(const char *text, char stop, uint16_t *angle)
{
    size_t plain = strspn(text, "-0123456789.");
    char *end;
    double degrees = strtod(text, &end);
    if (plain == 0 || end != text + plain || *end != stop || degrees < -360 || degrees > 360)
        return NULL;
    *angle = (uint16_t)(lrint(degrees * 65536 / 360) & 65535);
    return end;
}

bool cli_turn(const char *text, uint16_t *yaw, uint16_t *pitch)
{
    uint16_t right, up;
    const char *comma = cli_angle(text, ',', &right);
    if (!comma || !cli_angle(comma + 1, 0, &up))
        return false;
    *yaw = right;
    *pitch = up;
    return true;
}

int cli_choice(const char *text, const char *const names[], int count)
{
    for (int i = 0; i < count; i++)
        if (strcmp(text, names[i]) == 0)
            return i;
    return -1;
}

static volatile sig_atomic_t cli_signal;

static void cli_note_signal(int number)
{
    cli_signal = number;
}

void cli_catch_signals(void)
{
    static const int numbers[] = {SIGINT, SIGTERM, SIGHUP, SIGQUIT};
    struct sigaction note = {.sa_handler = cli_note_signal}, old; /* without SA_RESTART: a write to a full pipe ends */
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++)
        if (sigaction(numbers[i], NULL, &old) == 0 && old.sa_handler != SIG_IGN) /* nohup and its like */
            sigaction(numbers[i], &note, NULL);
}

int cli_interrupted(void)
{
    return cli_signal;
}

double cli_clock(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec * 1e3 + (double)now.tv_nsec * 1e-6;
}
