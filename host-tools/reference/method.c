/* SPDX-License-Identifier: MIT */
#include "reference/method.h"

#include <string.h>

const struct method methods[REFERENCE_METHODS] = {
    [REFERENCE_PHONG] = {"phong", "the truth: normal linear in space, unit per pixel", true, false, normal_setup_linear,
                         normal_pixel},
    [REFERENCE_GOURAUD] = {"gouraud", "the corners' colours, linear", false, false, colour_setup_linear, colour_pixel},
    [REFERENCE_X] = {"x", "N.L and N.H quadratic from the corners' normals alone", false, false, dots_setup_x,
                     dots_pixel},
    [REFERENCE_SIX] = {"six", "the same with true normals in the middles of the edges", false, false, dots_setup_six,
                       dots_pixel},
    [REFERENCE_COLOR6] = {"color6", "finished colour quadratic", false, false, colour_setup_quadratic, colour_pixel},
    [REFERENCE_DUFF] = {"duff", "N.L and N.H over the root of a quadratic |N|^2", false, false, dots_setup_duff,
                        dots_pixel_duff},
    [REFERENCE_OVERVELD] = {"overveld", "normal quadratic along the edges, through six samples", false, false,
                            normal_setup_overveld, normal_pixel},
    [REFERENCE_OVERVELD_SCAN] = {"overveld-scan", "normal quadratic along the edges, then along each row", false, false,
                                 normal_setup_linear, normal_pixel_scan},
    [REFERENCE_BIQUADRATIC] = {"biquadratic", "normal quadratic where the surface turns back, else linear", false,
                               false, normal_setup_biquadratic, normal_pixel},
    [REFERENCE_PHONG_SCREEN] = {"phong-screen", "normal linear in the picture, unit per pixel", false, false,
                                normal_setup_linear, normal_pixel},
    [REFERENCE_X_PERSPECTIVE] = {"x-perspective", "x over the triangle in space", true, false, dots_setup_x,
                                 dots_pixel},
    [REFERENCE_SIX_PERSPECTIVE] = {"six-perspective", "six likewise", true, false, dots_setup_six, dots_pixel},
    [REFERENCE_DUFF_PERSPECTIVE] = {"duff-perspective", "duff likewise", true, false, dots_setup_duff, dots_pixel_duff},
    [REFERENCE_BIQUADRATIC_PERSPECTIVE] = {"biquadratic-perspective", "biquadratic likewise", true, false,
                                           normal_setup_biquadratic, normal_pixel},
    [REFERENCE_SUBDIVIDE_RECURSIVE] = {"subdivide-recursive", "gouraud, in quarters of quarters until they are small",
                                       false, false, colour_setup_linear, subdivide_pixel_size},
    [REFERENCE_SUBDIVIDE_CENTRE] = {"subdivide-centre", "color6, in quarters until its centre is right", false, false,
                                    colour_setup_quadratic, subdivide_pixel_centre},
    [REFERENCE_SUBDIVIDE_REGULAR] = {"subdivide-regular", "gouraud, and quarters where a highlight can lie", false,
                                     true, subdivide_setup_regular, NULL},
    [REFERENCE_SUBDIVIDE_HIGHLIGHT] = {"subdivide-highlight", "gouraud, and parts that meet in a highlight's centre",
                                       false, true, subdivide_setup_highlight, subdivide_pixel_highlight},
    [REFERENCE_HYBRID_PHONG] = {"subdivide-hybrid", "gouraud, and phong where a highlight can lie", false, true,
                                subdivide_setup_hybrid_phong, NULL},
    [REFERENCE_HYBRID_X] = {"subdivide-hybrid-x", "gouraud, and x where a highlight can lie", false, true,
                            subdivide_setup_hybrid_x, NULL},
};

int method_find(const char *name)
{
    for (int i = 0; i < REFERENCE_METHODS; i++)
        if (strcmp(name, methods[i].name) == 0)
            return i;
    return -1;
}
