/* SPDX-License-Identifier: MIT */
#include "plan/bump.h"

#include "plan/curve.h"

/* At k = i / 64: |Q - u|, and |Q.u - 1|, of three unit vectors at most; Q16. Both are convex, so that lines between
 * entries are above them. */
#define STEP 10 /* bits of a step of k in Q16 */
static const uint16_t distance[(CURVE_MOST_BEND >> STEP) + 2] = {
    0,    28,   78,   143,  222,  312,  414,  527,  651,  785,  930,  1085, 1250, 1426, 1613, 1810, 2019,
    2239, 2475, 2724, 2986, 3262, 3552, 3858, 4179, 4517, 4871, 5250, 5660, 6102, 6586, 7102, 7653, 7653};
static const uint16_t length[(CURVE_MOST_BEND >> STEP) + 2] = {
    0,    4,    13,   27,   49,   77,   112,  156,  208,  268,  339,  420,  512,  615,  732,  862,  1008,
    1169, 1347, 1545, 1763, 2003, 2267, 2558, 2878, 3229, 3616, 4042, 4510, 5026, 5596, 6225, 6922, 6922};

static uint32_t between(const uint16_t *table, uint32_t k)
{
    const uint32_t i = k >> STEP, part = k & ((1u << STEP) - 1);
    return table[i] + (fx_u32(table[i + 1] - table[i]) * part >> STEP) + 1;
}

uint32_t plan_bump_distance(uint32_t k)
{
    return between(distance, k);
}

uint32_t plan_bump_length(uint32_t k)
{
    return between(length, k);
}

/* A coefficient (Q8) times a Q16 part, all of it from 1 on; rounded up. */
static uint32_t scaled(uint32_t coefficient, uint32_t q16)
{
    return q16 < 1u << 16 ? (coefficient * q16 >> 16) + 1 : coefficient;
}

/* The steepest slope of cos^n, Q8: sqrt(n) (.6065 + .4 / n). */
static uint32_t slope(uint32_t n)
{
    return (fx_root(n << 16) * (39748 + 26215 / n) >> 16) + 1; /* 2^13 * 2^16 */
}

void plan_bump_light(struct plan_bump *plan, const struct plan_surface *s, unsigned light, const uint16_t bend[2][3],
                     uint32_t shift)
{
    const uint32_t coefficient[2] = {s->light[light].diffuse, s->light[light].specular}, n = s->power->exponent;
    for (int which = 0; which < 2; which++) {
        struct curve curve;
        uint32_t across = 0;
        if (!coefficient[which])
            continue;
        curve_setup(&curve, bend[which]);
        if (!curve.lines || shift >= 1u << 16) {
            plan->linear += coefficient[which];
            plan->quadratic += coefficient[which];
            continue;
        }
        const uint32_t k = curve.bend, sum = (k + bend[which][0] + bend[which][1] + bend[which][2] + 3) / 4,
                       three_s = (sum > k * 3 / 4 ? sum : k * 3 / 4) + 1;
        const uint32_t far = plan_bump_distance(k), along = plan_bump_length(three_s); /* CURVE_MOST_BEND + 1 at most */
        if (shift) { /* chords are 2 sqrt(k), and directions move by 1 / |V| of what V does */
            across = (fx_root(k << 16) * 2 * (shift >> 2) >> 14) + 2; /* 2^16.5 * 2^14 */
            across += (across >> 2) * (curve.stretch >> 2) >> 11;
        }
        const uint32_t steep = slope(n), drift = across * steep >> 8;
        if (!which) {
            plan->linear += scaled(coefficient[0], 2 * curve.stretch + across);
            plan->quadratic += scaled(coefficient[0], far + across);
            continue;
        }
        const uint32_t shorter = curve.stretch << 15, /* Q30, below 2^29.6: stretch is a little more than r */
            kept = fx_power(s->power, fx_s32((1u << 30) - shorter));
        plan->linear += scaled(coefficient[1], 2 * (32768 - kept) + drift + 256); /* the table is off by .5 / 255 */
        const uint32_t longer = n * (along + (far * far >> 17) + 1),              /* 2^10 * 2^13 */
            grown = longer < 1u << 15 ? longer + (longer * longer >> 16) + 1 : 1u << 16;
        plan->quadratic += scaled(coefficient[1], (far * steep >> 8) + grown + drift + 1);
    }
}

enum plan_bump_kind plan_bump_choose(const struct plan_bump *plan, const struct plan_surface *s, uint16_t *error)
{
    const int linear = plan->linear <= s->budget, quadratic = plan->quadratic <= s->budget;
    *error = fx_u16(linear ? plan->linear : quadratic ? plan->quadratic : 0);
    return linear ? PLAN_BUMP_LINEAR : quadratic ? PLAN_BUMP_QUADRATIC : PLAN_BUMP_NORMALISED;
}
