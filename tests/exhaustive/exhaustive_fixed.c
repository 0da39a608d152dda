/* SPDX-License-Identifier: MIT */
/* Every argument of the renderer's functions of one number (unary.h) against double precision: prints the largest and
 * the mean error of each and fails where one exceeds its documented bound.
 *   exhaustive_fixed [NAME...]    of those whose names begin so */
#include "tests/exhaustive/unary.h"

#include <string.h>

int main(int argc, char **argv)
{
    int bad = 0, done = 0;
    for (size_t i = 0; i < UNARY_SWEEPS; i++) {
        int wanted = argc == 1;
        for (int k = 1; k < argc; k++)
            wanted |= strncmp(unary_sweeps[i].name, argv[k], strlen(argv[k])) == 0;
        if (wanted)
            bad |= sweep_run(&unary_sweeps[i], unary_sweeps[i].end);
        done |= wanted;
    }
    return bad || !done;
}
