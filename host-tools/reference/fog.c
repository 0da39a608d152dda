/* SPDX-License-Identifier: MIT */
#include "reference/fog.h"

#include "reference/shading.h"

#include <math.h>

double fog_amount(const struct decode_fog *fog, double distance)
{
    switch (fog->kind) {
    case FOG_LINEAR:
        return fmin(1, fmax(0, (distance - fog->from) / (fog->to - fog->from)));
    case FOG_EXPONENTIAL:
        return 1 - exp(-fog->density * distance);
    default:
        return 0;
    }
}

void fog_apply(const struct decode_fog *fog, double distance, unsigned channels, double colour[3])
{
    const double part = fog_amount(fog, distance);
    double of_fog[3];
    shading_channels(fog->colour, channels, of_fog);
    for (unsigned c = 0; c < channels; c++)
        colour[c] += part * (of_fog[c] - colour[c]);
}
