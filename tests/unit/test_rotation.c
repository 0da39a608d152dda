/* SPDX-License-Identifier: MIT */
/* Rotations, spins and keys against double precision. */
#include "geometry/rotation.h"
#include "random.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>
#include <string.h>

#define ONE   0x1p30
#define UNIT  (1 << 16) /* a scene unit in Q16 */
#define COUNT 100000

struct quaternion {
    double q[4];
};

static struct quaternion real(const struct rotation *r)
{
    return (struct quaternion){{r->q[0] / ONE, r->q[1] / ONE, r->q[2] / ONE, r->q[3] / ONE}};
}

static struct quaternion product(struct quaternion a, struct quaternion b)
{
    const double *p = a.q, *q = b.q;
    return (struct quaternion){
        {p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3], p[0] * q[1] + p[1] * q[0] + p[2] * q[3] - p[3] * q[2],
         p[0] * q[2] - p[1] * q[3] + p[2] * q[0] + p[3] * q[1], p[0] * q[3] + p[1] * q[2] - p[2] * q[1] + p[3] * q[0]}};
}

/* q v q*: the definition, rather than a matrix. */
static void turn(struct quaternion q, const double v[3], double out[3])
{
    struct quaternion there = {{0, v[0], v[1], v[2]}}, back = {{q.q[0], -q.q[1], -q.q[2], -q.q[3]}};
    struct quaternion turned = product(product(q, there), back);
    memcpy(out, turned.q + 1, 3 * sizeof *out);
}

static struct rotation random_rotation(void)
{
    struct rotation r;
    double v[4];
    random_direction(v, 4);
    if (random_bits() % 4 == 0) { /* half and quarter turns about the axes, whose products have nothing to spare */
        static const double few[] = {0, 0, 1, -1};
        double length = 0;
        for (int i = 0; i < 4; i++) {
            v[i] = few[random_bits() % 4];
            length += v[i] * v[i];
        }
        v[0] = length > 0 ? v[0] : 1;
        length = length > 0 ? sqrt(length) : 1;
        for (int i = 0; i < 4; i++)
            v[i] /= length;
    }
    double length = 1 + random_between(-1, 1) * 0x1p-20; /* as scene.h allows */
    for (int i = 0; i < 4; i++)
        r.q[i] = (q30_t)lrint(v[i] * length * ONE);
    return r;
}

static double distance(const double *a, const double *b, int n)
{
    double largest = 0;
    for (int i = 0; i < n; i++)
        largest = fmax(largest, fabs(a[i] - b[i]));
    return largest;
}

static void a_product_is_within_its_error(void **state)
{
    (void)state;
    random_seed(31);
    for (int i = 0; i < COUNT; i++) {
        struct rotation a = random_rotation(), b = random_rotation(), r = rotation_product(&a, &b);
        struct quaternion got = real(&r), wanted = product(real(&a), real(&b));
        assert_true(distance(got.q, wanted.q, 4) < 0x1p-28);
    }
}

static void a_product_turns_by_its_second_factor_first(void **state)
{
    (void)state;
    const q30_t half = 759250125; /* sqrt(1/2) */
    const struct rotation about_x = {{half, half, 0, 0}}, about_y = {{half, 0, half, 0}};
    struct rotation both = rotation_product(&about_y, &about_x); /* x first: z goes to -y, and stays there */
    struct matrix m = rotation_matrix(&both);
    const int32_t z[3] = {0, 0, 1000};
    int32_t out[3];
    matrix_apply(&m, z, out);
    assert_int_equal(out[0], 0);
    assert_int_equal(out[1], -1000);
    assert_int_equal(out[2], 0);
}

static void a_matrix_turns_as_its_quaternion_does(void **state)
{
    (void)state;
    random_seed(32);
    for (int i = 0; i < COUNT; i++) {
        struct rotation r = random_rotation();
        struct matrix m = rotation_matrix(&r);
        for (int axis = 0; axis < 3; axis++) {
            double v[3] = {axis == 0, axis == 1, axis == 2}, wanted[3];
            double got[3] = {m.m[0][axis] / ONE, m.m[1][axis] / ONE, m.m[2][axis] / ONE};
            turn(real(&r), v, wanted);
            assert_true(distance(got, wanted, 3) < 0x1p-27);
        }
    }
}

static void a_matrix_is_applied_to_the_nearest_integer(void **state)
{
    (void)state;
    random_seed(33);
    for (int i = 0; i < COUNT; i++) {
        struct rotation r = random_rotation();
        struct matrix m = rotation_matrix(&r);
        int32_t reach = (int32_t)random_magnitude(4, 1239850262), v[3], out[3], back[3]; /* 2^31 / sqrt(3) */
        for (int k = 0; k < 3; k++)
            v[k] = i & 1 ? random_between(-reach, reach) : random_between(0, 1) ? reach : -reach;
        matrix_apply(&m, v, out);
        matrix_apply_transposed(&m, v, back);
        for (int k = 0; k < 3; k++) {
            long double there = 0, and_back = 0; /* 64 bits of mantissa */
            for (int j = 0; j < 3; j++) {
                there += (long double)m.m[k][j] * v[j];
                and_back += (long double)m.m[j][k] * v[j];
            }
            assert_true(fabsl(out[k] - there / 0x1p30L) <= .5L);
            assert_true(fabsl(back[k] - and_back / 0x1p30L) <= .5L);
        }
    }
}

static void a_vector_of_any_length_is_normalised_within_its_error(void **state)
{
    (void)state;
    random_seed(34);
    for (int i = 0; i < COUNT; i++) {
        int32_t reach = (int32_t)random_magnitude(1, 0x1p30 - 1), v[3], out[3];
        for (int k = 0; k < 3; k++)
            v[k] = random_bits() % 4 ? random_between(-reach, reach) : random_between(-1, 1) * reach;
        double length = sqrt((double)v[0] * v[0] + (double)v[1] * v[1] + (double)v[2] * v[2]);
        vector_normalise(v, out);
        if (length == 0) {
            assert_true(out[0] == 0 && out[1] == 0 && out[2] == 1 << 30);
            continue;
        }
        for (int k = 0; k < 3; k++)
            assert_true(fabs(out[k] / ONE - v[k] / length) < 0x1p-26);
    }
}

static struct quaternion real_spin(const q30_t axis[3], q16_t rate, uint32_t time_ms)
{
    /* Turns modulo 2, as the quaternion has half the angle, before they lose digits. */
    long double turns = fmodl((long double)rate / 65536 * time_ms / 1000, 2);
    double half = (double)(turns * 3.14159265358979323846L);
    return (struct quaternion){
        {cos(half), sin(half) * axis[0] / ONE, sin(half) * axis[1] / ONE, sin(half) * axis[2] / ONE}};
}

static void random_axis(q30_t axis[3])
{
    double v[3];
    random_direction(v, 3);
    for (int i = 0; i < 3; i++)
        axis[i] = (q30_t)lrint(v[i] * ONE);
}

#define SPIN_ERROR 0x1p-28

static void a_spin_is_right_at_any_time_and_rate(void **state)
{
    (void)state;
    random_seed(35);
    for (int i = 0; i < COUNT; i++) {
        q30_t axis[3];
        random_axis(axis);
        q16_t rate = i & 1 ? random_between(-(1 << 24) + 1, (1 << 24) - 1) : random_between(-UNIT, UNIT);
        uint32_t time_ms = i & 2 ? random_bits() : i & 4 ? UINT32_MAX : random_bits() >> 16;
        struct rotation r = rotation_spin(axis, rate, time_ms);
        struct quaternion got = real(&r), wanted = real_spin(axis, rate, time_ms);
        assert_true(distance(got.q, wanted.q, 4) < SPIN_ERROR);
    }
}

static const struct scene_object still = {
    .rotation = {1 << 30, 0, 0, 0}, .position = {UNIT, -2 * UNIT, 3 * UNIT}, .scale = UNIT};

/* A scene that is nothing but keys. */
struct keys {
    struct scene_header header;
    struct scene_key key[4];
};

static void a_million_steps_of_time_do_not_drift(void **state)
{
    (void)state;
    struct scene_object object = still;
    struct keys scene = {.header.keys = offsetof(struct keys, key)};
    random_seed(36);
    object.motion.kind = MOTION_SPIN;
    object.motion.rate = 12345;
    random_axis(object.motion.axis);
    struct rotation turned = random_rotation();
    memcpy(object.rotation, turned.q, sizeof object.rotation);
    uint32_t time_ms = 0;
    for (int i = 0; i < 1000000; i++, time_ms += 33) {
        struct pose pose = pose_at(&scene.header, &object, time_ms);
        if (i % 16 && i < 999000)
            continue; /* the truth takes longer than the pose */
        struct quaternion wanted = product(real(&turned), real_spin(object.motion.axis, object.motion.rate, time_ms));
        assert_true(distance(real(&pose.rotation).q, wanted.q, 4) < SPIN_ERROR + 0x1p-28);
        assert_memory_equal(pose.position, object.position, sizeof pose.position);
        assert_int_equal(pose.scale, object.scale);
    }
}

static void random_keys(struct keys *scene, struct scene_object *object, unsigned count)
{
    memset(scene, 0, sizeof *scene);
    scene->header.keys = offsetof(struct keys, key);
    *object = still;
    object->motion.kind = MOTION_KEYS;
    object->motion.key_count = (uint16_t)count;
    object->motion.first_key = (uint16_t)(4 - count);
    uint32_t time_ms = random_bits() >> random_between(8, 31);
    for (unsigned i = 4 - count; i < 4; i++) {
        struct scene_key *key = &scene->key[i];
        struct rotation r = random_rotation();
        memcpy(key->rotation, r.q, sizeof key->rotation);
        key->time_ms = time_ms;
        time_ms += 1 + (random_bits() >> random_between(2, 31));
        for (int k = 0; k < 3; k++)
            key->position[k] = random_between(-(1 << 30) + 1, (1 << 30) - 1);
        key->scale = random_between(1 << 8, (1 << 24) - 1);
    }
}

static void assert_pose_is_key(const struct pose *pose, const struct scene_key *key)
{
    assert_memory_equal(pose->rotation.q, key->rotation, sizeof key->rotation);
    assert_memory_equal(pose->position, key->position, sizeof key->position);
    assert_int_equal(pose->scale, key->scale);
}

static void before_the_first_key_and_after_the_last_nothing_moves(void **state)
{
    (void)state;
    struct keys scene;
    struct scene_object object;
    random_seed(37);
    for (unsigned i = 0; i < 1000; i++) {
        random_keys(&scene, &object, 1 + i % 4);
        const struct scene_key *first = &scene.key[object.motion.first_key], *last = &scene.key[3];
        const uint32_t early[] = {0, first->time_ms}, late[] = {last->time_ms, last->time_ms + 1, UINT32_MAX};
        for (int j = 0; j < 2; j++) {
            struct pose pose = pose_at(&scene.header, &object, early[j]);
            assert_pose_is_key(&pose, first);
        }
        for (int j = 0; j < 3; j++) {
            struct pose pose = pose_at(&scene.header, &object, late[j]);
            assert_pose_is_key(&pose, last);
        }
    }
}

/* Time between keys is known to 2^-16 of the way. */
static void between_keys_everything_goes_straight(void **state)
{
    (void)state;
    struct keys scene;
    struct scene_object object;
    random_seed(38);
    for (int i = 0; i < COUNT; i++) {
        random_keys(&scene, &object, 2 + (unsigned)i % 3);
        int n = random_between(object.motion.first_key, 2);
        const struct scene_key *a = &scene.key[n], *b = a + 1;
        uint32_t gap = b->time_ms - a->time_ms;
        uint32_t time_ms = a->time_ms + (uint32_t)(random_fraction() * gap);
        double t = (double)(time_ms - a->time_ms) / gap, dot = 0, length = 0, wanted[4];
        struct pose pose = pose_at(&scene.header, &object, time_ms);
        for (int k = 0; k < 3; k++) {
            double far = (double)b->position[k] - a->position[k];
            assert_true(fabs(pose.position[k] - (a->position[k] + far * t)) <= fabs(far) * 0x1p-16 + .51);
        }
        double grows = (double)b->scale - a->scale;
        assert_true(fabs(pose.scale - (a->scale + grows * t)) <= fabs(grows) * 0x1p-16 + .51);
        for (int k = 0; k < 4; k++)
            dot += (double)a->rotation[k] * b->rotation[k];
        if (fabs(dot) < 0x1p-20 * ONE * ONE)
            continue; /* half a turn apart: both ways are as short */
        for (int k = 0; k < 4; k++) {
            wanted[k] = a->rotation[k] * (1 - t) + b->rotation[k] * (dot < 0 ? -t : t);
            length += wanted[k] * wanted[k];
        }
        length = sqrt(length); /* at least sqrt(1/2) on the shorter way */
        for (int k = 0; k < 4; k++)
            wanted[k] /= length;
        assert_true(time_ms == a->time_ms || distance(real(&pose.rotation).q, wanted, 4) < 2.1 * 0x1p-16);
    }
}

/* Between keys a rotation keeps the length that rotation_matrix() wants. */
static void between_keys_a_rotation_is_a_unit(void **state)
{
    (void)state;
    struct keys scene;
    struct scene_object object;
    random_seed(39);
    for (int i = 0; i < COUNT; i++) {
        random_keys(&scene, &object, 2);
        const struct scene_key *a = &scene.key[2];
        if (a[1].time_ms - a->time_ms < 2)
            continue;
        uint32_t time_ms = a->time_ms + 1 + (uint32_t)(random_fraction() * (a[1].time_ms - a->time_ms - 1));
        struct pose pose = pose_at(&scene.header, &object, time_ms);
        struct quaternion q = real(&pose.rotation);
        double squared = q.q[0] * q.q[0] + q.q[1] * q.q[1] + q.q[2] * q.q[2] + q.q[3] * q.q[3];
        assert_true(fabs(sqrt(squared) - 1) < 0x1p-18);
    }
}

static void a_light_moves_as_its_motion_says(void **state)
{
    (void)state;
    struct keys scene;
    struct scene_object object;
    random_seed(40);
    for (int i = 0; i < COUNT; i++) {
        struct scene_light light = {.kind = i & 1 ? LIGHT_POINT : LIGHT_DIRECTIONAL};
        double v[3], wanted[3], size = light.kind == LIGHT_POINT ? random_real(0, 0x1p29) : ONE;
        int32_t out[3];
        uint32_t time_ms = random_bits() >> random_between(0, 31);
        random_direction(v, 3);
        for (int k = 0; k < 3; k++) {
            light.vector[k] = (int32_t)lrint(v[k] * size);
            v[k] = light.vector[k];
        }
        random_keys(&scene, &object, 3);
        light.motion = object.motion;
        light.motion.kind = (uint16_t)(i / 2 % 3);
        light.motion.rate = random_between(-UNIT, UNIT);
        random_axis(light.motion.axis);
        light_vector_at(&scene.header, &light, time_ms, out);
        if (light.motion.kind == MOTION_KEYS) {
            struct pose pose = pose_at(&scene.header, &object, time_ms); /* tested above */
            turn(real(&pose.rotation), v, wanted);
            for (int k = 0; k < 3 && light.kind == LIGHT_POINT; k++)
                wanted[k] += pose.position[k];
        } else if (light.motion.kind == MOTION_SPIN) {
            turn(real_spin(light.motion.axis, light.motion.rate, time_ms), v, wanted);
        } else {
            memcpy(wanted, v, sizeof wanted);
        }
        for (int k = 0; k < 3; k++)
            assert_true(fabs(out[k] - wanted[k]) <= .5 + size * 0x1p-26);
    }
}

/* A light's vector may be as long as sqrt(3) times its components' limit, and its key's position comes on top. */
static void a_light_at_the_end_of_every_range_is_held(void **state)
{
    (void)state;
    struct {
        struct scene_header head;
        struct scene_key key;
    } scene = {.head = {.keys = sizeof(struct scene_header), .key_count = 1}};
    const int32_t most = (1 << 30) - 1;
    struct scene_light light = {.kind = LIGHT_POINT, .vector = {most, -most, 0}};
    light.motion = (struct scene_motion){.kind = MOTION_KEYS, .key_count = 1};
    /* an eighth of a turn about z: (1, -1) to (sqrt 2, 0) */
    scene.key = (struct scene_key){.rotation = {992008094, 0, 0, 410903207}, .position = {most, 0, 0}, .scale = 65536};
    int32_t at[3];
    light_vector_at(&scene.head, &light, 0, at);
    assert_int_equal(at[0], INT32_MAX);
    scene.key.position[0] = -most;
    light_vector_at(&scene.head, &light, 0, at);
    assert_true(abs(at[0] - 444758425) < 64 && abs(at[1]) < 64);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_product_is_within_its_error),
        cmocka_unit_test(a_product_turns_by_its_second_factor_first),
        cmocka_unit_test(a_matrix_turns_as_its_quaternion_does),
        cmocka_unit_test(a_matrix_is_applied_to_the_nearest_integer),
        cmocka_unit_test(a_vector_of_any_length_is_normalised_within_its_error),
        cmocka_unit_test(a_spin_is_right_at_any_time_and_rate),
        cmocka_unit_test(a_million_steps_of_time_do_not_drift),
        cmocka_unit_test(before_the_first_key_and_after_the_last_nothing_moves),
        cmocka_unit_test(between_keys_everything_goes_straight),
        cmocka_unit_test(between_keys_a_rotation_is_a_unit),
        cmocka_unit_test(a_light_moves_as_its_motion_says),
        cmocka_unit_test(a_light_at_the_end_of_every_range_is_held),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
