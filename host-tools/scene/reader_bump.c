/* SPDX-License-Identifier: MIT */
#include "scene/picture.h"
#include "scene/reader.h"
#include "scene/relief.h"
#include "scene/scene.h"

#include <stdlib.h>
#include <string.h>

#define RELIEFS "bumps waves noise"

/* What a file's picture says, in place of its colours. */
static void convert(struct model_texture *texture, bool heights, double steepness)
{
    uint8_t *rgb = texture->rgb;
    const unsigned width = texture->width, height = texture->height;
    texture->rgb = NULL;
    if (heights) {
        double *level = model_alloc((size_t)width * height * sizeof *level);
        for (size_t i = 0; i < (size_t)width * height; i++)
            level[i] = .299 * rgb[3 * i] + .587 * rgb[3 * i + 1] + .114 * rgb[3 * i + 2];
        relief_from_heights(texture, level, width, height, 1, 1, steepness);
        free(level);
    } else {
        relief_from_normals(texture, rgb, width, height);
    }
    free(rgb);
}

static struct model_texture *load(const struct node *node, const struct node *file, const char *name,
                                  struct model *model, int *exit_code)
{
    int index = -1;
    char *path = reader_path(node, node_string(file, ""));
    if (!node->file->failed && (*exit_code = picture_load(model, path, &index)) != 0)
        node->file->failed = true; /* picture_load() has said why */
    free(path);
    return index < 0 ? NULL : picture_take(model, index, name);
}

static void read_bump(const struct node *node, const char *name, struct model *model, int *exit_code)
{
    const struct node relief = node_member(node, "relief"), heights = node_member(node, "heights"),
                      normals = node_member(node, "normals");
    if (!json_is_object(node->value) ||
        (relief.value != NULL) + (heights.value != NULL) + (normals.value != NULL) != 1) {
        node_fail(node, "must be an object with one of \"relief\", \"heights\" and \"normals\"");
        return;
    }
    node_object(node, relief.value    ? "relief size cells steepness filter"
                      : heights.value ? "heights steepness filter wrap"
                                      : "normals filter wrap");
    const double steepness = node_member_number(node, "steepness", 0, 20, RELIEF_STEEPNESS);
    struct model_texture *texture = relief.value
                                        ? model_add_texture(model, name)
                                        : load(node, heights.value ? &heights : &normals, name, model, exit_code);
    if (!texture)
        return;
    texture->format = TEXTURE_BUMP8;
    texture->bilinear = node_member_choice(node, "filter", "nearest bilinear", 1) == 1;
    if (relief.value) {
        unsigned size[2] = {64, 64}, cells[2] = {4, 4};
        const int kind = node_member_choice(node, "relief", RELIEFS, -1);
        reader_pair(node, "size", size, 1, 1024);
        reader_pair(node, "cells", cells, 1, 1024);
        if (!node->file->failed)
            relief_make(texture, (enum relief_kind)kind, size, cells, steepness);
    } else {
        reader_wrap(node, texture);
        convert(texture, heights.value != NULL, steepness);
    }
}

void reader_bumps(const struct node *bumps, struct model *model, int *exit_code)
{
    const char *name;
    json_t *value;
    if (bumps->value && !json_is_object(bumps->value))
        node_fail(bumps, "must be an object");
    json_object_foreach(bumps->value, name, value)
    {
        struct node node = node_member(bumps, name);
        if (model_find_texture(model, name) >= 0)
            node_fail(&node, "a texture has this name");
        if (!node.file->failed)
            read_bump(&node, name, model, exit_code);
    }
}

int reader_bump(const struct node *material, const struct model *model)
{
    struct node node = node_member(material, "bump");
    const char *name = node_string(&node, "");
    if (!node.value || node.file->failed)
        return -1;
    const int index = model_find_texture(model, name);
    if (index < 0 || model->textures[index].format != TEXTURE_BUMP8)
        node_fail(&node, "no bump map named \"%s\"", name);
    return index;
}
