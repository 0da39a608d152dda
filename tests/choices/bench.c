/* SPDX-License-Identifier: MIT */
/*
 * Instructions of parts in other precisions, on a board: CSV lines `choice,value,instructions` of 1000 calls or pixels,
 * loop and store included, since all have the same.
 */
#include "tests/choices/parts.h"
#include "tests/device/program.h"

#define CALLS 1000

static uint32_t input[CALLS], output[CALLS];
static struct parts_table table;

static void bench_line(const char *choice, const char *value, const char *more, uint32_t instructions)
{
    struct line line = {.length = 0};
    line_text(&line, choice);
    line_text(&line, ",");
    line_text(&line, value);
    line_text(&line, more);
    line_text(&line, ",");
    line_decimal(&line, instructions);
    line_end(&line);
}

static __attribute__((noinline)) void bench_calls(parts_function *run)
{
    for (int i = 0; i < CALLS; i++)
        output[i] = run(input[i]);
}

static void bench_series(const char *choice, const struct parts_choice *parts, unsigned count)
{
    for (unsigned i = 0; i < count; i++) {
        program_count_start();
        bench_calls(parts[i].run);
        bench_line(choice, parts[i].name, "", program_count());
    }
}

#define BENCH_POWER(bits, nearest)                                                  \
    static __attribute__((noinline)) void bench_power_##bits##_##nearest(void)      \
    {                                                                               \
        for (int i = 0; i < CALLS; i++)                                             \
            output[i] = parts_power(&table, (q30_t)(input[i] >> 2), bits, nearest); \
    }
#define BENCH_POWERS(bits) BENCH_POWER(bits, 0) BENCH_POWER(bits, 1)
BENCH_POWERS(4)
BENCH_POWERS(5)
BENCH_POWERS(6)
BENCH_POWERS(7)
BENCH_POWERS(8)
BENCH_POWERS(9)
BENCH_POWERS(10)

static const struct {
    const char *name;
    unsigned bits;
    void (*run[2])(void);
} powers[] = {
    {"16", 4, {bench_power_4_0, bench_power_4_1}},      {"32", 5, {bench_power_5_0, bench_power_5_1}},
    {"64", 6, {bench_power_6_0, bench_power_6_1}},      {"128", 7, {bench_power_7_0, bench_power_7_1}},
    {"256", 8, {bench_power_8_0, bench_power_8_1}},     {"512", 9, {bench_power_9_0, bench_power_9_1}},
    {"1024", 10, {bench_power_10_0, bench_power_10_1}},
};

static void bench_powers(void)
{
    for (int nearest = 0; nearest <= 1; nearest++)
        for (unsigned i = 0; i < sizeof powers / sizeof powers[0]; i++) {
            parts_power_build(&table, 1, powers[i].bits); /* octave 0: all of 0..1 is within the table */
            program_count_start();
            powers[i].run[nearest]();
            bench_line("power", powers[i].name, nearest ? " nearest" : " interpolated", program_count());
        }
}

/* A quadratic's two additions a pixel, and its value stored, in words of 32 bits. */
static __attribute__((noinline)) void bench_narrow(const uint32_t *start)
{
    uint32_t value = start[0], step = start[1];
    for (uint32_t *out = output; out != output + CALLS; out++) {
        *out = value;
        value += step;
        step += start[2];
    }
}

/* And of 64: what more fraction bits than 22 take. */
static __attribute__((noinline)) void bench_double(const uint64_t *start)
{
    uint64_t value = start[0], step = start[1];
    const uint64_t second = start[2];
    for (uint32_t *out = output; out != output + CALLS; out++) {
        *out = (uint32_t)(value >> 8);
        value += step;
        step += second;
    }
}

int program_main(int argc, char **argv)
{
    static const uint32_t narrow[3] = {1u << 28, 1u << 16, 3};
    static const uint64_t wide[3] = {(uint64_t)1 << 36, (uint64_t)1 << 24, 700};
    (void)argc;
    (void)argv;
    parts_begin();
    for (uint32_t i = 0; i < CALLS; i++)
        input[i] = 0x80000000u + i * (0x7fffffffu / CALLS);
    bench_series("reciprocal", parts_reciprocals, PARTS_RECIPROCALS);
    bench_series("root", parts_roots, PARTS_ROOTS);
    bench_powers();
    program_count_start();
    bench_narrow(narrow);
    bench_line("fraction", "22", "", program_count());
    program_count_start();
    bench_double(wide);
    bench_line("fraction", "24", "", program_count());
    return 0;
}
