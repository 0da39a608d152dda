/* SPDX-License-Identifier: MIT */
#include "plan/curve.h"

/* By the largest bend: 41.4, 60, 75.5... to 90 degrees between normals. Four chords of F (f) and what lies beyond
 * them, and the factor of (a), which is (1/sqrt(1 - 4 S) - 1 - 2 S) / S^2 at the band's largest S = kB / 3, Q8. */
static const struct {
    uint16_t most;
    uint16_t square;
    struct curve_line line[5];
} bands[] = {
    {4096, 1656, {{12512, 1049}, {6002, 7559}, {6002, 7559}, {4455, 7946}, {12512, 8075}}},
    {8192, 1789, {{14330, 241}, {7316, 7256}, {6334, 7746}, {4525, 8199}, {14330, 8500}}},
    {16384, 2143, {{19530, -593}, {14461, 4477}, {6846, 8284}, {2003, 9495}, {19530, 9523}}},
    {CURVE_MOST_BEND, 3677, {{47317, -5929}, {45415, -4027}, {25447, 5957}, {-19599, 17218}, {47317, 12748}}},
};

void curve_setup(struct curve *curve, const uint16_t bend[3])
{
    uint32_t most = bend[0] > bend[1] ? bend[0] : bend[1];
    most = bend[2] > most ? bend[2] : most;
    curve->bend = most;
    curve->lines = 0;
    curve->stretch = CURVE_NEVER;
    if (most > CURVE_MOST_BEND)
        return;
    /* (a) S <= max(k1 / 4, (2 k1 + k2 + k3) / 12); the sums are at most 2^17, times 5462 below 2^29.5 */
    const uint32_t sum = (uint32_t)bend[0] + bend[1] + bend[2], quarter = (most >> 2) + 1,
                   twelfth = ((most + sum) * 5462 >> 16) + 1, s = quarter > twelfth ? quarter : twelfth;
    unsigned band = 0;
    while (most > bands[band].most)
        band++;
    curve->lines = bands[band].line;
    /* 1/sqrt(1 - 4 S) - 1 <= 2 S + square S^2, as ((1 - 4 S)^(-1/2) - 1 - 2 S) / S^2 = 6 + 20 S + ... rises: s <=
     * 2^13.5, s^2 < 2^27, Q32 to Q16 and times 2^12: below 2^24. Q16 to Q15: 2 S is s, and the rest is halved. */
    curve->stretch = s + (((s * s >> 16) + 1) * bands[band].square >> 9) + 2;
}

int32_t curve_six(const struct curve *curve, const struct curve_values *v)
{
    const struct curve_line *line = curve->lines;
    const int32_t scaled = (int32_t)((uint32_t)v->high * curve->bend >> 16) + 1, range = v->high - v->low;
    int32_t most = 0; /* |alpha| < 2^16, |beta| < 2^14.1, scaled <= 2^13, range <= 2^15: below 2^31 */
    if (range > 16 * scaled) {
        most = line[4].alpha * scaled + line[4].beta * range;
    } else {
        for (int i = 0; i < 4; i++) {
            const int32_t value = line[i].alpha * scaled + line[i].beta * range;
            most = value > most ? value : most;
        }
    }
    return (int32_t)((((uint32_t)most >> 14) + 1) * curve->bend >> 18) + 2;
}
