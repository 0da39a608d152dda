/* SPDX-License-Identifier: MIT */
/* Every method by its name. */
#include "glint.h"

const struct glint_choice glint_choices[] = {
    {"flat", &glint_flat},
    {"gouraud", &glint_gouraud},
    {"x", &glint_x},
    {"phong", &glint_phong},
};

const unsigned glint_choice_count = sizeof glint_choices / sizeof *glint_choices;

const char *const glint_method_names[GLINT_METHODS] = {
    [GLINT_FLAT] = "flat",
    [GLINT_GOURAUD] = "gouraud",
    [GLINT_X] = "x",
    [GLINT_PHONG] = "phong",
};
