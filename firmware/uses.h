/* SPDX-License-Identifier: MIT */
/*
 * What a program can be asked to draw, as one set of bits. A scene carries the set of effects that any moment of it can
 * need (scene_header.effects, made by `glint pack`), a panel or a stream names its formats. A program that is built
 * for given scenes is compiled with -DGLINT_USES=0x... of their union, which `glint pack --uses` prints, and has no
 * code of what is not in it; without that definition it has all. glint_frame_begin() refuses a scene that needs more,
 * glint_init() a configuration.
 *
 * Code of an effect stands behind `if (USES(USES_FOG) && ...)`: never behind #if, so that it always compiles.
 */
#ifndef GLINT_USES_H
#define GLINT_USES_H

/* Effects of a scene. */
#define USES_TEXTURE        0x0001u /* a material with a texture */
#define USES_BUMP           0x0002u /* a material with a bump map */
#define USES_FOG            0x0004u
#define USES_TWO_SIDED      0x0008u /* a material whose back faces are drawn */
#define USES_SPECULAR       0x0010u /* a material with a highlight under some light */
#define USES_POINT_LIGHT    0x0020u
#define USES_LOCAL_VIEWER   0x0040u /* the eye's place counts for highlights */
#define USES_PERSPECTIVE    0x0080u /* a perspective camera */
#define USES_ORTHOGRAPHIC   0x0100u /* an orthographic one */
#define USES_SPIN           0x0200u /* an object or a light that spins */
#define USES_KEYS           0x0400u /* one that moves by keys */
#define USES_SEVERAL_LIGHTS 0x0800u
#define USES_CLIPPING       0x1000u /* something can leave the camera's view, or be cut by its near or far plane */
#define USES_EFFECTS        0x1fffu /* all of these */

/* Formats of pictures: 1 << 16 + enum glint_format. */
#define USES_FORMAT(format) (0x10000u << (format))
#define USES_RGB565         0x10000u
#define USES_RGB888         0x20000u
#define USES_GREY8          0x40000u
#define USES_GREY4          0x80000u
#define USES_COLOUR         (USES_RGB565 | USES_RGB888)
#define USES_GREY           (USES_GREY8 | USES_GREY4)
#define USES_FORMATS        (USES_COLOUR | USES_GREY)

/* What the program's configurations ask for besides. */
#define USES_DITHER  0x100000u /* GLINT_DITHER */
#define USES_POWERS  0x200000u /* config.power other than null */
#define USES_OPTIONS 0x300000u

#define USES_ALL (USES_EFFECTS | USES_FORMATS | USES_OPTIONS)

#ifndef GLINT_USES
#define GLINT_USES USES_ALL
#endif

/* Whether this program has one of them: a constant. */
#define USES(bits) ((GLINT_USES & (bits)) != 0)

/* Whether a format is this one: a constant where the program has one alone, or this one not. */
static inline int uses_format(unsigned format, unsigned which)
{
    return USES(USES_FORMAT(which)) && ((GLINT_USES & USES_FORMATS) == USES_FORMAT(which) || format == which);
}

/* Channels of a picture, 1 (grey) or 3, likewise. */
static inline unsigned uses_channels(unsigned channels)
{
    return !USES(USES_GREY) ? 3 : !USES(USES_COLOUR) ? 1 : channels;
}

#endif
