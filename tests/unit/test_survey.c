/* SPDX-License-Identifier: MIT */
#include "report/survey.h"

#include "glint.h"
#include "reference/reference.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "pack_case.h"
#include "random.h"

#define ROWS 24

static const char *const names[ROWS] = {"a", "b", "c", "d", "e", "f", "g", "h", "i", "j", "k", "l",
                                        "m", "n", "o", "p", "q", "r", "s", "t", "u", "v", "w", "x"};

static const struct survey_row *find(const struct survey_row *rows, const char *name)
{
    for (unsigned i = 0; i < ROWS; i++)
        if (strcmp(rows[i].method, name) == 0)
            return &rows[i];
    return NULL;
}

/* Few different values, so that ties are many. */
static void draw_rows(struct survey_row *rows)
{
    for (unsigned i = 0; i < ROWS; i++) {
        rows[i] = (struct survey_row){.method = names[i], .error.rms = random_between(0, 8)};
        for (int cpu = 0; cpu < COSTS_CPUS; cpu++)
            rows[i].instructions[cpu] = (uint32_t)random_between(1, 9);
    }
}

static void who_is_beaten_is_beaten_by_one_of_the_set(void **state)
{
    struct survey_row rows[ROWS];
    (void)state;
    random_seed(1);
    for (int turn = 0; turn < 1000; turn++) {
        draw_rows(rows);
        survey_rank(rows, ROWS);
        for (unsigned i = 0; i < ROWS; i++)
            for (int cpu = 0; cpu < COSTS_CPUS; cpu++) {
                const struct survey_row *row = &rows[i];
                if (!row->beaten_by[cpu])
                    continue;
                const struct survey_row *by = find(rows, row->beaten_by[cpu]);
                assert_null(by->beaten_by[cpu]);
                assert_true(by->instructions[cpu] <= row->instructions[cpu] && by->error.rms <= row->error.rms);
                assert_true(by->instructions[cpu] < row->instructions[cpu] || by->error.rms < row->error.rms);
            }
    }
}

static void in_the_set_the_more_exact_is_dearer(void **state)
{
    struct survey_row rows[ROWS];
    (void)state;
    random_seed(2);
    for (int turn = 0; turn < 1000; turn++) {
        draw_rows(rows);
        survey_rank(rows, ROWS);
        for (int cpu = 0; cpu < COSTS_CPUS; cpu++) {
            unsigned members = 0;
            for (unsigned i = 0; i < ROWS; i++) {
                members += !rows[i].beaten_by[cpu];
                for (unsigned j = 0; j < ROWS; j++) {
                    const struct survey_row *a = &rows[i], *b = &rows[j];
                    if (!a->beaten_by[cpu] && !b->beaten_by[cpu] && a->error.rms < b->error.rms)
                        assert_true(a->instructions[cpu] > b->instructions[cpu]);
                }
            }
            assert_true(members > 0);
        }
    }
}

static void rows_are_sorted_by_the_first_cpu(void **state)
{
    struct survey_row rows[ROWS];
    (void)state;
    random_seed(3);
    draw_rows(rows);
    survey_rank(rows, ROWS);
    for (unsigned i = 1; i < ROWS; i++) {
        assert_true(rows[i - 1].instructions[0] <= rows[i].instructions[0]);
        if (rows[i - 1].instructions[0] == rows[i].instructions[0])
            assert_true(rows[i - 1].error.rms <= rows[i].error.rms);
    }
}

static void a_scene_is_named_by_its_file(void **state)
{
    char name[SURVEY_NAME], path[SURVEY_NAME + 1];
    (void)state;
    assert_true(survey_name("tests/scenes/torus288-persp.json", name));
    assert_string_equal(name, "torus288-persp");
    assert_true(survey_name("a_b", name));
    assert_string_equal(name, "a_b");
    static const char *const bad[] = {"", "/", "a/", "a b.json", "a<b>.json", "\"", ".json", "a.b.json"};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
        assert_false(survey_name(bad[i], name));
    memset(path, 'a', sizeof path);
    path[SURVEY_NAME] = 0;
    assert_false(survey_name(path, name));
    assert_true(survey_name(path + 1, name));
}

/* Costs of one scene of 96x72, in files, by every method. */
static void write_costs(struct case_file *frames, struct case_file *flash, const char *scene)
{
    char text[16384], *at = text;
    at += sprintf(at, "cpu,scene,method,width,height,format,instructions\n");
    for (int cpu = 0; cpu < COSTS_CPUS; cpu++)
        for (unsigned m = 0; m < glint_choice_count && at < text + 16000; m++)
            at += sprintf(at, "%s,%s,%s,96,72,grey8,%u\n", costs_cpu_names[cpu], scene, glint_choices[m].name, m + 1);
    case_write(frames, "costs.csv", text, (size_t)(at - text));
    at = text + sprintf(text, "cpu,method,bytes\n");
    for (int cpu = 0; cpu < COSTS_CPUS; cpu++)
        for (unsigned m = 0; m < glint_choice_count && at < text + 16000; m++)
            at += sprintf(at, "%s,%s,%u\n", costs_cpu_names[cpu], glint_choices[m].name, m + 100);
    case_write(flash, "flash.csv", text, (size_t)(at - text));
}

/* By the definition, from the picture and a truth drawn anew. */
static void check_row(const struct survey *survey, const struct survey_row *row, const struct reference_image *truth)
{
    double squares = 0, max = 0;
    size_t pixels = 0;
    for (size_t i = 0; i < (size_t)truth->width * truth->height; i++) {
        const uint8_t *rgb = row->difference + 3 * i;
        double difference = row->grey[i] - 255 * truth->value[i], shown = fmin(255, SURVEY_GAIN * fabs(difference));
        int brightest = rgb[0] > rgb[2] ? rgb[0] : rgb[2];
        assert_true(fabs(brightest - shown) <= .5);
        assert_true(shown < 2 || (rgb[0] > rgb[2]) == (difference > 0));
        if (!truth->covered[i])
            continue;
        squares += difference * difference;
        max = fmax(max, fabs(difference));
        pixels++;
    }
    assert_int_equal(row->error.pixels, pixels);
    assert_true(fabs(row->error.max - max) < 1e-9 && fabs(row->error.rms - sqrt(squares / (double)pixels)) < 1e-9);
    assert_true(fabs(row->error.psnr_db - 20 * log10(255 / row->error.rms)) < 1e-9);
    assert_int_equal(survey->truth[0], reference_byte(truth->value[0]));
}

static void differences_are_from_the_truth_before_it_is_rounded(void **state)
{
    const char *methods[64];
    struct case_file frames, flash;
    struct costs costs;
    struct survey survey;
    struct pack_result packed;
    struct reference_image truth;
    (void)state;
    assert_true(glint_choice_count <= 64);
    for (unsigned m = 0; m < glint_choice_count; m++)
        methods[m] = glint_choices[m].name;
    write_costs(&frames, &flash, "tiny");
    assert_int_equal(costs_read(&costs, frames.path, flash.path), 0);
    assert_int_equal(survey_open(&survey, "tests/scenes/tiny.json", methods, glint_choice_count, &costs), 0);
    assert_int_equal(pack_load("tests/scenes/tiny.json", NULL, &packed), 0);
    assert_true(reference_render(packed.scene, &(struct reference_options){.grey = true}, &truth));
    assert_int_equal(survey.count, glint_choice_count);
    for (unsigned i = 0; i < survey.count; i++) {
        const struct survey_row *row = &survey.rows[i];
        assert_string_equal(row->method, methods[i]); /* by cost, which grows with the place in the list */
        assert_int_equal(row->instructions[COSTS_M0PLUS], i + 1);
        assert_int_equal(row->flash[COSTS_M3], i + 100);
        check_row(&survey, row, &truth);
    }
    reference_free(&truth);
    pack_free(&packed);
    survey_free(&survey);
    costs_free(&costs);
    case_remove(&frames);
    case_remove(&flash);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(who_is_beaten_is_beaten_by_one_of_the_set),
        cmocka_unit_test(in_the_set_the_more_exact_is_dearer),
        cmocka_unit_test(rows_are_sorted_by_the_first_cpu),
        cmocka_unit_test(a_scene_is_named_by_its_file),
        cmocka_unit_test(differences_are_from_the_truth_before_it_is_rounded),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
