/* SPDX-License-Identifier: MIT */
#include "report/choices.h"

#include "glint/cli.h"
#include "report/csv.h"
#include "scene/model.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#define CHOICES_NAME 64
#define COUNT(array) (sizeof(array) / sizeof *(array))

struct choices_row {
    char choice[16], value[24], where[CHOICES_NAME], figure[16];
    double number;
};

struct choices {
    const char *path;
    struct choices_row *rows;
    size_t count, room;
};

static const char choices_head[] = "choice,value,where,figure,number";

static const char *choices_take(void *context, char *field[CSV_FIELDS], unsigned line)
{
    struct choices *choices = context;
    struct choices_row row;
    char *end;
    (void)line;
    const char *problem = csv_name(row.choice, sizeof row.choice, field[0], "");
    if (!problem)
        problem = csv_name(row.value, sizeof row.value, field[1], " ");
    if (!problem)
        problem = csv_name(row.where, sizeof row.where, field[2], " -_=");
    if (!problem)
        problem = csv_name(row.figure, sizeof row.figure, field[3], "_");
    if (problem)
        return problem;
    row.number = strtod(field[4], &end);
    if (end == field[4] || *end || !isfinite(row.number))
        return "the number is none";
    choices->rows = model_grow(choices->rows, choices->count, &choices->room, sizeof row);
    choices->rows[choices->count++] = row;
    return NULL;
}

/* Null where any of the first three is any. */
static const struct choices_row *choices_find(const struct choices *choices, const char *choice, const char *value,
                                              const char *where, const char *figure)
{
    for (size_t i = 0; i < choices->count; i++) {
        const struct choices_row *row = &choices->rows[i];
        if (strcmp(row->choice, choice) == 0 && (!value || strcmp(row->value, value) == 0) &&
            (!where || strcmp(row->where, where) == 0) && (!figure || strcmp(row->figure, figure) == 0))
            return row;
    }
    return NULL;
}

static double choices_number(const struct choices *choices, const char *choice, const char *value, const char *where,
                             const char *figure)
{
    const struct choices_row *row = choices_find(choices, choice, value, where, figure);
    return row ? row->number : NAN;
}

/* The largest of a figure wherever it was measured. */
static double choices_most(const struct choices *choices, const char *choice, const char *value, const char *figure)
{
    double most = NAN;
    for (size_t i = 0; i < choices->count; i++) {
        const struct choices_row *row = &choices->rows[i];
        if (strcmp(row->choice, choice) == 0 && strcmp(row->value, value) == 0 && strcmp(row->figure, figure) == 0)
            most = fmax(most, row->number); /* of a number and NAN, the number */
    }
    return most;
}

/* By how many dB a picture is worse than with another value: the most of any. */
static double choices_loss(const struct choices *choices, const char *choice, const char *value, const char *best)
{
    double most = 0;
    for (size_t i = 0; i < choices->count; i++) {
        const struct choices_row *row = &choices->rows[i];
        if (strcmp(row->choice, choice) == 0 && strcmp(row->value, value) == 0 && strcmp(row->figure, "psnr_db") == 0)
            most = fmax(most, choices_number(choices, choice, best, row->where, "psnr_db") - row->number);
    }
    return most;
}

static double choices_calls(const struct choices *choices, const char *choice)
{
    return choices_most(choices, choice, "table", "calls");
}

static double choices_count(const struct choices *choices, const char *choice, const char *value, const char *cpu)
{
    return choices_number(choices, choice, value, cpu, "instructions");
}

/* --- tables ----------------------------------------------------------------------------------------------------- */

/* To be read: of a figure, or where it is one of a CPU. */
static const char *choices_title(const char *name)
{
    static const char *const titles[][2] = {{"psnr_db", "dB"},
                                            {"max", "largest"},
                                            {"error", "error"},
                                            {"strays", "pixels astray"},
                                            {"bits", "bits"},
                                            {"calls", "calls a frame"},
                                            {"pixels", "pixels across"},
                                            {"instructions", "instructions"},
                                            {"bytes", "bytes"},
                                            {"m3", "M3"},
                                            {"m0plus", "M0+"}};
    for (size_t i = 0; i < COUNT(titles); i++)
        if (strcmp(titles[i][0], name) == 0)
            return titles[i][1];
    return name;
}

static void choices_cell(FILE *out, const char *figure, double number)
{
    if (isnan(number))
        fprintf(out, "<td></td>");
    else if (strcmp(figure, "error") == 0)
        fprintf(out, number < .01 ? "<td>%.1e</td>" : "<td>%.2f</td>", number);
    else if (strcmp(figure, "psnr_db") == 0 || strcmp(figure, "instructions") == 0 || strcmp(figure, "bits") == 0)
        fprintf(out, "<td>%.1f</td>", number);
    else if (strcmp(figure, "max") == 0)
        fprintf(out, "<td>%.2f</td>", number);
    else
        fprintf(out, "<td>%.0f</td>", number);
}

/* Whether row i is the first of its choice with this value, or with this column. */
static bool choices_first(const struct choices *choices, size_t i, bool column)
{
    const struct choices_row *row = &choices->rows[i];
    const struct choices_row *first = column ? choices_find(choices, row->choice, NULL, row->where, row->figure)
                                             : choices_find(choices, row->choice, row->value, NULL, NULL);
    return first == row && strcmp(row->figure, "largest") != 0;
}

static void choices_table(FILE *out, const struct choices *choices, const char *choice, const char *title)
{
    fprintf(out, "<div class=\"wide\"><table>\n<tr><th>%s</th>", title);
    for (size_t i = 0; i < choices->count; i++)
        if (strcmp(choices->rows[i].choice, choice) == 0 && choices_first(choices, i, true))
            fprintf(out, "<th>%s,<br>%s</th>", choices_title(choices->rows[i].where),
                    choices_title(choices->rows[i].figure));
    fprintf(out, "</tr>\n");
    for (size_t i = 0; i < choices->count; i++) {
        const struct choices_row *row = &choices->rows[i];
        if (strcmp(row->choice, choice) != 0 || !choices_first(choices, i, false))
            continue;
        fprintf(out, "<tr><td>%s</td>", row->value);
        for (size_t k = 0; k < choices->count; k++) {
            const struct choices_row *column = &choices->rows[k];
            if (strcmp(column->choice, choice) == 0 && choices_first(choices, k, true))
                choices_cell(out, column->figure,
                             choices_number(choices, choice, row->value, column->where, column->figure));
        }
        fprintf(out, "</tr>\n");
    }
    fprintf(out, "</table></div>\n");
}

/* --- what to choose --------------------------------------------------------------------------------------------- */

static void choices_fraction(FILE *out, const struct choices *c)
{
    char value[16];
    unsigned enough = 24;
    for (unsigned bits = 24; bits >= 14; bits--) {
        snprintf(value, sizeof value, "%u", bits);
        enough = choices_most(c, "fraction", value, "error") < .125 ? bits : enough;
    }
    fprintf(
        out,
        "<p><b>What to choose: 22.</b> N\u00b7L and N\u00b7H are in units of 1/256 of full intensity, so that a word "
        "of 32 bits holds 8 before the point and 22 behind it, with a sign and one bit for sums beyond 1: all 22 are "
        "free. Rounded to fewer, coefficients err more the farther a pixel is from where they were made: %u bits are "
        "the fewest whose error stays below 1/8 of a step in all pictures here; at 14 it is %.2f. More than "
        "22 want two words: a pixel\u2019s two additions and store then take %.0f instructions instead of %.0f on M3, "
        "%.0f instead of %.0f on M0+, for an error that already does not show (%.3f). That error is the model\u2019s "
        "(the same triangles, coefficients in double precision, rounded); pictures are the renderer\u2019s, by six, "
        "with its coefficients rounded.</p>\n",
        enough, choices_most(c, "fraction", "14", "error"), choices_count(c, "fraction", "24", "m3"),
        choices_count(c, "fraction", "22", "m3"), choices_count(c, "fraction", "24", "m0plus"),
        choices_count(c, "fraction", "22", "m0plus"), choices_most(c, "fraction", "22", "error"));
}

static void choices_subpixel(FILE *out, const struct choices *c)
{
    fprintf(
        out,
        "<p><b>What to choose: 4</b>, for pictures up to %.0f pixels. No bit costs an instruction, but each halves "
        "the largest picture, as determinants are products of coordinates and have 32 bits; 3, 4, 5 and 6 leave "
        "%.0f, %.0f, %.0f and %.0f pixels across. What they buy are edges: with 2 to 6 bits at most %.0f, %.0f, "
        "%.0f, %.0f and %.0f pixels of these pictures are on the wrong side of one, and a slow edge jumps by 1/4 to "
        "1/64 of a pixel. Inside, 2 bits lose up to %.1f dB against 6, 4 "
        "bits %.1f, most of it where one part of an object hides another. The truth has seven times as fine a grid as "
        "4 bits. Fewer than 4 are the renderer\u2019s corners rounded; more are its pictures of twice and four times "
        "the size, of which the pixels with the same centres are taken; by phong.</p>\n",
        choices_number(c, "subpixel", "4", "picture", "pixels"),
        choices_number(c, "subpixel", "3", "picture", "pixels"),
        choices_number(c, "subpixel", "4", "picture", "pixels"),
        choices_number(c, "subpixel", "5", "picture", "pixels"),
        choices_number(c, "subpixel", "6", "picture", "pixels"), choices_most(c, "subpixel", "2", "strays"),
        choices_most(c, "subpixel", "3", "strays"), choices_most(c, "subpixel", "4", "strays"),
        choices_most(c, "subpixel", "5", "strays"), choices_most(c, "subpixel", "6", "strays"),
        choices_loss(c, "subpixel", "2", "6"), choices_loss(c, "subpixel", "4", "6"));
}

static void choices_power(FILE *out, const struct choices *c)
{
    const char *own = "128 interpolated", *half = "64 interpolated", *nearest = "1024 nearest";
    fprintf(
        out,
        "<p><b>What to choose: 128 steps, interpolated</b>: %.0f bytes a material\u2019s exponent and at most %.2f of "
        "a step over all exponents here, of which up to %.2f is what lies below the table and counts as 0. Half of "
        "them err by %.2f, twice as many gain nothing that 8 bits show. The nearest "
        "entry saves %.0f instructions a lit pixel on M3 and %.0f on M0+, and errs by %.1f with 128 steps; to come to "
        "%.1f it wants %.0f bytes: worth it where many pixels are in highlights, the CPU is an M0+ and flash is not "
        "short. Steps are spread over the part of 0..1 where the power shows; instructions are a pixel\u2019s, loop "
        "and "
        "store included; pictures by phong.</p>\n",
        choices_number(c, "power", own, "table", "bytes"), choices_most(c, "power", own, "error"),
        choices_most(c, "power", "1024 interpolated", "error"), choices_most(c, "power", half, "error"),
        choices_count(c, "power", own, "m3") - choices_count(c, "power", nearest, "m3"),
        choices_count(c, "power", own, "m0plus") - choices_count(c, "power", nearest, "m0plus"),
        choices_most(c, "power", "128 nearest", "error"), choices_most(c, "power", nearest, "error"),
        choices_number(c, "power", nearest, "table", "bytes"));
}

static void choices_reciprocal(FILE *out, const struct choices *c)
{
    const char *name = "reciprocal";
    const double calls = choices_calls(c, name), bits = choices_most(c, name, "1 term", "bits");
    fprintf(
        out,
        "<p><b>What to choose: three terms</b> after a table of 256 bytes. There is one reciprocal a triangle, and one "
        "a vertex in perspective: at most %.0f a picture here, so that the third term takes %.0f instructions of a "
        "frame on M3 and %.0f on M0+, an exact quotient bit by bit %.0f thousand. Against it the table alone loses up "
        "to "
        "%.2f dB and in perspective moves edges, %.0f pixels; one term loses %.2f dB and moves %.0f, two %.2f and "
        "%.0f. The "
        "third is for what these pictures do not show: an end 2048 pixels away, where one term errs by %.2f of a "
        "sub-pixel. By six.</p>\n",
        calls, calls * (choices_count(c, name, "3 terms", "m3") - choices_count(c, name, "2 terms", "m3")),
        calls * (choices_count(c, name, "3 terms", "m0plus") - choices_count(c, name, "2 terms", "m0plus")),
        calls * choices_count(c, name, "exact", "m3") / 1000, choices_loss(c, name, "table", "exact"),
        choices_most(c, name, "table", "strays"), choices_loss(c, name, "1 term", "exact"),
        choices_most(c, name, "1 term", "strays"), choices_loss(c, name, "2 terms", "exact"),
        choices_most(c, name, "2 terms", "strays"), 32768 * exp2(-bits));
}

static void choices_root(FILE *out, const struct choices *c)
{
    const double calls = choices_calls(c, "root");
    const double m3 = choices_count(c, "root", "2 terms", "m3") - choices_count(c, "root", "1 term", "m3");
    const double m0 = choices_count(c, "root", "2 terms", "m0plus") - choices_count(c, "root", "1 term", "m0plus");
    fprintf(out,
            "<p><b>What to choose: one term</b> for pixels, two for set-up, which turns normals and places by it. Each "
            "pixel of phong, and of duff where it looks no length up, takes a reciprocal root, %.0f a picture here: a "
            "table "
            "of 192 bytes and its series. "
            "The table alone loses %.1f dB and errs by up to %.1f; one term against two loses %.2f dB and saves %.0f "
            "instructions a pixel on M3, %.0f on M0+: %.0f and %.0f thousand of a frame.</p>\n",
            calls, choices_loss(c, "root", "table", "2 terms"), choices_most(c, "root", "table", "max"),
            choices_loss(c, "root", "1 term", "2 terms"), m3, m0, calls * m3 / 1000, calls * m0 / 1000);
}

/* Every value that a text speaks of has to be there. */
static const struct choices_kind {
    const char *choice, *title, *heading;
    void (*text)(FILE *out, const struct choices *choices);
    const char *needs[6];
} choices_kinds[] = {
    {"fraction", "fraction bits", "Fraction bits of coefficients", choices_fraction, {"14", "22", "24"}},
    {"subpixel", "sub-pixel bits", "Sub-pixel bits of corners", choices_subpixel, {"2", "3", "4", "5", "6"}},
    {"power",
     "steps",
     "Steps of the power\u2019s table",
     choices_power,
     {"64 interpolated", "128 interpolated", "1024 interpolated", "128 nearest", "1024 nearest"}},
    {"reciprocal",
     "series",
     "Precision of reciprocals",
     choices_reciprocal,
     {"table", "1 term", "2 terms", "3 terms", "exact"}},
    {"root", "series", "Precision of reciprocal roots", choices_root, {"table", "1 term", "2 terms"}},
};

static int choices_check(const struct choices *choices)
{
    for (size_t k = 0; k < COUNT(choices_kinds); k++)
        for (size_t i = 0; i < COUNT(choices_kinds[k].needs) && choices_kinds[k].needs[i]; i++)
            if (!choices_find(choices, choices_kinds[k].choice, choices_kinds[k].needs[i], NULL, NULL)) {
                fprintf(stderr, "%s: no line for %s %s\n", choices->path, choices_kinds[k].choice,
                        choices_kinds[k].needs[i]);
                return CLI_BAD_DATA;
            }
    return CLI_DONE;
}

int choices_write(FILE *out, const char *path)
{
    struct choices choices = {.path = path};
    int code = csv_read(path, choices_head, choices_take, NULL, &choices);
    if (!code)
        code = choices_check(&choices);
    if (!code)
        fprintf(out,
                "<h2 id=\"choices\">Fixed-point choices</h2>\n"
                "<p>The renderer\u2019s own code with one part of it exchanged, pictures in 8-bit grey against the "
                "truth. Largest differences and errors are in 1/255; instructions are those of one call or "
                "pixel, counted by QEMU.</p>\n");
    for (size_t k = 0; !code && k < COUNT(choices_kinds); k++) {
        fprintf(out, "<h3>%s</h3>\n", choices_kinds[k].heading);
        choices_kinds[k].text(out, &choices);
        choices_table(out, &choices, choices_kinds[k].choice, choices_kinds[k].title);
    }
    free(choices.rows);
    return code;
}
