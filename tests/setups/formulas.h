/* SPDX-License-Identifier: MIT */
/*
 * The set-ups as the papers print them, on a type `real` with + - * / and real_root(), which whoever includes this
 * defines: double, or in count.cc a type that counts its operations. See setup.h for what each is.
 */
#ifndef FORMULAS_H
#define FORMULAS_H

struct real_case {
    real x1, y1, x2, y2; /* corners 1 and 2 from corner 0, pixels */
    real n[3][3], l[3];
    real k12, k23, k13; /* (Ni.Nj - 1) / 2 */
};

/* N.L at the corners; of the edges the middle samples, or for X the bulges (Ii + Ij) kij. */
struct real_samples {
    real i1, i2, i3, i12, i23, i13;
};

/* a x^2 + b y^2 + c x y + d x + e y + f, in pixels from corner 0. */
struct real_quadratic {
    real a, b, c, d, e, f;
};

static inline real real_dot(const real *a, const real *b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* X eq. 1-3. */
static inline void real_values(const struct real_case *c, struct real_samples *s)
{
    s->i1 = real_dot(c->l, c->n[0]);
    s->i2 = real_dot(c->l, c->n[1]);
    s->i3 = real_dot(c->l, c->n[2]);
}

static inline real real_mid_edge(const real *n1, const real *n2, real i1, real i2)
{
    const real n[3] = {n1[0] + n2[0], n1[1] + n2[1], n1[2] + n2[2]};
    return (i1 + i2) / real_root(real_dot(n, n));
}

/* X eq. 4-6. */
static inline void real_sample_middle(const struct real_case *c, struct real_samples *s)
{
    real_values(c, s);
    s->i12 = real_mid_edge(c->n[0], c->n[1], s->i1, s->i2);
    s->i23 = real_mid_edge(c->n[1], c->n[2], s->i2, s->i3);
    s->i13 = real_mid_edge(c->n[0], c->n[2], s->i1, s->i3);
}

/* X eq. 32. */
static inline void real_sample_x(const struct real_case *c, struct real_samples *s)
{
    const real half = 0.5;
    real_values(c, s);
    s->i12 = (s->i1 + s->i2) * (real_dot(c->n[0], c->n[1]) - 1) * half;
    s->i23 = (s->i2 + s->i3) * (real_dot(c->n[1], c->n[2]) - 1) * half;
    s->i13 = (s->i1 + s->i3) * (real_dot(c->n[0], c->n[2]) - 1) * half;
}

static inline void real_sample_x_k(const struct real_case *c, struct real_samples *s)
{
    real_values(c, s);
    s->i12 = (s->i1 + s->i2) * c->k12;
    s->i23 = (s->i2 + s->i3) * c->k23;
    s->i13 = (s->i1 + s->i3) * c->k13;
}

/* Lee and Jen, after eq. 9; their b is c here and their c is b. */
static inline int real_solve_lee_jen(const struct real_case *p, const struct real_samples *s,
                                     struct real_quadratic *out)
{
    const real n0 = s->i1, n1 = s->i2, n2 = s->i3, n3 = s->i23, n4 = s->i13, n5 = s->i12;
    const real w1 = p->x1 * p->y2, w2 = p->x2 * p->y1, w3 = w1 - w2;
    const real t = n0 + n1 - 2 * n5, u = n0 + n2 - 2 * n4, v = n0 + n3 - n4 - n5;
    const real g = 2 * n5 - 2 * n0 - t, h = 2 * n4 - 2 * n0 - u;
    const real r = 1 / w3, r2 = r * r;
    out->a = 2 * (t * p->y2 * p->y2 + u * p->y1 * p->y1 - 2 * v * p->y1 * p->y2) * r2;
    out->c = 4 * (v * (w1 + w2) - u * p->x1 * p->y1 - t * p->x2 * p->y2) * r2;
    out->b = 2 * (u * p->x1 * p->x1 + t * p->x2 * p->x2 - 2 * v * p->x1 * p->x2) * r2;
    out->d = (g * p->y2 - h * p->y1) * r;
    out->e = (h * p->x1 - g * p->x2) * r;
    out->f = n0;
    return 1;
}

/* Abbas and others, section 2: what they count as 25 additions, 51 multiplications and 5 divisions. */
static inline int real_solve_abbas(const struct real_case *c, const struct real_samples *s, struct real_quadratic *out)
{
    const real x2 = c->x1, y2 = c->y1, x3 = c->x2, y3 = c->y2;
    const real c2 = 4 * s->i12 - 3 * s->i1 - s->i2, c12 = s->i1 + s->i2 - 2 * s->i12;
    const real c3 = 4 * s->i13 - 3 * s->i1 - s->i3, c13 = s->i1 + s->i3 - 2 * s->i13;
    const real c23 = 4 * (s->i1 - s->i12 - s->i13 + s->i23);
    const real d23 = 2 * x2 * x2 * y3 - 2 * x2 * y2 * x3, d32 = 2 * y2 * x3 * x3 - 2 * x2 * x3 * y3;
    const real e23 = x2 * y2 * y3 - y2 * y2 * x3, e32 = y2 * x3 * y3 - x2 * y3 * y3;
    const real det = x2 * y3 - y2 * x3, den = e32 * d23 - e23 * d32;
    const real p = 4 * c12 * y3 - c23 * y2, q = 4 * c13 * y2 - c23 * y3;
    if (y2 == 0)
        return 0;
    out->f = s->i1;
    out->e = (c3 * x2 - c2 * x3) / det;
    out->d = (c2 * y3 - c3 * y2) / det;
    out->c = (q * d23 - p * d32) / den;
    out->a = (p * e32 - q * e23) / den;
    out->b = (2 * c12 - out->a * x2 * x2 - out->c * x2 * y2) / (y2 * y2);
    return 1;
}

static inline int real_solve_abbas_safe(const struct real_case *c, const struct real_samples *s,
                                        struct real_quadratic *out)
{
    const real x2 = c->x1, y2 = c->y1, x3 = c->x2, y3 = c->y2;
    const real c2 = 4 * s->i12 - 3 * s->i1 - s->i2, c12 = s->i1 + s->i2 - 2 * s->i12;
    const real c3 = 4 * s->i13 - 3 * s->i1 - s->i3, c13 = s->i1 + s->i3 - 2 * s->i13;
    const real c23 = 4 * (s->i1 - s->i12 - s->i13 + s->i23);
    const real w1 = x2 * y3, w2 = x3 * y2, r = 1 / (w1 - w2), r2 = r * r;
    out->f = s->i1;
    out->e = (c3 * x2 - c2 * x3) * r;
    out->d = (c2 * y3 - c3 * y2) * r;
    out->c = (c23 * (w1 + w2) - 4 * c12 * x3 * y3 - 4 * c13 * x2 * y2) * r2;
    out->a = (2 * c12 * y3 * y3 + 2 * c13 * y2 * y2 - c23 * y2 * y3) * r2;
    out->b = (2 * c12 * x3 * x3 + 2 * c13 * x2 * x2 - c23 * x2 * x3) * r2;
    return 1;
}

/* Reconstructed: Lee and Jen's share terms, each quotient divided, c and e by substitution. */
static inline int real_solve_seiler(const struct real_case *p, const struct real_samples *s, struct real_quadratic *out)
{
    const real n0 = s->i1, n1 = s->i2, n2 = s->i3, n3 = s->i23, n4 = s->i13, n5 = s->i12;
    const real w1 = p->x1 * p->y2, w2 = p->x2 * p->y1, w3 = w1 - w2;
    const real t = n0 + n1 - 2 * n5, u = n0 + n2 - 2 * n4, v = n0 + n3 - n4 - n5;
    const real g = 2 * n5 - 2 * n0 - t, h = 2 * n4 - 2 * n0 - u;
    if (p->y1 == 0)
        return 0;
    out->a = 2 * (t * p->y2 * p->y2 + u * p->y1 * p->y1 - 2 * v * p->y1 * p->y2) / (w3 * w3);
    out->c = 4 * (v * (w1 + w2) - u * p->x1 * p->y1 - t * p->x2 * p->y2) / (w3 * w3);
    out->b = (2 * t - out->a * p->x1 * p->x1 - out->c * p->x1 * p->y1) / (p->y1 * p->y1);
    out->d = (g * p->y2 - h * p->y1) / w3;
    out->e = (g - out->d * p->x1) / p->y1;
    out->f = n0;
    return 1;
}

/* X eq. 18-22. */
static inline void real_to_screen(const struct real_case *p, real a, real b, real c, real d, real e,
                                  struct real_quadratic *out)
{
    const real w = 1 / (p->x1 * p->y2 - p->x2 * p->y1);
    const real au = p->y2 * w, bu = -p->x2 * w, av = -p->y1 * w, bv = p->x1 * w;
    out->a = a * au * au + b * av * av + c * au * av;
    out->b = a * bu * bu + b * bv * bv + c * bu * bv;
    out->c = 2 * a * au * bu + 2 * b * av * bv + c * (au * bv + av * bu);
    out->d = d * au + e * av;
    out->e = d * bu + e * bv;
}

/* X eq. 16. */
static inline int real_solve_hast(const struct real_case *p, const struct real_samples *s, struct real_quadratic *out)
{
    const real a = 2 * (s->i1 + s->i2 - 2 * s->i12), b = 2 * (s->i1 + s->i3 - 2 * s->i13);
    const real c = 4 * (s->i1 + s->i23 - s->i13 - s->i12);
    out->f = s->i1;
    real_to_screen(p, a, b, c, s->i2 - s->i1 - a, s->i3 - s->i1 - b, out);
    return 1;
}

/* X eq. 32, from the bulges. */
static inline int real_solve_x(const struct real_case *p, const struct real_samples *s, struct real_quadratic *out)
{
    const real a = s->i12, b = s->i13, c = a + b - s->i23;
    out->f = s->i1;
    real_to_screen(p, a, b, c, s->i2 - s->i1 - a, s->i3 - s->i1 - b, out);
    return 1;
}

/* The same a .. e, which are 2T, 2U, 4V, G and H, over Lee and Jen's denominators. */
static inline int real_solve_x_products(const struct real_case *p, const struct real_samples *s,
                                        struct real_quadratic *out)
{
    const real a = s->i12, b = s->i13, c = a + b - s->i23, d = s->i2 - s->i1 - a, e = s->i3 - s->i1 - b;
    const real w1 = p->x1 * p->y2, w2 = p->x2 * p->y1, r = 1 / (w1 - w2), r2 = r * r;
    out->a = (a * p->y2 * p->y2 + b * p->y1 * p->y1 - c * p->y1 * p->y2) * r2;
    out->b = (a * p->x2 * p->x2 + b * p->x1 * p->x1 - c * p->x1 * p->x2) * r2;
    out->c = (c * (w1 + w2) - 2 * (b * p->x1 * p->y1 + a * p->x2 * p->y2)) * r2;
    out->d = (d * p->y2 - e * p->y1) * r;
    out->e = (e * p->x1 - d * p->x2) * r;
    out->f = s->i1;
    return 1;
}

struct setup_real {
    const char *name;
    void (*sample)(const struct real_case *c, struct real_samples *s);
    int (*solve)(const struct real_case *c, const struct real_samples *s, struct real_quadratic *out);
    int (*setup)(const struct real_case *c, struct real_quadratic *out);
};

#define REAL(name, sample, solve)                                                 \
    static int real_##name(const struct real_case *c, struct real_quadratic *out) \
    {                                                                             \
        struct real_samples samples;                                              \
        sample(c, &samples);                                                      \
        return solve(c, &samples, out);                                           \
    }
REAL(lee_jen, real_sample_middle, real_solve_lee_jen)
REAL(abbas, real_sample_middle, real_solve_abbas)
REAL(abbas_safe, real_sample_middle, real_solve_abbas_safe)
REAL(seiler, real_sample_middle, real_solve_seiler)
REAL(hast, real_sample_middle, real_solve_hast)
REAL(x, real_sample_x, real_solve_x)
REAL(x_k, real_sample_x_k, real_solve_x)
REAL(x_products, real_sample_x_k, real_solve_x_products)

static const struct setup_real real_setups[] = {
    {"lee-jen", real_sample_middle, real_solve_lee_jen, real_lee_jen},
    {"abbas", real_sample_middle, real_solve_abbas, real_abbas},
    {"abbas-safe", real_sample_middle, real_solve_abbas_safe, real_abbas_safe},
    {"seiler", real_sample_middle, real_solve_seiler, real_seiler},
    {"hast", real_sample_middle, real_solve_hast, real_hast},
    {"x", real_sample_x, real_solve_x, real_x},
    {"x-k", real_sample_x_k, real_solve_x, real_x_k},
    {"x-products", real_sample_x_k, real_solve_x_products, real_x_products},
};
#define REAL_SETUPS (sizeof real_setups / sizeof real_setups[0])

#endif
