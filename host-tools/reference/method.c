/* SPDX-License-Identifier: MIT */
#include "reference/method.h"

#include <string.h>

const struct method methods[REFERENCE_METHODS] = {
    [REFERENCE_PHONG] = {"phong", "the truth: normal linear in space, unit per pixel", true, false, normal_setup_linear,
                         normal_pixel, BUMP_UNIT},
    [REFERENCE_GOURAUD] = {"gouraud", "the corners' colours, linear", false, false, colour_setup_linear, colour_pixel,
                           BUMP_NONE},
    [REFERENCE_X] = {"x", "N.L and N.H quadratic from the corners' normals alone", false, false, dots_setup_x,
                     dots_pixel, BUMP_NONE},
    [REFERENCE_SIX] = {"six", "the same with true normals in the middles of the edges", false, false, dots_setup_six,
                       dots_pixel, BUMP_NONE},
    [REFERENCE_COLOR6] = {"color6", "finished colour quadratic", false, false, colour_setup_quadratic, colour_pixel,
                          BUMP_NONE},
    [REFERENCE_DUFF] = {"duff", "N.L and N.H over the root of a quadratic |N|^2", false, false, dots_setup_duff,
                        dots_pixel_duff, BUMP_NONE},
    [REFERENCE_OVERVELD] = {"overveld", "normal quadratic along the edges, through six samples", false, false,
                            normal_setup_overveld, normal_pixel, BUMP_NONE},
    [REFERENCE_OVERVELD_SCAN] = {"overveld-scan", "normal quadratic along the edges, then along each row", false, false,
                                 normal_setup_linear, normal_pixel_scan, BUMP_NONE},
    [REFERENCE_BIQUADRATIC] = {"biquadratic", "normal quadratic where the surface turns back, else linear", false,
                               false, normal_setup_biquadratic, normal_pixel, BUMP_NONE},
    [REFERENCE_PHONG_SCREEN] = {"phong-screen", "normal linear in the picture, unit per pixel", false, false,
                                normal_setup_linear, normal_pixel, BUMP_NONE},
    [REFERENCE_X_PERSPECTIVE] = {"x-perspective", "x over the triangle in space", true, false, dots_setup_x, dots_pixel,
                                 BUMP_NONE},
    [REFERENCE_SIX_PERSPECTIVE] = {"six-perspective", "six likewise", true, false, dots_setup_six, dots_pixel,
                                   BUMP_NONE},
    [REFERENCE_DUFF_PERSPECTIVE] = {"duff-perspective", "duff likewise", true, false, dots_setup_duff, dots_pixel_duff,
                                    BUMP_NONE},
    [REFERENCE_BIQUADRATIC_PERSPECTIVE] = {"biquadratic-perspective", "biquadratic likewise", true, false,
                                           normal_setup_biquadratic, normal_pixel, BUMP_NONE},
    [REFERENCE_BUMP_LINEAR] = {"bump-linear", "L' and H' of bump maps linear as they are; without a map x", false,
                               false, dots_setup_x, dots_pixel, BUMP_LINEAR},
    [REFERENCE_BUMP_QUADRATIC] = {"bump-quadratic", "quadratic, middles the ends' average made unit; else six", false,
                                  false, dots_setup_six, dots_pixel, BUMP_QUADRATIC},
    [REFERENCE_BUMP_FRAMES] = {"bump-frames", "quadratic, middles in frames of the ends' averages", false, false,
                               dots_setup_six, dots_pixel, BUMP_FRAMES},
    [REFERENCE_BUMP_UPRIGHT] = {"bump-upright", "the same, frames at right angles", false, false, dots_setup_six,
                                dots_pixel, BUMP_UPRIGHT},
    [REFERENCE_BUMP_NORMALISED] = {"bump-normalised", "the truth: linear in space, unit per pixel; without a map phong",
                                   true, false, normal_setup_linear, normal_pixel, BUMP_UNIT},
    [REFERENCE_SUBDIVIDE_RECURSIVE] = {"subdivide-recursive", "gouraud, in quarters of quarters until they are small",
                                       false, false, colour_setup_linear, subdivide_pixel_size, BUMP_NONE},
    [REFERENCE_SUBDIVIDE_CENTRE] = {"subdivide-centre", "color6, in quarters until its centre is right", false, false,
                                    colour_setup_quadratic, subdivide_pixel_centre, BUMP_NONE},
    [REFERENCE_SUBDIVIDE_REGULAR] = {"subdivide-regular", "gouraud, and quarters where a highlight can lie", false,
                                     true, subdivide_setup_regular, NULL, BUMP_NONE},
    [REFERENCE_SUBDIVIDE_HIGHLIGHT] = {"subdivide-highlight", "gouraud, and parts that meet in a highlight's centre",
                                       false, true, subdivide_setup_highlight, subdivide_pixel_highlight, BUMP_NONE},
    [REFERENCE_HYBRID_PHONG] = {"subdivide-hybrid", "gouraud, and phong where a highlight can lie", false, true,
                                subdivide_setup_hybrid_phong, NULL, BUMP_NONE},
    [REFERENCE_HYBRID_X] = {"subdivide-hybrid-x", "gouraud, and x where a highlight can lie", false, true,
                            subdivide_setup_hybrid_x, NULL, BUMP_NONE},
};

int method_find(const char *name)
{
    for (int i = 0; i < REFERENCE_METHODS; i++)
        if (strcmp(name, methods[i].name) == 0)
            return i;
    return -1;
}
