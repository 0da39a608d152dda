/* SPDX-License-Identifier: MIT */
#include "scene/picture.h"
#include "scene/reader.h"
#include "scene/scene.h"

#include <stdlib.h>
#include <string.h>

#define MADE     " pattern size cells colours"
#define ANY      " filter wrap format"
#define PATTERNS "checker gradient noise"

char *reader_path(const struct node *node, const char *name)
{
    const char *scene = node->file->path, *slash = strrchr(scene, '/');
    size_t folder = slash && name[0] != '/' ? (size_t)(slash - scene) + 1 : 0;
    char *path = model_alloc(folder + strlen(name) + 1);
    memcpy(path, scene, folder);
    strcpy(path + folder, name);
    return path;
}

/* The picture of a file, which the caller has named in the scene. */
static int load(const struct node *node, const char *name, struct model *model, int *exit_code)
{
    int index = -1;
    char *path = reader_path(node, name);
    if (!node->file->failed && (*exit_code = picture_load(model, path, &index)) != 0)
        node->file->failed = true; /* picture_load() has said why */
    free(path);
    return index;
}

void reader_pair(const struct node *node, const char *key, unsigned out[2], unsigned least, unsigned most)
{
    struct node list = node_member(node, key);
    for (size_t i = 0; i < 2 && node_length(&list, 2, 2) == 2; i++) {
        struct node item = node_item(&list, i);
        out[i] = node_integer(&item, least, most, out[i]);
    }
}

static void make(const struct node *node, struct model_texture *texture)
{
    unsigned size[2] = {64, 64}, cells[2] = {8, 8};
    double colour[2][3] = {{0.15, 0.15, 0.15}, {1, 1, 1}};
    const int pattern = node_member_choice(node, "pattern", PATTERNS, -1);
    reader_pair(node, "size", size, 1, 1024);
    reader_pair(node, "cells", cells, 1, 1024);
    struct node colours = node_member(node, "colours");
    for (size_t i = 0; i < 2 && node_length(&colours, 2, 2) == 2; i++) {
        struct node item = node_item(&colours, i);
        node_vector(&item, colour[i], 3, 0, 1);
    }
    if (!node->file->failed)
        picture_make(texture, (enum picture_pattern)pattern, size, cells, colour);
}

void reader_wrap(const struct node *node, struct model_texture *texture)
{
    struct node wrap = node_member(node, "wrap");
    for (size_t k = 0; k < 2; k++) {
        struct node item = json_is_array(wrap.value) ? node_item(&wrap, k) : wrap;
        texture->clamp[k] = node_choice(&item, "repeat clamp", 0) == 1;
    }
    if (json_is_array(wrap.value))
        node_length(&wrap, 2, 2);
}

static void read_texture(const struct node *node, const char *name, struct model *model, int *exit_code)
{
    struct node file = node_member(node, "file"), pattern = node_member(node, "pattern");
    if (!json_is_object(node->value) || !file.value == !pattern.value) {
        node_fail(node, "must be an object with either \"file\" or \"pattern\"");
        return;
    }
    node_object(node, file.value ? "file" ANY : ANY MADE);
    struct model_texture *texture;
    if (file.value) {
        const char *path = node_string(&file, NULL);
        const int index = node->file->failed ? -1 : load(node, path, model, exit_code);
        if (index < 0)
            return;
        texture = picture_take(model, index, name);
    } else {
        texture = model_add_texture(model, name);
        make(node, texture);
    }
    texture->bilinear = node_member_choice(node, "filter", "nearest bilinear", 1) == 1;
    texture->format = node_member_choice(node, "format", "rgb565 palette8", TEXTURE_RGB565);
    reader_wrap(node, texture);
}

void reader_textures(const struct node *textures, struct model *model, int *exit_code)
{
    const char *name;
    json_t *value;
    if (textures->value && !json_is_object(textures->value))
        node_fail(textures, "must be an object");
    json_object_foreach(textures->value, name, value)
    {
        struct node node = node_member(textures, name);
        if (!node.file->failed)
            read_texture(&node, name, model, exit_code);
    }
}

int reader_texture(const struct node *material, const char *key, struct model *model, int *exit_code)
{
    struct node node = node_member(material, key);
    const char *name = node_string(&node, ""), *ending = strrchr(name, '.');
    if (!node.value || node.file->failed)
        return -1;
    const int index = model_find_texture(model, name);
    if (index >= 0 && model->textures[index].format != TEXTURE_BUMP8)
        return index;
    if (ending && !strcmp(ending, ".png"))
        return load(&node, name, model, exit_code);
    node_fail(&node, "no texture named \"%s\", nor is it a .png file", name);
    return -1;
}
