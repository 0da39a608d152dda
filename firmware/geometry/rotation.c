/* SPDX-License-Identifier: MIT */
#include "geometry/rotation.h"

#include "uses.h"

/* A few of these a frame and object, so 64-bit products are fine even where they are library calls. */
static q30_t round_q60(int64_t x)
{
    return fx_s32((x + (INT64_C(1) << 29)) >> 30);
}

struct rotation rotation_product(const struct rotation *a, const struct rotation *b)
{
    const q30_t *p = a->q, *q = b->q;
    struct rotation r;
    /* |p|, |q| components <= 2^30 (1 + 2^-17): four products of at most 2^60.1 sum below 2^63. */
    r.q[0] = round_q60(fx_s64(p[0]) * q[0] - fx_s64(p[1]) * q[1] - fx_s64(p[2]) * q[2] - fx_s64(p[3]) * q[3]);
    r.q[1] = round_q60(fx_s64(p[0]) * q[1] + fx_s64(p[1]) * q[0] + fx_s64(p[2]) * q[3] - fx_s64(p[3]) * q[2]);
    r.q[2] = round_q60(fx_s64(p[0]) * q[2] - fx_s64(p[1]) * q[3] + fx_s64(p[2]) * q[0] + fx_s64(p[3]) * q[1]);
    r.q[3] = round_q60(fx_s64(p[0]) * q[3] + fx_s64(p[1]) * q[2] - fx_s64(p[2]) * q[1] + fx_s64(p[3]) * q[0]);
    return r;
}

struct matrix rotation_matrix(const struct rotation *r)
{
    const int64_t w = r->q[0], x = r->q[1], y = r->q[2], z = r->q[3];
    struct matrix m;
    /* 2 (ab + cd) in Q60: at most 2^62. The diagonal as w2 + x2 - y2 - z2, so that a length a little off 1 scales the
     * whole matrix evenly. */
    m.m[0][0] = round_q60(w * w + x * x - y * y - z * z);
    m.m[1][1] = round_q60(w * w - x * x + y * y - z * z);
    m.m[2][2] = round_q60(w * w - x * x - y * y + z * z);
    m.m[0][1] = round_q60(2 * (x * y - w * z));
    m.m[1][0] = round_q60(2 * (x * y + w * z));
    m.m[0][2] = round_q60(2 * (x * z + w * y));
    m.m[2][0] = round_q60(2 * (x * z - w * y));
    m.m[1][2] = round_q60(2 * (y * z - w * x));
    m.m[2][1] = round_q60(2 * (y * z + w * x));
    return m;
}

void matrix_apply(const struct matrix *m, const int32_t v[3], int32_t out[3])
{
    /* Three products of at most 2^31 * 2^30 sum below 2^63. */
    for (int i = 0; i < 3; i++)
        out[i] = round_q60(fx_s64(m->m[i][0]) * v[0] + fx_s64(m->m[i][1]) * v[1] + fx_s64(m->m[i][2]) * v[2]);
}

void matrix_apply_transposed(const struct matrix *m, const int32_t v[3], int32_t out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = round_q60(fx_s64(m->m[0][i]) * v[0] + fx_s64(m->m[1][i]) * v[1] + fx_s64(m->m[2][i]) * v[2]);
}

/* 1/sqrt of a squared length, at least 2^30: r * 2^-e with r in Q31; refined once beyond the table's 16 bits. */
static uint32_t inverse_length(uint64_t squared, int *exponent)
{
    int shift = 0; /* squared = m * 2^(2 shift), m in [2^30, 2^32) */
    while (squared >= UINT64_C(1) << 32) {
        squared >>= 2;
        shift++;
    }
    uint32_t m = fx_u32(squared), r = fx_rsqrt_norm(m);
    /* Newton: r' = r (3 - v r^2) / 2, v = m / 2^30 in [1, 4), v r^2 near 1: kept in Q30. */
    uint32_t r2 = fx_mulhi_u32(r, r);        /* Q30, at most 2^30 */
    uint32_t vr2 = fx_mulhi_u32(m, r2) << 2; /* Q28 -> Q30, near 2^30 */
    int64_t correction = fx_s64(3u << 30) - vr2;
    r = fx_u32((fx_s64(r) * correction) >> 31);
    *exponent = shift;
    return r;
}

/* v scaled to length 1 in Q30; `terms` up to 4, |v| components below 2^31, |v| at least 2^28: squared from 2^54 on. */
static void normalise(const int32_t *v, int terms, q30_t *out)
{
    uint64_t squared = 0;
    for (int i = 0; i < terms; i++)
        squared += fx_u64(fx_s64(v[i]) * v[i]) >> 2; /* four squares of 2^62 would not fit: a quarter of each */
    int exponent;
    uint32_t r = inverse_length(squared, &exponent);
    /* sqrt(squared) = |v| / 2 = 2^(15 + exponent) * sqrt(m / 2^30): v / |v| = v * r / 2^31 / 2^(16 + exponent);
     * exponent is at least 11. */
    int down = 31 + 16 + exponent - 30;
    for (int i = 0; i < terms; i++) {
        int64_t x = fx_s64(v[i]) * r;
        out[i] = fx_s32((x + (INT64_C(1) << (down - 1))) >> down);
    }
}

void vector_normalise(const int32_t v[3], q30_t out[3])
{
    if (!(v[0] | v[1] | v[2])) {
        out[0] = out[1] = 0;
        out[2] = Q30(1, 1);
        return;
    }
    /* Small components leave few bits for the quarter squares: scale up first. */
    int32_t w[3] = {v[0], v[1], v[2]};
    uint32_t largest = 0;
    for (int i = 0; i < 3; i++) {
        largest |= fx_u32(w[i] < 0 ? -w[i] : w[i]);
    }
    unsigned up = fx_clz(largest);
    up = up > 1 ? up - 1 : 0;
    for (int i = 0; i < 3; i++)
        w[i] *= 1 << up;
    normalise(w, 3, out);
}

struct rotation rotation_spin(const q30_t axis[3], q16_t rate, uint32_t time_ms)
{
    /* |rate * time| < 2^24 * 2^32. Thousandths of Q16 turns; half the angle, as a quaternion wants, is a 2^-17 turn. */
    int64_t thousandths = fx_s64(rate) * time_ms;
    int64_t whole = fx_divide_s64(thousandths, 1000), rest = thousandths - whole * 1000;
    uint32_t half = fx_wrap_add(fx_wrap_u32(whole * 32768), fx_wrap_u32(fx_divide_s64(rest * 32768, 1000)));
    q30_t sine = fx_sin(half);
    struct rotation r = {{fx_cos(half), 0, 0, 0}};
    for (int i = 0; i < 3; i++)
        r.q[i + 1] = round_q60(fx_s64(sine) * axis[i]);
    return r;
}

struct rotation rotation_turn(const struct matrix *to_eye, uint16_t yaw, uint16_t pitch)
{
    /* Half the angle is a 2^-17 turn. The front goes up by a negative turn about x. */
    const uint32_t y = fx_u32(yaw) << 15, x = fx_u32(fx_wrap_u16(-pitch)) << 15;
    const struct rotation about_y = {{fx_cos(y), 0, fx_sin(y), 0}}, about_x = {{fx_cos(x), fx_sin(x), 0, 0}};
    struct rotation eye = rotation_product(&about_x, &about_y), world = {{eye.q[0], 0, 0, 0}};
    /* The eye's turn seen from the world: the same angle, its axis turned back. */
    matrix_apply_transposed(to_eye, eye.q + 1, world.q + 1);
    return world;
}

static struct pose pose_of_key(const struct scene_key *key)
{
    struct pose p = {{{key->rotation[0], key->rotation[1], key->rotation[2], key->rotation[3]}},
                     {key->position[0], key->position[1], key->position[2]},
                     key->scale};
    return p;
}

/* a + (b - a) * t for t in Q16, 0..65536; |b - a| < 2^32 in 64 bits. */
static int32_t mix(int32_t a, int32_t b, uint32_t t)
{
    return fx_s32(a + (((fx_s64(b) - a) * fx_s64(t) + 32768) >> 16));
}

static struct pose pose_between(const struct scene_key *a, const struct scene_key *b, uint32_t time_ms)
{
    /* Keys are sorted and different: the divisor is at least 1, the quotient below 2^16. */
    uint32_t t = fx_u32(fx_divide_u64(fx_u64(time_ms - a->time_ms) << 16, b->time_ms - a->time_ms));
    struct pose p = {0};
    int64_t dot = 0;
    for (int i = 0; i < 4; i++)
        dot += (fx_s64(a->rotation[i]) * b->rotation[i]) >> 2; /* a quarter: four products of 2^60 */
    int32_t q[4];
    for (int i = 0; i < 4; i++)
        q[i] = mix(a->rotation[i], dot < 0 ? -b->rotation[i] : b->rotation[i], t);
    normalise(q, 4, p.rotation.q); /* of unit ones less than a right angle apart: at least 2^30 / sqrt(2) long */
    for (int i = 0; i < 3; i++)
        p.position[i] = mix(a->position[i], b->position[i], t);
    p.scale = mix(a->scale, b->scale, t);
    return p;
}

static struct pose pose_from_keys(const struct scene_header *scene, const struct scene_motion *motion, uint32_t time_ms)
{
    const struct scene_key *key = scene_keys(scene) + motion->first_key;
    unsigned last = motion->key_count - 1u;
    if (time_ms <= key[0].time_ms)
        return pose_of_key(&key[0]);
    if (time_ms >= key[last].time_ms)
        return pose_of_key(&key[last]);
    unsigned i = 0;
    while (key[i + 1].time_ms <= time_ms)
        i++;
    return pose_between(&key[i], &key[i + 1], time_ms);
}

struct pose pose_at(const struct scene_header *scene, const struct scene_object *object, uint32_t time_ms)
{
    const struct scene_motion *motion = &object->motion;
    if (USES(USES_KEYS) && motion->kind == MOTION_KEYS)
        return pose_from_keys(scene, motion, time_ms);
    struct pose p = {{{object->rotation[0], object->rotation[1], object->rotation[2], object->rotation[3]}},
                     {object->position[0], object->position[1], object->position[2]},
                     object->scale};
    if (USES(USES_SPIN) && motion->kind == MOTION_SPIN) {
        struct rotation spin = rotation_spin(motion->axis, motion->rate, time_ms);
        p.rotation = rotation_product(&p.rotation, &spin);
    }
    return p;
}

void light_vector_at(const struct scene_header *scene, const struct scene_light *light, uint32_t time_ms,
                     int32_t out[3])
{
    if (USES(USES_SPIN) && light->motion.kind == MOTION_SPIN) {
        struct rotation spin = rotation_spin(light->motion.axis, light->motion.rate, time_ms);
        struct matrix m = rotation_matrix(&spin);
        matrix_apply(&m, light->vector, out);
    } else if (USES(USES_KEYS) && light->motion.kind == MOTION_KEYS) {
        struct pose p = pose_from_keys(scene, &light->motion, time_ms);
        struct matrix m = rotation_matrix(&p.rotation);
        matrix_apply(&m, light->vector, out);
        for (int i = 0; light->kind == LIGHT_POINT && i < 3; i++) {
            /* turned, a component may reach sqrt(3) 2^30; held where near_point() can take it */
            int64_t sum = fx_s64(out[i]) + p.position[i];
            out[i] = fx_s32(sum > INT32_MAX ? INT32_MAX : sum < -INT32_MAX ? -INT32_MAX : sum);
        }
    } else {
        for (int i = 0; i < 3; i++)
            out[i] = light->vector[i];
    }
}
