/* SPDX-License-Identifier: MIT */
#include "import/import.h"
#include "import/normals.h"
#include "import/shape.h"
#include "scene/reader.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define COMMON       " material shading uvs fit"
#define SHAPES       "torus sphere plane revolution patches triangles"
#define MOST_COLUMNS 1024

enum shape { TORUS, SPHERE, PLANE, REVOLUTION, PATCHES, TRIANGLES };

static double length_of(const struct node *node, const char *key, double fallback)
{
    return node_member_number(node, key, 1e-3, READER_MOST_LENGTH, fallback);
}

static void read_revolution(const struct node *node, enum shape_axis axis, struct model_mesh *mesh)
{
    struct node list = node_member(node, "profile");
    if (!list.value)
        node_fail(&list, "missing");
    size_t points = node_length(&list, 2, MOST_COLUMNS);
    double(*profile)[2] = model_alloc((points + 1) * sizeof *profile);
    for (size_t i = 0; i < points; i++) {
        struct node point = node_item(&list, i);
        node_vector(&point, profile[i], 2, -READER_MOST_LENGTH, READER_MOST_LENGTH);
        if (!json_is_array(point.value))
            node_fail(&point, "must be an array");
        if (profile[i][0] < 0)
            node_fail(&point, "a profile's distance from the axis must not be negative");
    }
    unsigned slices = node_member_integer(node, "slices", 3, MOST_COLUMNS, 24);
    double crease = node_member_number(node, "crease", 0, 180, IMPORT_CREASE) * M_PI / 180;
    if (points)
        shape_revolve(mesh, axis, (const double(*)[2])profile, points, slices, crease);
    free(profile);
}

static void read_shape(const struct node *node, struct model_mesh *mesh)
{
    static const char *const members[] = {
        "shape axis radius tube rings sides" COMMON, "shape axis radius slices stacks" COMMON,
        "shape axis size segments" COMMON,           "shape axis profile slices crease" COMMON,
        "shape points patches segments" COMMON,      "shape vertices normals triangles crease" COMMON,
    };
    enum shape shape = (enum shape)node_member_choice(node, "shape", SHAPES, -1);
    enum shape_axis axis = (enum shape_axis)node_member_choice(node, "axis", "x y z", SHAPE_Y);
    node_object(node, members[shape]);
    mesh->has_uvs = true;
    if (shape == TORUS) {
        double radius = length_of(node, "radius", 1), tube = length_of(node, "tube", .5);
        unsigned rings = node_member_integer(node, "rings", 3, MOST_COLUMNS, 24);
        shape_torus(mesh, axis, radius, tube, rings, node_member_integer(node, "sides", 3, MOST_COLUMNS, 16));
    } else if (shape == SPHERE) {
        unsigned slices = node_member_integer(node, "slices", 3, MOST_COLUMNS, 24);
        shape_sphere(mesh, axis, length_of(node, "radius", 1), slices,
                     node_member_integer(node, "stacks", 2, MOST_COLUMNS, 16));
    } else if (shape == PLANE) {
        double size[2] = {1, 1};
        unsigned segments = node_member_integer(node, "segments", 1, MOST_COLUMNS, 1);
        node_member_vector(node, "size", size, 2, 1e-3, READER_MOST_LENGTH);
        shape_plane(mesh, axis, size, segments);
    } else if (shape == REVOLUTION)
        read_revolution(node, axis, mesh);
    else if (shape == PATCHES)
        reader_patches(node, mesh);
    else
        reader_triangles(node, mesh);
}

static void read_file(const struct node *node, struct model *model, size_t index, int *exit_code)
{
    struct node name = node_member(node, "file");
    char *path = reader_path(node, node_string(&name, NULL));
    node_object(node, "file crease" COMMON);
    double crease = node_member_number(node, "crease", 0, 180, IMPORT_CREASE) * M_PI / 180;
    if (!node->file->failed && (*exit_code = import_file(path, crease, model, index)) != 0)
        node->file->failed = true; /* import_file() has said why */
    free(path);
}

static void read_mesh(const struct node *node, struct model *model, const char *name, int *exit_code)
{
    size_t index = model->mesh_count;
    int material = reader_material(node, model);
    struct node file = node_member(node, "file"), shape = node_member(node, "shape");
    struct node fit = node_member(node, "fit"), uvs = node_member(node, "uvs");
    model_add_mesh(model, name);
    if (!json_is_object(node->value) || !file.value == !shape.value)
        node_fail(node, "must be an object with either \"file\" or \"shape\"");
    else if (file.value)
        read_file(node, model, index, exit_code);
    else
        read_shape(node, &model->meshes[index]);
    if (shape.value && material < 0) { /* shapes have no material of their own */
        material = (int)model->material_count;
        model_add_material(model, name);
    }
    struct model_mesh *mesh = &model->meshes[index];
    for (size_t i = 0; material >= 0 && i < mesh->triangle_count; i++)
        mesh->triangles[i].material = (uint32_t)material;
    mesh->keeps_uvs = node_bool(&uvs, false);
    if (node_bool(&fit, false))
        import_fit(mesh);
    if (node_member_choice(node, "shading", "smooth flat", 0) == 1 && !node->file->failed)
        normals_flat(mesh);
}

void reader_meshes(const struct node *meshes, struct model *model, int *exit_code)
{
    const char *name;
    json_t *value;
    if (meshes->value && !json_is_object(meshes->value))
        node_fail(meshes, "must be an object");
    json_object_foreach(meshes->value, name, value)
    {
        struct node node = node_member(meshes, name);
        if (!node.file->failed)
            read_mesh(&node, model, name, exit_code);
    }
}
