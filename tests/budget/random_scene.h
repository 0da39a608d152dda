/* SPDX-License-Identifier: MIT */
/* Scenes at random: a net that faces the eye, its normals near and far from its shape, any material, lights near and
 * far, both cameras and viewers; every other one with effects: texture, bump map, fog, two sides, a camera from near to
 * far away. */
#ifndef BUDGET_RANDOM_SCENE_H
#define BUDGET_RANDOM_SCENE_H

#include "../unit/random.h"
#include "../unit/scene_case.h"

#define RANDOM_WIDTH  64
#define RANDOM_HEIGHT 48
#define RANDOM_SIDE   3 /* vertices a side of the mesh */

static struct scene_vertex random_vertices[RANDOM_SIDE * RANDOM_SIDE];
static struct scene_triangle random_triangles[2 * (RANDOM_SIDE - 1) * (RANDOM_SIDE - 1)];
static int16_t random_uvs[RANDOM_SIDE * RANDOM_SIDE][2];
static struct scene_tangent random_tangents[RANDOM_SIDE * RANDOM_SIDE];
static uint16_t random_texels[64 * 64];
static int8_t random_bumps[64 * 64][2];

/* Two units wide, its vertices and normals moved at random: `lean` 0 leaves the normals along the view, 3 forgets it.
 */
static inline void random_mesh(struct scene_case *c, double lean)
{
    unsigned count = 0;
    for (int i = 0; i < RANDOM_SIDE * RANDOM_SIDE; i++) {
        double off[3];
        random_direction(off, 3);
        const double at[3] = {(i % RANDOM_SIDE - 1) * .8 + random_real(-.19, .19),
                              (1 - i / RANDOM_SIDE) * .8 + random_real(-.19, .19), random_real(-.4, .4)};
        for (int k = 0; k < 3; k++)
            random_vertices[i].position[k] = (int16_t)lrint(at[k] * 32767);
        scene_case_normal(random_vertices[i].normal, off[0] * lean, off[1] * lean, off[2] * lean + 1.0001);
    }
    for (int row = 0; row < RANDOM_SIDE - 1; row++)
        for (int column = 0; column < RANDOM_SIDE - 1; column++) {
            const int a = row * RANDOM_SIDE + column,
                      corner[2][3] = {{a, a + RANDOM_SIDE, a + RANDOM_SIDE + 1}, {a, a + RANDOM_SIDE + 1, a + 1}};
            for (int t = 0; t < 2; t++, count++) {
                for (int k = 0; k < 3; k++)
                    random_triangles[count].corner[k] = (uint16_t)corner[t][(k + column) % 3];
                scene_case_bend(&random_triangles[count], random_vertices);
            }
        }
    c->mesh[0].vertices = random_vertices;
    c->mesh[0].triangles = random_triangles;
    c->mesh[0].vertex_count = RANDOM_SIDE * RANDOM_SIDE;
    c->mesh[0].triangle_count = count;
    c->object[0].position[2] = (q16_t)(-random_real(1.5, 3) * CASE_UNIT);
}

static inline void random_lights(struct scene_case *c)
{
    const int near = random_fraction() < .3;
    c->light_count = random_fraction() < .6 ? 1 : (unsigned)random_between(2, SCENE_MAX_LIGHTS);
    for (unsigned i = 0; i < c->light_count; i++) {
        struct scene_light *light = &c->light[i];
        double towards[3];
        random_direction(towards, 3);
        light->kind = near && random_fraction() < .7 ? LIGHT_POINT : LIGHT_DIRECTIONAL;
        const double distance = light->kind == LIGHT_POINT ? random_real(.1, 3) * CASE_UNIT : 1 << 30;
        for (int k = 0; k < 3; k++) {
            light->colour[k] = (uint16_t)random_between(0, 32768);
            light->vector[k] = (int32_t)lrint(towards[k] * distance);
        }
        if (light->kind == LIGHT_POINT)
            light->vector[2] += c->object[0].position[2];
    }
}

static inline void random_material(struct scene_material *m)
{
    static const uint16_t exponents[] = {1, 2, 3, 5, 8, 10, 15, 20, 30, 50, 100, 200, 500, 1023};
    for (int k = 0; k < 3; k++) {
        m->diffuse[k] = (uint16_t)random_between(0, 32768);
        m->specular[k] = (uint16_t)random_between(0, 32768);
    }
    m->ka = (uint16_t)random_between(0, 8192);
    m->kd = (uint16_t)random_between(0, 32768);
    m->ks = (uint16_t)random_between(0, 32768);
    m->shininess = exponents[random_between(0, (int)(sizeof exponents / sizeof *exponents) - 1)];
}

/* Waves, from flat to as steep as can be, and noise over them. */
struct random_waves {
    double phase, middle, height, noise;
    int along[2]; /* waves a texture's side */
};

static inline struct random_waves random_some_waves(void)
{
    struct random_waves w = {random_real(0, 6.3),
                             random_fraction(),
                             random_fraction() * random_fraction(),
                             random_fraction() < .7 ? 0 : random_magnitude(.01, 1),
                             {random_between(-2, 2), random_between(-2, 2)}};
    return w;
}

/* 0..1 at a texel. */
static inline double random_wave(const struct random_waves *w, double u, double v)
{
    const double at = w->middle + w->height * sin(6.283185307 * (w->along[0] * u + w->along[1] * v) + w->phase) +
                      w->noise * random_real(-.5, .5);
    return fmin(fmax(at, 0), 1);
}

/* Texels' size and what becomes of coordinates. */
static inline struct scene_texture random_texture(void)
{
    const uint8_t flags[] = {0, TEXTURE_CLAMP_U, TEXTURE_CLAMP_V, TEXTURE_CLAMP_U | TEXTURE_CLAMP_V};
    return (struct scene_texture){.log2_width = (uint8_t)random_between(0, 6),
                                  .log2_height = (uint8_t)random_between(0, 6),
                                  .flags = (uint8_t)(TEXTURE_BILINEAR | flags[random_between(0, 3)])};
}

static inline void random_fill(const struct scene_texture *t, int bump)
{
    struct random_waves w[3];
    const unsigned width = 1u << t->log2_width, height = 1u << t->log2_height;
    for (int k = 0; k < 3; k++)
        w[k] = random_some_waves();
    for (unsigned i = 0; i < width * height; i++) {
        double at[3];
        for (int k = 0; k < 3; k++)
            at[k] = random_wave(&w[k], (i % width + .5) / width, (i / width + .5) / height);
        if (bump)
            for (int k = 0; k < 2; k++)
                random_bumps[i][k] = (int8_t)lrint(at[k] * 254 - 127);
        else
            random_texels[i] = (uint16_t)(lrint(at[0] * 31) << 11 | lrint(at[1] * 63) << 5 | lrint(at[2] * 31));
    }
}

/* Texture coordinates, from a texel to all that there are, and frames, which turn from vertex to vertex or not. */
static inline void random_mapping(struct scene_case *c)
{
    const double wide = random_magnitude(.05, 6), off[2] = {random_real(-1, 1), random_real(-1, 1)},
                 moved = random_fraction() * random_fraction(), turned = random_fraction() * random_fraction();
    double u[3];
    random_direction(u, 3);
    for (int i = 0; i < RANDOM_SIDE * RANDOM_SIDE; i++) {
        const struct scene_vertex *v = &random_vertices[i];
        struct scene_tangent *t = &random_tangents[i];
        double at[3], along = 0, square = 0;
        random_direction(at, 3);
        for (int k = 0; k < 2; k++)
            random_uvs[i][k] = (int16_t)lrint(fmin(
                fmax(4096 * (off[k] + wide * (v->position[k] / 32768. + moved * random_real(-1, 1))), -32768), 32767));
        for (int k = 0; k < 3; k++) {
            at[k] = u[k] + turned * at[k];
            along += at[k] * v->normal[k];
            square += (double)v->normal[k] * v->normal[k];
        }
        for (int k = 0; k < 3; k++)
            at[k] -= along / square * v->normal[k];
        if (hypot(hypot(at[0], at[1]), at[2]) < .01) /* along the normal: any that is across it */
            for (int k = 0; k < 3; k++)
                at[k] = (k == 0) - (double)v->normal[k] * v->normal[0] / square;
        scene_case_normal(t->tangent, at[0], at[1], at[2]);
        t->sign = i == 0 ? random_between(0, 1) ? 1 : -1 : random_tangents[0].sign;
    }
    c->uvs = (const int16_t(*)[2])random_uvs;
    c->tangents = random_tangents;
}

/* Fog no thinner than 256 depths, what depth is off by being more than fog of a step otherwise. */
static inline void random_fog(struct scene_case *c)
{
    const struct scene_camera *camera = &c->head.camera;
    struct scene_fog *fog = &c->head.fog;
    const double at = -c->object[0].position[2] / (double)CASE_UNIT, near = camera->near_plane / (double)CASE_UNIT,
                 far = camera->far_plane / (double)CASE_UNIT, back = fmin(at + 1, far),
                 least = 256 / 65519. * (camera->kind == CAMERA_PERSPECTIVE ? back * back / near : far - near);
    for (int k = 0; k < 3; k++)
        fog->colour[k] = (uint16_t)random_between(0, 32768);
    fog->kind = random_fraction() < .5 ? FOG_LINEAR : FOG_EXPONENTIAL;
    const double thickness = random_magnitude(least, fmax(4, 2 * least));
    if (fog->kind == FOG_EXPONENTIAL) {
        fog->density = (uint32_t)fmin((1 << 24) / thickness, 1 << 28);
        return;
    }
    fog->from = (q16_t)(at * random_real(.2, 1.5) * CASE_UNIT);
    fog->to = fog->from + (q16_t)(thickness * CASE_UNIT);
}

/* The camera in front of the net, or further away with a longer lens. Nothing is cut at its planes: a cut's corner is
 * rounded to sub-pixels, and with it all shading of the piece. */
static inline void random_distance(struct scene_case *c)
{
    struct scene_camera *camera = &c->head.camera;
    const double at = random_magnitude(.7, 30);
    for (unsigned i = 0; i < c->light_count; i++)
        if (c->light[i].kind == LIGHT_POINT)
            c->light[i].vector[2] -= c->object[0].position[2] + (int32_t)(at * CASE_UNIT);
    c->object[0].position[2] = -(q16_t)(at * CASE_UNIT);
    if (camera->kind == CAMERA_PERSPECTIVE)
        camera->focal = (q16_t)(at * random_real(.4, 1) * 32 * CASE_UNIT);
    camera->far_plane = (q16_t)((at + random_magnitude(.45, 10)) * CASE_UNIT);
    camera->near_plane = (q16_t)((at - .45) * random_magnitude(.125, 1) * CASE_UNIT);
}

static inline void random_effects(struct scene_case *c)
{
    if (random_fraction() < .5)
        random_distance(c);
    if (random_fraction() < .3)
        random_fog(c);
    if (random_fraction() < .2)
        c->material[0].flags |= MATERIAL_TWO_SIDED;
    const double mapped = random_fraction();
    if (mapped < .75)
        random_mapping(c);
    if (mapped < .5) {
        c->texture = random_texture();
        random_fill(&c->texture, 0);
        c->texels = random_texels;
    }
    if (mapped > .4 && mapped < .75) {
        c->bump = random_texture();
        c->bump.steepness = (uint16_t)random_magnitude(256, TEXTURE_UNIT * .7);
        random_fill(&c->bump, 1);
        if (c->material[0].shininess > 200) /* above, normals in Q14 show: by up to 4/255 */
            c->material[0].shininess = 200;
        c->bumps = (const int8_t(*)[2])random_bumps;
    }
}

/* A checked scene, to be freed. */
static inline struct scene_header *random_scene(uint32_t seed)
{
    struct scene_case c;
    random_seed(seed * 2654435761u + 1);
    for (int i = 0; i < 8; i++)
        random_bits();
    scene_case_default(&c, RANDOM_WIDTH, RANDOM_HEIGHT);
    c.head.camera.kind = random_fraction() < .4 ? CAMERA_ORTHOGRAPHIC : CAMERA_PERSPECTIVE;
    c.head.camera.viewer = random_fraction() < .2 ? VIEWER_LOCAL : VIEWER_INFINITE;
    if (c.head.camera.kind == CAMERA_ORTHOGRAPHIC)
        c.head.camera.focal = 24 * CASE_UNIT;
    c.head.camera.near_plane = CASE_UNIT;
    random_material(&c.material[0]);
    static const double leans[] = {.1, .3, .8, 3};
    random_mesh(&c, leans[random_between(0, 3)] * random_fraction());
    random_lights(&c);
    if (seed % 2)
        random_effects(&c);
    return scene_case_blob(&c);
}

#endif
