/* SPDX-License-Identifier: MIT */
/*
 * The first edge of a press or release counts at once; what follows within the time of a bounce does not, and when that
 * is over the level itself is read. So nothing is late, nothing is double, and an edge that the kernel had no room for
 * does no harm. A press that is over before anybody asks is told once nevertheless.
 */
#include "linux/keys.h"
#include "clock.h"

#include <signal.h>
#include <stddef.h>

struct keys {
    struct gpio gpio;
    uint16_t button[GPIO_LINES];
    uint32_t high;                 /* the level of a pressed button's line, in bit 0 */
    uint32_t pressed, tapped;      /* bits: lines pressed now; pressed since they were last told */
    uint32_t unsettled;            /* bits: lines that may bounce */
    uint32_t since_us[GPIO_LINES]; /* since when */
};

/* hal/input.h has one set of buttons. */
static struct keys keys;
static volatile sig_atomic_t keys_quit;

static void keys_press(unsigned line, int level)
{
    uint32_t bit = 1u << line;
    if ((uint32_t)level == keys.high) {
        keys.pressed |= bit;
        keys.tapped |= bit;
    } else
        keys.pressed &= ~bit;
}

static void keys_edges(uint32_t now)
{
    unsigned line;
    int level;
    while (gpio_edge(&keys.gpio, &line, &level) > 0)
        if (!(keys.unsettled >> line & 1)) {
            keys_press(line, level);
            keys.unsettled |= 1u << line;
            keys.since_us[line] = now;
        }
}

static void keys_settle(uint32_t now)
{
    uint32_t levels, over = 0;
    for (unsigned i = 0; i < keys.gpio.count; i++)
        if (keys.unsettled >> i & 1 && now - keys.since_us[i] >= KEYS_SETTLE_US)
            over |= 1u << i;
    if (!over || gpio_get(&keys.gpio, &levels) != 0)
        return;
    for (unsigned i = 0; i < keys.gpio.count; i++)
        if (over >> i & 1 && (levels >> i & 1) != (keys.pressed >> i & 1 ? keys.high : keys.high ^ 1))
            keys_press(i, levels >> i & 1);
    keys.unsettled &= ~over;
}

uint32_t input_buttons(void)
{
    uint32_t now = clock_us(), told = keys_quit ? HAL_QUIT : 0;
    if (keys.gpio.count) {
        keys_edges(now);
        keys_settle(now);
    }
    for (unsigned i = 0; i < keys.gpio.count; i++)
        if ((keys.pressed | keys.tapped) >> i & 1)
            told |= keys.button[i];
    keys.tapped = 0;
    return told;
}

int keys_open(const struct keys_config *config, struct problem *problem)
{
    uint32_t levels = 0;
    keys = (struct keys){.high = config->high ? 1 : 0};
    if (!config->count)
        return 0;
    for (unsigned i = 0; i < config->count; i++)
        keys.button[i] = config->button[i];
    int error = pins_take(&keys.gpio, config->chip, config->line, config->count,
                          config->high ? GPIO_PULLED_DOWN : GPIO_PULLED_UP, 0, problem);
    /* What cannot be read now will be told by its edges. */
    if (!error && gpio_get(&keys.gpio, &levels) == 0)
        keys.pressed = (config->high ? levels : ~levels) & ((1u << config->count) - 1);
    return error;
}

void keys_close(void)
{
    gpio_close(&keys.gpio);
}

static void keys_note(int signal)
{
    (void)signal;
    keys_quit = 1;
}

void keys_catch_signals(void)
{
    static const int numbers[] = {SIGINT, SIGTERM, SIGHUP};
    struct sigaction note = {.sa_handler = keys_note, .sa_flags = SA_RESTART}, old;
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++)
        if (sigaction(numbers[i], NULL, &old) == 0 && old.sa_handler != SIG_IGN)
            sigaction(numbers[i], &note, NULL);
    signal(SIGPIPE, SIG_IGN); /* a reader of the reports that goes away is no reason to leave the panel lit */
}
