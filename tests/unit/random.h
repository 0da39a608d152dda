/* SPDX-License-Identifier: MIT */
/* Numbers that are the same in every run: a test begins with random_seed(), so that it can be repeated alone. */
#ifndef RANDOM_H
#define RANDOM_H

#include "fixed/fixed.h"

#include <math.h>

static uint32_t random_state = 2463534242u;

static inline void random_seed(uint32_t seed)
{
    random_state = seed ? seed : 1;
}

/* All 32-bit numbers but 0 (xorshift). */
FX_WRAPS static inline uint32_t random_bits(void)
{
    random_state ^= random_state << 13;
    random_state ^= random_state >> 17;
    return random_state ^= random_state << 5;
}

/* A whole number in [low, high], fewer than 2^32 of them. */
static inline int32_t random_between(int32_t low, int32_t high)
{
    uint64_t count = (uint64_t)((int64_t)high - low) + 1;
    return (int32_t)(low + (int64_t)(random_bits() * count >> 32));
}

/* In (0, 1). */
static inline double random_fraction(void)
{
    return random_bits() * 0x1p-32;
}

static inline double random_real(double low, double high)
{
    return low + (high - low) * random_fraction();
}

/* From `low` to `high`, every factor of two as likely: 0 < low. */
static inline double random_magnitude(double low, double high)
{
    return low * pow(high / low, random_fraction());
}

/* A direction of n <= 4 dimensions, all equally likely. */
static inline void random_direction(double *v, int n)
{
    double length;
    do {
        length = 0;
        for (int i = 0; i < n; i++) {
            v[i] = random_real(-1, 1);
            length += v[i] * v[i];
        }
    } while (length > 1 || length < 1e-4);
    for (int i = 0; i < n; i++)
        v[i] /= sqrt(length);
}

#endif
