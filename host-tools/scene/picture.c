/* SPDX-License-Identifier: MIT */
#include "scene/picture.h"

#include "compare/image.h"
#include "import/import.h"
#include "scene/scene.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

/* The image becomes a texture of this name. */
static int add_picture(struct model *model, const char *name, const struct image *image)
{
    struct model_texture *texture = model_add_texture(model, name);
    texture->is_file = true;
    texture->format = TEXTURE_RGB565;
    texture->bilinear = true;
    texture->width = image->width;
    texture->height = image->height;
    texture->rgb = image->rgb;
    return (int)model->texture_count - 1;
}

/* One whose name was given in the scene is another, whatever it is called. */
static int find_file(const struct model *model, const char *path)
{
    for (size_t i = 0; i < model->texture_count; i++)
        if (model->textures[i].is_file && !strcmp(model->textures[i].name, path))
            return (int)i;
    return -1;
}

int picture_load(struct model *model, const char *path, int *index)
{
    struct image image;
    *index = find_file(model, path);
    if (*index >= 0)
        return 0;
    int code = import_check_readable(path);
    if (!code)
        code = image_read_png(path, &image);
    if (!code)
        *index = add_picture(model, path, &image);
    return code;
}

struct model_texture *picture_take(struct model *model, int index, const char *name)
{
    struct model_texture *texture = &model->textures[index];
    free(texture->name);
    texture->name = model_copy(name);
    texture->is_file = false;
    return texture;
}

static void drawn_without(const char *model_path)
{
    fprintf(stderr, "%s: warning: drawn without this texture\n", model_path);
}

void picture_beside(const char *model_path, const char *name, struct model *model, int *index)
{
    const char *slash = strrchr(model_path, '/'), *ending = strrchr(name, '.');
    const size_t folder = slash && name[0] != '/' ? (size_t)(slash - model_path) + 1 : 0;
    char *path = model_alloc(folder + strlen(name) + 1);
    memcpy(path, model_path, folder);
    strcpy(path + folder, name);
    for (char *at = path + folder; *at; at++)
        *at = *at == '\\' ? '/' : *at; /* as such files are written elsewhere */
    *index = -1;
    if (!ending || strcasecmp(ending, ".png") != 0)
        fprintf(stderr, "%s: warning: no texture: only PNG files are read\n", path);
    else if (picture_load(model, path, index) != 0)
        drawn_without(model_path);
    free(path);
}

void picture_inside(const char *model_path, const struct model_material *material, struct model *model, int *index)
{
    struct image image;
    char *name = model_alloc(strlen(model_path) + strlen(material->picture) + sizeof ": image ");
    sprintf(name, "%s: image %s", model_path, material->picture + 1);
    *index = find_file(model, name);
    if (*index < 0 && !material->inside)
        fprintf(stderr, "%s: warning: no texture: not a picture that is read\n", name);
    else if (*index < 0 && image_read_png_bytes(name, material->inside, material->inside_size, &image) == 0)
        *index = add_picture(model, name, &image);
    else if (*index < 0)
        drawn_without(model_path);
    free(name);
}

/* 0..1 of a cell's corner, by a mixer of its numbers. */
static double hashed(unsigned x, unsigned y)
{
    uint32_t h = x * 0x9e3779b9u ^ (y * 0x85ebca6bu + 0x7f4a7c15u);
    h = (h ^ h >> 16) * 0x7feb352du;
    h = (h ^ h >> 15) * 0x846ca68bu;
    return (h ^ h >> 16) / 4294967295.;
}

/* Values of the corners, smoothly between them; repeats after px, py cells. */
static double noise(double u, double v, unsigned px, unsigned py)
{
    const double x = floor(u), y = floor(v), s = u - x, t = v - y;
    const double a = s * s * (3 - 2 * s), b = t * t * (3 - 2 * t);
    const unsigned x0 = (unsigned)x % px, y0 = (unsigned)y % py, x1 = (x0 + 1) % px, y1 = (y0 + 1) % py;
    return (hashed(x0, y0) * (1 - a) + hashed(x1, y0) * a) * (1 - b) +
           (hashed(x0, y1) * (1 - a) + hashed(x1, y1) * a) * b;
}

/* How much of the second colour there is at u, v in cells. */
static double share(enum picture_pattern pattern, double u, double v, const unsigned cells[2])
{
    double sum = 0;
    if (pattern == PICTURE_CHECKER)
        return ((unsigned)u + (unsigned)v) % 2;
    if (pattern == PICTURE_GRADIENT)
        return u - floor(u);
    for (unsigned octave = 0; octave < 4; octave++)
        sum += noise(u * (1 << octave), v * (1 << octave), cells[0] << octave, cells[1] << octave) / (2 << octave);
    return sum / (1 - 1. / 16);
}

void picture_make(struct model_texture *texture, enum picture_pattern pattern, const unsigned size[2],
                  const unsigned cells[2], double colour[2][3])
{
    texture->width = size[0];
    texture->height = size[1];
    uint8_t *rgb = texture->rgb = model_alloc(3 * (size_t)size[0] * size[1]);
    for (unsigned y = 0; y < size[1]; y++)
        for (unsigned x = 0; x < size[0]; x++) {
            const double u = (x + .5) * cells[0] / size[0], v = (size[1] - y - .5) * cells[1] / size[1];
            const double part = share(pattern, u, v, cells);
            for (int c = 0; c < 3; c++)
                *rgb++ = (uint8_t)lround(255 * (colour[0][c] + part * (colour[1][c] - colour[0][c])));
        }
}
