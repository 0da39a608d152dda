/* SPDX-License-Identifier: MIT */
/* Every method by its name. */
#include "glint.h"

const struct glint_choice glint_choices[] = {
    {"flat", &glint_flat},
    {"gouraud", &glint_gouraud},
    {"x", &glint_x},
    {"x-perspective", &glint_x_perspective},
    {"six", &glint_six},
    {"six-perspective", &glint_six_perspective},
    {"color6", &glint_color6},
    {"duff", &glint_duff},
    {"phong", &glint_phong},
    {"phong-perspective", &glint_phong_perspective},
    {"overveld", &glint_overveld},
    {"overveld-scan", &glint_overveld_scan},
    {"biquadratic", &glint_biquadratic},
    {"biquadratic-perspective", &glint_biquadratic_perspective},
    {"bump-linear", &glint_bump_linear},
    {"bump-quadratic", &glint_bump_quadratic},
    {"bump-frames", &glint_bump_frames},
    {"bump-upright", &glint_bump_upright},
    {"bump-normalised", &glint_bump_normalised},
    {"subdivide-recursive", &glint_subdivide_recursive},
    {"subdivide-centre", &glint_subdivide_centre},
    {"subdivide-regular", &glint_subdivide_regular},
    {"subdivide-highlight", &glint_subdivide_highlight},
    {"subdivide-hybrid", &glint_hybrid_phong},
    {"subdivide-hybrid-x", &glint_hybrid_x},
    {"auto", &glint_auto},
};

const unsigned glint_choice_count = sizeof glint_choices / sizeof *glint_choices;

const char *const glint_method_names[GLINT_METHODS] = {
    [GLINT_FLAT] = "flat",
    [GLINT_GOURAUD] = "gouraud",
    [GLINT_X] = "x",
    [GLINT_SIX] = "six",
    [GLINT_COLOR6] = "color6",
    [GLINT_DUFF] = "duff",
    [GLINT_PHONG] = "phong",
    [GLINT_OVERVELD] = "overveld",
    [GLINT_BIQUADRATIC] = "biquadratic",
    [GLINT_SUBDIVIDE] = "subdivide",
    [GLINT_BUMP_LINEAR] = "bump-linear",
    [GLINT_BUMP_QUADRATIC] = "bump-quadratic",
    [GLINT_BUMP_NORMALISED] = "bump-normalised",
    [GLINT_DARK] = "dark",
    [GLINT_CONSTANT] = "constant",
    [GLINT_LINEAR] = "linear",
};
