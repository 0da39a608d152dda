/* SPDX-License-Identifier: MIT */
#include "report/plot.h"

#include "glint/cli.h"
#include "report/gnuplot.h"
#include "scene/model.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

/* The picture and its plotting area in pixels, y down. */
enum { PLOT_WIDTH = 430, PLOT_HEIGHT = 400, PLOT_LEFT = 52, PLOT_RIGHT = 422, PLOT_TOP = 10, PLOT_BOTTOM = 346 };

#define PLOT_CHARACTER 7.1 /* pixels: a generous mean of sans-serif at 13 */
#define PLOT_LINE      14.
#define PLOT_POINT     5. /* half a point's box */
#define PLOT_RINGS     12
#define PLOT_SIDES     16

struct plot_box {
    double left, top, right, bottom;
};

/* Where a method's point is and where its name is written. */
struct plot_mark {
    double x, y;
    struct plot_box label;
    bool far; /* a line joins the two */
};

/* What a name should not cover: points, names and the steps between the points of the Pareto set. */
struct plot_obstacles {
    struct plot_box *box;
    unsigned count;
};

struct plot_axes {
    double low, high, bottom, top; /* million instructions; dB, or the largest difference */
};

/* Filled and joined; beaten by another; auto within a budget, joined too. */
enum plot_group { PLOT_FRONT, PLOT_BEATEN, PLOT_BUDGET };

struct plot_point {
    char name[32];
    double right, up; /* million instructions; dB, or the largest difference */
    enum plot_group group;
};

/* Cheapest first. */
struct plot {
    struct plot_point *points;
    unsigned count;
    enum plot_sort sort;
    struct plot_axes axes;
};

double plot_decibel(const struct compare_result *error)
{
    return isinf(error->psnr_db) ? 99 : error->psnr_db;
}

static void plot_find_axes(struct plot *plot)
{
    struct plot_axes axes = {INFINITY, 0, INFINITY, -INFINITY};
    for (unsigned i = 0; i < plot->count; i++) {
        const struct plot_point *point = &plot->points[i];
        axes.low = fmin(axes.low, point->right);
        axes.high = fmax(axes.high, point->right);
        axes.bottom = fmin(axes.bottom, point->up);
        axes.top = fmax(axes.top, point->up);
    }
    axes.low /= 1.3;
    axes.high *= 1.9; /* room for names */
    axes.bottom = plot->sort == PLOT_PSNR ? 5 * floor((axes.bottom - 1) / 5) : axes.bottom / 1.5;
    axes.top = plot->sort == PLOT_PSNR ? 5 * ceil((axes.top + 4) / 5) : axes.top * 1.5;
    plot->axes = axes;
}

/* Where on its axis, 0..1. */
static double plot_across(const struct plot *plot, double millions)
{
    return log(millions / plot->axes.low) / log(plot->axes.high / plot->axes.low);
}
static double plot_upwards(const struct plot *plot, double value)
{
    const struct plot_axes *axes = &plot->axes;
    if (plot->sort == PLOT_PSNR)
        return (value - axes->bottom) / (axes->top - axes->bottom);
    return log(value / axes->bottom) / log(axes->top / axes->bottom);
}

static double plot_overlap(const struct plot_box *a, const struct plot_box *b)
{
    double width = fmin(a->right, b->right) - fmax(a->left, b->left);
    double height = fmin(a->bottom, b->bottom) - fmax(a->top, b->top);
    return width > 0 && height > 0 ? width * height : 0;
}

/* A box that holds two corners and `margin` around them. */
static void plot_obstruct(struct plot_obstacles *obstacles, double x1, double y1, double x2, double y2, double margin)
{
    obstacles->box[obstacles->count++] =
        (struct plot_box){fmin(x1, x2) - margin, fmin(y1, y2) - margin, fmax(x1, x2) + margin, fmax(y1, y2) + margin};
}

/* How badly a name would stand in `box`. */
static double plot_cost(const struct plot_box *box, const struct plot_obstacles *obstacles)
{
    const struct plot_box all = {PLOT_LEFT + 2, PLOT_TOP + 2, PLOT_RIGHT - 2, PLOT_BOTTOM - 2};
    double size = (box->right - box->left) * (box->bottom - box->top), cost = 9 * (size - plot_overlap(box, &all));
    for (unsigned i = 0; i < obstacles->count; i++)
        cost += plot_overlap(box, &obstacles->box[i]);
    return cost;
}

/* Beside the point, then in rings further out: the first place that is free, or else the best. */
static void plot_place(struct plot_mark *mark, double width, bool right, const struct plot_obstacles *obstacles)
{
    double least = INFINITY;
    for (int ring = 0; ring < PLOT_RINGS && least > 0; ring++)
        for (int side = 0; side < PLOT_SIDES && least > 0; side++) { /* left or right, up, down and all between */
            double angle = acos(-1) * (!right + (side & 1) + (side & 2) / 4. + (side >> 2) * 2. / PLOT_SIDES);
            double x = mark->x + cos(angle) * (width / 2 + PLOT_POINT + 2 + 10 * ring);
            double y = mark->y + sin(angle) * (PLOT_LINE / 2 + PLOT_POINT + 8 * ring);
            struct plot_box box = {x - width / 2, y - PLOT_LINE / 2, x + width / 2, y + PLOT_LINE / 2};
            double cost = plot_cost(&box, obstacles);
            if (cost >= least)
                continue;
            least = cost;
            mark->label = box;
            mark->far = ring > 0;
        }
}

static void plot_layout(const struct plot *plot, struct plot_mark *marks)
{
    struct plot_obstacles obstacles = {model_alloc(4 * plot->count * sizeof(struct plot_box)), 0};
    const struct plot_mark *before = NULL;
    for (unsigned i = 0; i < plot->count; i++) {
        const struct plot_point *point = &plot->points[i];
        struct plot_mark *mark = &marks[i];
        mark->x = PLOT_LEFT + plot_across(plot, point->right) * (PLOT_RIGHT - PLOT_LEFT);
        mark->y = PLOT_BOTTOM - plot_upwards(plot, point->up) * (PLOT_BOTTOM - PLOT_TOP);
        plot_obstruct(&obstacles, mark->x, mark->y, mark->x, mark->y, PLOT_POINT);
        if (point->group != PLOT_FRONT)
            continue;
        if (before) {
            plot_obstruct(&obstacles, before->x, before->y, mark->x, before->y, 1);
            plot_obstruct(&obstacles, mark->x, before->y, mark->x, mark->y, 1);
        }
        before = mark;
    }
    static const enum plot_group turns[] = {PLOT_BUDGET, PLOT_FRONT, PLOT_BEATEN};
    for (unsigned i = 0; i < 3 * plot->count; i++) {
        const struct plot_point *point = &plot->points[i % plot->count];
        struct plot_mark *mark = &marks[i % plot->count];
        if (point->group != turns[i / plot->count])
            continue;
        plot_place(mark, PLOT_CHARACTER * (double)strlen(point->name), point->group != PLOT_FRONT, &obstacles);
        obstacles.box[obstacles.count++] = mark->label;
    }
    free(obstacles.box);
}

static void plot_labels(FILE *script, const struct plot *plot, const struct plot_mark *marks)
{
    static const char *const colours[] = {
        [PLOT_FRONT] = "", [PLOT_BEATEN] = " tc rgb \"#808080\"", [PLOT_BUDGET] = " tc rgb \"#3f8fd0\""};
    for (unsigned i = 0; i < plot->count; i++) {
        const struct plot_mark *mark = &marks[i];
        double x = (mark->label.left + mark->label.right) / 2, y = (mark->label.top + mark->label.bottom) / 2;
        fprintf(script, "set label \"%s\" at screen %.4f,%.4f center%s\n", plot->points[i].name, x / PLOT_WIDTH,
                1 - y / PLOT_HEIGHT, colours[plot->points[i].group]);
        if (mark->far) /* to the label's nearest edge */
            fprintf(script, "set arrow from screen %.4f,%.4f to screen %.4f,%.4f nohead lw .5 lc rgb \"#808080\"\n",
                    mark->x / PLOT_WIDTH, 1 - mark->y / PLOT_HEIGHT,
                    fmax(mark->label.left, fmin(mark->label.right, mark->x)) / PLOT_WIDTH,
                    1 - fmax(mark->label.top, fmin(mark->label.bottom, mark->y)) / PLOT_HEIGHT);
    }
}

/* A data block of the points of a group. Returns how many. */
static unsigned plot_data(FILE *script, const struct plot *plot, const char *name, enum plot_group group)
{
    unsigned count = 0;
    fprintf(script, "$%s << END\n", name);
    for (unsigned i = 0; i < plot->count; i++)
        if (plot->points[i].group == group) {
            fprintf(script, "%.6f %.4f\n", plot->points[i].right, plot->points[i].up);
            count++;
        }
    fprintf(script, "END\n");
    return count;
}

/* The ticks of a logarithmic axis: round numbers, not too close. */
static void plot_ticks(FILE *script, const struct plot *plot)
{
    static const double steps[6] = {1, 1.5, 2, 3, 5, 7};
    const char *comma = "";
    fprintf(script, "set xtics (");
    for (int power = -6; power < 6; power++)
        for (int i = 0; i < 6; i++) {
            double tick = steps[i] * pow(10, power);
            if (tick < plot->axes.low || tick > plot->axes.high)
                continue;
            fprintf(script, "%s\"%g\" %g", comma, tick, tick);
            comma = ", ";
        }
    fprintf(script, ")\n");
    if (plot->sort == PLOT_PSNR) {
        fprintf(script, "set ytics 5\n");
        return;
    }
    fprintf(script, "set logscale y\nset ytics (\".25\" .25, \".5\" .5");
    for (int tick = 1; tick < 256; tick *= 2)
        fprintf(script, ", \"%d\" %d", tick, tick);
    fprintf(script, ")\n");
}

static void plot_script(FILE *script, const struct plot *plot, enum costs_cpu cpu)
{
    static const char *const titles[] = {[PLOT_PSNR] = "PSNR, dB", [PLOT_LARGEST] = "largest difference, 1/255"};
    struct plot_mark *marks = model_alloc(plot->count * sizeof *marks);
    plot_layout(plot, marks);
    fprintf(script,
            "set terminal svg size %d,%d dynamic font \"sans-serif,13\" noenhanced\n"
            "set logscale x\nset key off\nset grid lc rgb \"#808080\" lw .5\n"
            "set xrange [%g:%g]\nset yrange [%g:%g]\n"
            "set lmargin at screen %g\nset rmargin at screen %g\nset tmargin at screen %g\nset bmargin at screen %g\n"
            "set xlabel \"million instructions a frame on %s\" offset 0,.4\nset ylabel \"%s\" offset 1.5,0\n",
            PLOT_WIDTH, PLOT_HEIGHT, plot->axes.low, plot->axes.high, plot->axes.bottom, plot->axes.top,
            (double)PLOT_LEFT / PLOT_WIDTH, (double)PLOT_RIGHT / PLOT_WIDTH, 1 - (double)PLOT_TOP / PLOT_HEIGHT,
            1 - (double)PLOT_BOTTOM / PLOT_HEIGHT, costs_cpu_titles[cpu], titles[plot->sort]);
    plot_ticks(script, plot);
    plot_labels(script, plot, marks);
    plot_data(script, plot, "front", PLOT_FRONT);
    bool beaten = plot_data(script, plot, "beaten", PLOT_BEATEN) > 0;
    bool budgets = plot_data(script, plot, "budget", PLOT_BUDGET) > 0;
    fprintf(script,
            "plot $front with steps lw 1.5 lc rgb \"#d9622b\", $front with points pt 7 ps .6 lc rgb \"#d9622b\"%s%s\n",
            beaten ? ", $beaten with points pt 6 ps .6 lc rgb \"#808080\"" : "",
            budgets ? ", $budget with linespoints pt 7 ps .6 lw 2 lc rgb \"#3f8fd0\"" : "");
    free(marks);
}

static int plot_order(const void *a, const void *b)
{
    const struct plot_point *x = a, *y = b;
    return x->right != y->right ? (x->right < y->right ? -1 : 1) : strcmp(x->name, y->name);
}

static double plot_value(enum plot_sort sort, const struct compare_result *error)
{
    return sort == PLOT_PSNR ? plot_decibel(error) : fmax(error->max, .1);
}

/* Of the methods, whom none beats that costs no more. */
static void plot_rank(struct plot *plot)
{
    const double sign = plot->sort == PLOT_PSNR ? 1 : -1;
    for (unsigned i = 0; i < plot->count; i++)
        for (unsigned j = 0; j < plot->count; j++) {
            struct plot_point *own = &plot->points[i];
            const struct plot_point *other = &plot->points[j];
            double better = sign * (other->up - own->up);
            if (own->group != PLOT_BUDGET && other->group != PLOT_BUDGET && other->right <= own->right && better >= 0 &&
                (other->right < own->right || better > 0))
                own->group = PLOT_BEATEN;
        }
}

static void plot_make(struct plot *plot, const struct survey *survey, enum costs_cpu cpu)
{
    plot->points = model_alloc((survey->count + survey->budget_count) * sizeof *plot->points);
    for (unsigned i = 0; i < survey->count; i++) {
        const struct survey_row *row = &survey->rows[i];
        struct plot_point *point = &plot->points[plot->count++];
        *point = (struct plot_point){"", row->instructions[cpu] / 1e6, plot_value(plot->sort, &row->error), PLOT_FRONT};
        snprintf(point->name, sizeof point->name, "%s", row->method);
    }
    for (unsigned i = 0; i < survey->budget_count; i++) {
        const struct survey_budget *budget = &survey->budgets[i];
        struct plot_point *point = &plot->points[plot->count++];
        *point = (struct plot_point){"", budget->instructions[cpu] / 1e6, plot_value(plot->sort, &budget->error),
                                     PLOT_BUDGET};
        snprintf(point->name, sizeof point->name, "%g", budget->budget_q8 / 256.);
    }
    plot_rank(plot);
    qsort(plot->points, plot->count, sizeof *plot->points, plot_order);
    plot_find_axes(plot);
}

int plot_write(FILE *out, const struct survey *survey, enum costs_cpu cpu, enum plot_sort sort)
{
    char prefix[96];
    struct plot plot = {.sort = sort};
    FILE *script = tmpfile();
    if (!script) {
        perror("gnuplot's script");
        return CLI_IO;
    }
    plot_make(&plot, survey, cpu);
    snprintf(prefix, sizeof prefix, "%s-%s-%u-", survey->scene, costs_cpu_names[cpu], (unsigned)sort);
    plot_script(script, &plot, cpu);
    int code = gnuplot_run(script, out, prefix);
    free(plot.points);
    fclose(script);
    return code;
}
