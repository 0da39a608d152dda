/* SPDX-License-Identifier: MIT */
#include "linux/bitbang.h"
#include "display.h"

#include <string.h>

/* The order of the lines in the request, and so of the bits of their levels. */
#define SCK  1u
#define MOSI 2u
#define CS   4u

/* The clock's level while nothing is sent, and the level it has when the data line is set: the other half of a bit's
 * time the receiver samples it. */
static uint32_t bitbang_rest(const struct bitbang *bitbang)
{
    return bitbang->mode & 2 ? SCK : 0;
}
static uint32_t bitbang_lead(const struct bitbang *bitbang)
{
    return bitbang->mode == 1 || bitbang->mode == 2 ? SCK : 0;
}

int bitbang_open(struct bitbang *bitbang, const char *chip, const char *sck, const char *mosi, const char *cs,
                 unsigned mode, struct problem *problem)
{
    const char *lines[] = {sck, mosi, cs};
    *bitbang = (struct bitbang){.mode = mode, .selects = cs != NULL};
    return pins_take(&bitbang->gpio, chip, lines, cs ? 3 : 2, GPIO_OUTPUTS, bitbang_rest(bitbang) | CS, problem);
}

int bitbang_send(struct bitbang *bitbang, const uint8_t *bytes, uint32_t count, struct problem *problem)
{
    const uint32_t lead = bitbang_lead(bitbang), rest = bitbang_rest(bitbang);
    struct gpio *gpio = &bitbang->gpio;
    int result = bitbang->selects ? gpio_set(gpio, rest) : 0;
    for (uint32_t i = 0; i < count && !result; i++)
        for (int bit = 7; bit >= 0 && !result; bit--) {
            uint32_t data = bytes[i] >> bit & 1 ? MOSI : 0;
            result = gpio_set(gpio, data | lead);
            if (!result)
                result = gpio_set(gpio, data | (lead ^ SCK));
        }
    /* Also after an error: a panel that is not selected takes what follows for a beginning. */
    if (bitbang->selects || lead == rest) {
        int last = gpio_set(gpio, rest | CS);
        result = result ? result : last;
    }
    return result ? problem_set(problem, "GPIO lines of '%s': %s", gpio->label, strerror(-result)) : 0;
}

void bitbang_close(struct bitbang *bitbang)
{
    gpio_close(&bitbang->gpio);
}
