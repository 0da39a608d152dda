/* SPDX-License-Identifier: MIT */
/* glint-device, whole, on the machine of linux_machine.h. The includer has taken hal/linux/gpio_v1.c or gpio_v2.c in.
 */
#ifndef LINUX_CASE_H
#define LINUX_CASE_H

#include "boards/linux/device.h"
#include "firmware/app/main.c"
#include "linux/keys.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <unistd.h>

#include <cmocka.h>

#include "listen.h"
#include "pack/pack.h"

#define CASE_SIZE    "32x24" /* pixels: the fewer, the more calls can be tried */
#define CASE_FRAMES  "4"
#define CASE_TEXT    4096
#define CASE_OPTIONS 40

static uint32_t case_blob[64 * 1024 / 4], case_length;
const struct program_scene program_scenes[] = {{"torus288", case_blob, &case_length}};
const unsigned program_scene_count = 1;

static char case_told[CASE_TEXT]; /* on standard error by the last run */

static int case_scene(void **state)
{
    struct pack_result packed;
    (void)state;
    if (pack_load("tests/scenes/torus288.json", NULL, &packed) != 0 || packed.size > sizeof case_blob)
        return 1;
    memcpy(case_blob, packed.scene, packed.size);
    case_length = (uint32_t)packed.size;
    pack_free(&packed);
    return 0;
}

/* Runs the program with options parted by spaces: its exit code, and case_told. Its reports are not listened to. */
static int case_run(const char *options)
{
    char text[1024], *arguments[CASE_OPTIONS] = {"glint-device"};
    int count = 1;
    snprintf(text, sizeof text, "%s", options);
    for (char *word = strtok(text, " "); word && count < CASE_OPTIONS - 1; word = strtok(NULL, " "))
        arguments[count++] = word;
    const struct listen reports = listen_begin(STDOUT_FILENO), errors = listen_begin(STDERR_FILENO);
    int code = device_run(count, arguments);
    listen_end(&reports, case_told, sizeof case_told);
    listen_end(&errors, case_told, sizeof case_told);
    return code;
}

static int case_messages(void)
{
    int lines = 0;
    for (const char *at = case_told; *at; at++)
        lines += *at == '\n';
    return lines;
}

static inline void assert_tells(const char *part)
{
    if (case_messages() != 1 || !strstr(case_told, part))
        fail_msg("told: '%s', not one line with '%s'", case_told, part);
}

/* Nothing is held any more; a panel that was touched is dark and in reset. */
static inline void assert_all_given_back(void)
{
    assert_int_equal(machine.taken, 0);
    assert_int_equal(machine.chips, 0);
    assert_int_equal(machine.descriptors, 0);
    assert_int_equal(machine.levels >> RESET & 1, 0);
    assert_int_equal(machine.levels >> BACKLIGHT & 1, 0);
}

#define CASE_PINS                                                                                       \
    "--chip pinctrl-test --dc dc --reset reset --backlight light --keys a=key-a,up=8 --size " CASE_SIZE \
    " --scene torus288 --figures=off --whole --frames " CASE_FRAMES
#define CASE_SPIDEV  "--panel st7789 --spi /dev/spidev0.0 " CASE_PINS
#define CASE_BANGED  "--panel ssd0323 --spi gpio --sck sck --mosi mosi --cs cs " CASE_PINS
#define CASE_ILI9341 "--panel ili9341 --spi /dev/spidev0.0 --rotate 90 " CASE_PINS

#endif
