/* SPDX-License-Identifier: MIT */
/*
 * What the fixed-point choices are worth: scenes drawn by the renderer with one part of it exchanged (wraps.h), against
 * the truth in double precision.
 *   choices SCENE.json...    CSV lines `choice,value,where,figure,number`, under that head
 */
#include "glint/renderer.h"
#include "pack/pack.h"
#include "reference/reference.h"
#include "report/drawing.h"
#include "report/survey.h"
#include "scene/model.h"
#include "shade/power.h"
#include "tests/choices/wraps.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define CHOICES_LARGE  1024 /* pixels across: the other size at which fraction bits are looked at */
#define CHOICES_ODD    7u /* the truth of sub-pixels is the middle of so many, either way, and its grid as much finer */
#define CHOICES_PLACES (1 << 16)
#define COUNT(array)   (sizeof(array) / sizeof *(array))

static const unsigned choices_exponents[] = {5, 20, 50, 200, 1000};

/* A scene, and its truth at one size. */
struct choices_scene {
    const char *path;
    char name[SURVEY_NAME];
    struct pack_result packed;
    struct reference_image truth; /* of the size in hand, over pixels 1/`odd` of its own */
    unsigned odd;
};

static void choices_line(const char *choice, const char *value, const char *where, const char *figure, double number)
{
    printf("%s,%s,%s,%s,%.6g\n", choice, value, where, figure, number);
}

/* --- pictures --------------------------------------------------------------------------------------------------- */

struct choices_picture {
    struct hal_display display;
    unsigned width, height;
    uint8_t *grey;
};

static int choices_flush(struct hal_display *display, const void *pixels, uint16_t y, uint16_t rows, uint32_t stride)
{
    const struct choices_picture *p = (const struct choices_picture *)display;
    for (unsigned row = 0; row < rows; row++)
        memcpy(p->grey + (size_t)(y + row) * p->width, (const uint8_t *)pixels + (size_t)row * stride, p->width);
    return 0;
}

static const struct hal_display_ops choices_ops = {.flush = choices_flush};

static int choices_truth(struct choices_scene *s, unsigned width, unsigned odd)
{
    const struct scene_camera *camera = &s->packed.scene->camera;
    const unsigned height = width * camera->reference_height / camera->reference_width;
    const struct reference_options options = {.width = width * odd, .height = height * odd, .grey = true};
    reference_free(&s->truth);
    s->odd = odd;
    if (reference_render(s->packed.scene, &options, &s->truth))
        return 0;
    s->truth = (struct reference_image){0};
    fprintf(stderr, "%s: out of memory\n", s->path);
    return 3;
}

/* Draws the scene at the truth's size, as wraps.h has it set, and compares what both cover. `strays`, if not null:
 * pixels that only one of them covers. */
static int choices_draw(const struct choices_scene *s, const char *method, const struct glint_power *power,
                        struct compare_result *error, double *strays)
{
    const unsigned finer = wraps.subpixel > WRAPS_SUBPIXEL_OWN ? 1u << (wraps.subpixel - WRAPS_SUBPIXEL_OWN) : 1;
    const unsigned width = s->truth.width / s->odd, height = s->truth.height / s->odd;
    struct choices_picture picture = {{&choices_ops}, width * finer, height * finer, NULL};
    struct renderer renderer = {.choice = renderer_find(method),
                                .config = {.width = (uint16_t)picture.width,
                                           .height = (uint16_t)picture.height,
                                           .band_rows = (uint16_t)picture.height,
                                           .format = GLINT_GREY8,
                                           .power = power}};
    double milliseconds = 0;
    int code = renderer_open(&renderer, s->packed.scene);
    if (code)
        return code;
    const size_t pixels = (size_t)width * height;
    double *a = model_alloc(2 * pixels * sizeof *a), *b = a + pixels;
    uint8_t *both = model_alloc(pixels), background;
    picture.grey = model_alloc((size_t)picture.width * picture.height);
    renderer_draw(&renderer, 0, &picture.display, NULL, &milliseconds);
    background = picture.grey[0];
    *strays = 0;
    for (unsigned y = 0; y < height; y++)
        for (unsigned x = 0; x < width; x++) {
            const size_t i = (size_t)y * width + x, own = (size_t)y * finer * picture.width + x * finer,
                         true_one = (size_t)(y * s->odd + s->odd / 2) * s->truth.width + x * s->odd + s->odd / 2;
            const bool drawn = picture.grey[own] != background;
            a[i] = picture.grey[own];
            b[i] = 255 * s->truth.value[true_one];
            both[i] = drawn && s->truth.covered[true_one];
            *strays += drawn != (s->truth.covered[true_one] != 0);
        }
    compare_values(a, b, both, pixels, 1, error);
    free(a);
    free(both);
    free(picture.grey);
    renderer_close(&renderer);
    return code;
}

static int choices_picture(const struct choices_scene *s, const char *choice, const char *value, const char *method,
                           const struct glint_power *power)
{
    struct compare_result error;
    double strays;
    char where[SURVEY_NAME + 16];
    int code = choices_draw(s, method, power, &error, &strays);
    if (code)
        return code;
    snprintf(where, sizeof where, "%s %u", s->name, s->truth.width / s->odd);
    choices_line(choice, value, where, "psnr_db", error.psnr_db);
    choices_line(choice, value, where, "max", error.max);
    if (strcmp(choice, "subpixel") == 0 || strcmp(choice, "reciprocal") == 0)
        choices_line(choice, value, where, "strays", strays);
    return 0;
}

/* --- fraction bits ---------------------------------------------------------------------------------------------- */

static int choices_fraction_at(struct choices_scene *s, unsigned width)
{
    struct compare_result error;
    double strays;
    char value[16], where[SURVEY_NAME + 16];
    int code = choices_truth(s, width, 1);
    snprintf(where, sizeof where, "%s %u", s->name, width);
    wraps_begin();
    wraps.model = true;
    if (!code)
        code = choices_draw(s, "six", NULL, &error, &strays);
    const struct wraps model = wraps;
    for (unsigned bits = WRAPS_FRACTION_LEAST; !code && bits <= WRAPS_FRACTION_MOST; bits++) {
        snprintf(value, sizeof value, "%u", bits);
        choices_line("fraction", value, where, "error", model.error[bits]);
        wraps_begin();
        wraps.fraction = bits;
        if (bits <= WRAPS_FRACTION_OWN)
            code = choices_picture(s, "fraction", value, "six", NULL);
    }
    choices_line("fraction", "22", where, "largest", model.largest);
    return code;
}

/* --- sub-pixel bits --------------------------------------------------------------------------------------------- */

static int choices_subpixel(struct choices_scene *s, bool first)
{
    char value[16];
    int code = choices_truth(s, s->packed.scene->camera.reference_width, CHOICES_ODD);
    for (unsigned bits = 2; !code && bits <= 6; bits++) {
        wraps_begin();
        wraps.subpixel = bits;
        snprintf(value, sizeof value, "%u", bits);
        code = choices_picture(s, "subpixel", value, "phong", NULL);
        if (first) /* determinants have 32 bits: coordinates differ by 2^15 at most */
            choices_line("subpixel", value, "picture", "pixels", 32768 >> bits);
    }
    return code;
}

/* --- reciprocals and roots -------------------------------------------------------------------------------------- */

/* `power`: its form; any keeps a method from loops of its own, which may look up what the series gives. */
static int choices_series(struct choices_scene *s, const char *choice, const struct parts_choice *parts, unsigned count,
                          const char *method, const struct glint_power *power)
{
    const bool root = strcmp(choice, "root") == 0;
    int code = choices_truth(s, s->packed.scene->camera.reference_width, 1);
    for (unsigned i = 0; !code && i < count; i++) {
        wraps_begin();
        *(root ? &wraps.root : &wraps.reciprocal) = parts[i].run;
        code = choices_picture(s, choice, parts[i].name, method, power);
        const unsigned long calls = root ? wraps.roots : wraps.reciprocals;
        if (!code && calls == 0) {
            fprintf(stderr, "%s: %s draws without a %s\n", s->path, method, choice);
            code = 1;
        }
        choices_line(choice, parts[i].name, s->name, "calls", (double)calls);
    }
    return code;
}

static void choices_functions(void)
{
    for (unsigned i = 0; i < PARTS_RECIPROCALS; i++) {
        double most = 0;
        for (uint32_t k = 0; k < CHOICES_PLACES; k++) {
            uint32_t m = 0x80000000u + k * (0x80000000u / CHOICES_PLACES) + k % 32768;
            most = fmax(most, fabs(parts_reciprocals[i].run(m) * (double)m / 0x1p63 - 1));
        }
        choices_line("reciprocal", parts_reciprocals[i].name, "function", "bits", -log2(most));
    }
    for (unsigned i = 0; i < PARTS_ROOTS; i++) {
        double most = 0;
        for (uint32_t k = 0; k < CHOICES_PLACES; k++) {
            uint32_t m = 0x40000000u + k * (0xc0000000u / CHOICES_PLACES) + k % 32768;
            most = fmax(most, fabs(parts_roots[i].run(m) * sqrt(m) / 0x1p46 - 1));
        }
        choices_line("root", parts_roots[i].name, "function", "bits", -log2(most));
    }
}

/* --- power tables ----------------------------------------------------------------------------------------------- */

static struct {
    struct parts_table table;
    unsigned bits, exponent;
    int nearest;
} choices_power_now;

static void choices_power_set(unsigned bits, int nearest)
{
    choices_power_now.bits = bits;
    choices_power_now.nearest = nearest;
    choices_power_now.exponent = 0;
}

/* As struct glint_power has it. */
static void choices_power_run(unsigned n, int32_t *value, int count)
{
    if (n != choices_power_now.exponent)
        parts_power_build(&choices_power_now.table, n, choices_power_now.bits);
    choices_power_now.exponent = n;
    for (int i = 0; i < count; i++)
        value[i] =
            (int32_t)parts_power(&choices_power_now.table, value[i], choices_power_now.bits, choices_power_now.nearest);
}

static const struct glint_power choices_power_form = {choices_power_run, 0, 0, 0};

static double choices_power_error(unsigned n)
{
    double most = 0;
    for (int32_t i = 0; i <= CHOICES_PLACES; i++) {
        int32_t value = i * ((1 << 30) / CHOICES_PLACES);
        choices_power_run(n, &value, 1);
        most = fmax(most, fabs(value / 32768. - pow((double)i / CHOICES_PLACES, n)));
    }
    return 255 * most;
}

static int choices_powers(struct choices_scene *s, bool functions)
{
    char value[32], where[16];
    int code = choices_truth(s, s->packed.scene->camera.reference_width, 1);
    wraps_begin();
    for (int nearest = 0; nearest <= 1; nearest++)
        for (unsigned bits = PARTS_POWER_LEAST; !code && bits <= PARTS_POWER_MOST; bits++) {
            snprintf(value, sizeof value, "%u %s", 1u << bits, nearest ? "nearest" : "interpolated");
            choices_power_set(bits, nearest);
            for (unsigned e = 0; functions && e < COUNT(choices_exponents); e++) {
                snprintf(where, sizeof where, "n = %u", choices_exponents[e]);
                choices_line("power", value, where, "error", choices_power_error(choices_exponents[e]));
            }
            if (functions)
                choices_line("power", value, "table", "bytes", 2. * (1u << bits) + 4 + (nearest ? 2 : 4));
            code = choices_picture(s, "power", value, "phong", &choices_power_form);
        }
    return code;
}

static int choices_scene(struct choices_scene *s, bool first)
{
    int code = pack_load(s->path, NULL, &s->packed);
    if (code)
        return code;
    if (!survey_name(s->path, s->name)) {
        fprintf(stderr, "%s: a scene's name is of letters, digits, - and _\n", s->path);
        code = 1;
    }
    if (!code)
        code = choices_fraction_at(s, s->packed.scene->camera.reference_width);
    if (!code && first)
        code = choices_fraction_at(s, CHOICES_LARGE);
    if (!code)
        code = choices_subpixel(s, first);
    if (!code)
        code = choices_series(s, "reciprocal", parts_reciprocals, PARTS_RECIPROCALS, "six", NULL);
    choices_power_set(PARTS_POWER_OWN, 0);
    if (!code)
        code = choices_series(s, "root", parts_roots, PARTS_ROOTS, "phong", &choices_power_form);
    if (!code)
        code = choices_powers(s, first);
    reference_free(&s->truth);
    pack_free(&s->packed);
    return code;
}

int main(int argc, char **argv)
{
    int code = 0;
    if (argc < 2) {
        fprintf(stderr, "usage: choices SCENE.json...\n");
        return 2;
    }
    parts_begin();
    wraps_begin();
    printf("choice,value,where,figure,number\n");
    choices_functions();
    for (int i = 1; !code && i < argc; i++) {
        struct choices_scene s = {.path = argv[i]};
        code = choices_scene(&s, i == 1);
    }
    if (!code && fflush(stdout) != 0)
        code = 3;
    return code;
}
