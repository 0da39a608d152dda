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
    double low, high, bottom, top; /* million instructions, dB */
};

double plot_decibel(const struct compare_result *error)
{
    return isinf(error->psnr_db) ? 99 : error->psnr_db;
}

static double plot_millions(const struct survey_row *row, enum costs_cpu cpu)
{
    return row->instructions[cpu] / 1e6;
}

static struct plot_axes plot_axes(const struct survey *survey, enum costs_cpu cpu)
{
    struct plot_axes axes = {INFINITY, 0, INFINITY, -INFINITY};
    for (unsigned i = 0; i < survey->count; i++) {
        const struct survey_row *row = &survey->rows[i];
        axes.low = fmin(axes.low, plot_millions(row, cpu));
        axes.high = fmax(axes.high, plot_millions(row, cpu));
        axes.bottom = fmin(axes.bottom, plot_decibel(&row->error));
        axes.top = fmax(axes.top, plot_decibel(&row->error));
    }
    axes.low /= 1.3;
    axes.high *= 1.9; /* room for names */
    axes.bottom = 5 * floor((axes.bottom - 1) / 5);
    axes.top = 5 * ceil((axes.top + 4) / 5);
    return axes;
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

static void plot_layout(const struct survey *survey, enum costs_cpu cpu, const struct plot_axes *axes,
                        const unsigned order[], struct plot_mark *marks)
{
    struct plot_obstacles obstacles = {model_alloc(4 * survey->count * sizeof(struct plot_box)), 0};
    const struct plot_mark *before = NULL;
    for (unsigned i = 0; i < survey->count; i++) {
        const struct survey_row *row = &survey->rows[order[i]];
        struct plot_mark *mark = &marks[order[i]];
        double right = log(plot_millions(row, cpu) / axes->low) / log(axes->high / axes->low);
        double up = (plot_decibel(&row->error) - axes->bottom) / (axes->top - axes->bottom);
        mark->x = PLOT_LEFT + right * (PLOT_RIGHT - PLOT_LEFT);
        mark->y = PLOT_BOTTOM - up * (PLOT_BOTTOM - PLOT_TOP);
        plot_obstruct(&obstacles, mark->x, mark->y, mark->x, mark->y, PLOT_POINT);
        if (row->beaten_by[cpu])
            continue;
        if (before) {
            plot_obstruct(&obstacles, before->x, before->y, mark->x, before->y, 1);
            plot_obstruct(&obstacles, mark->x, before->y, mark->x, mark->y, 1);
        }
        before = mark;
    }
    for (unsigned i = 0; i < 2 * survey->count; i++) { /* the Pareto set first */
        const struct survey_row *row = &survey->rows[order[i % survey->count]];
        struct plot_mark *mark = &marks[order[i % survey->count]];
        if ((row->beaten_by[cpu] == NULL) != (i < survey->count))
            continue;
        plot_place(mark, PLOT_CHARACTER * (double)strlen(row->method), row->beaten_by[cpu] != NULL, &obstacles);
        obstacles.box[obstacles.count++] = mark->label;
    }
    free(obstacles.box);
}

static void plot_labels(FILE *script, const struct survey *survey, enum costs_cpu cpu, const struct plot_mark *marks)
{
    for (unsigned i = 0; i < survey->count; i++) {
        const struct plot_mark *mark = &marks[i];
        double x = (mark->label.left + mark->label.right) / 2, y = (mark->label.top + mark->label.bottom) / 2;
        fprintf(script, "set label \"%s\" at screen %.4f,%.4f center%s\n", survey->rows[i].method, x / PLOT_WIDTH,
                1 - y / PLOT_HEIGHT, survey->rows[i].beaten_by[cpu] ? " tc rgb \"#808080\"" : "");
        if (mark->far) /* to the label's nearest edge */
            fprintf(script, "set arrow from screen %.4f,%.4f to screen %.4f,%.4f nohead lw .5 lc rgb \"#808080\"\n",
                    mark->x / PLOT_WIDTH, 1 - mark->y / PLOT_HEIGHT,
                    fmax(mark->label.left, fmin(mark->label.right, mark->x)) / PLOT_WIDTH,
                    1 - fmax(mark->label.top, fmin(mark->label.bottom, mark->y)) / PLOT_HEIGHT);
    }
}

/* The rows by their cost on this cpu. */
static unsigned *plot_order(const struct survey *survey, enum costs_cpu cpu)
{
    unsigned *order = model_alloc(survey->count * sizeof *order);
    for (unsigned i = 0; i < survey->count; i++) {
        unsigned at = i;
        for (; at > 0 && survey->rows[order[at - 1]].instructions[cpu] > survey->rows[i].instructions[cpu]; at--)
            order[at] = order[at - 1];
        order[at] = i;
    }
    return order;
}

/* A data block of the points that are in the Pareto set, or of the others. Returns how many. */
static unsigned plot_data(FILE *script, const struct survey *survey, enum costs_cpu cpu, const unsigned order[],
                          bool front)
{
    unsigned count = 0;
    fprintf(script, "$%s << END\n", front ? "front" : "beaten");
    for (unsigned i = 0; i < survey->count; i++) {
        const struct survey_row *row = &survey->rows[order[i]];
        if ((row->beaten_by[cpu] == NULL) != front)
            continue;
        fprintf(script, "%.6f %.4f\n", plot_millions(row, cpu), plot_decibel(&row->error));
        count++;
    }
    fprintf(script, "END\n");
    return count;
}

/* The ticks of a logarithmic axis: round numbers, not too close. */
static void plot_ticks(FILE *script, const struct plot_axes *axes)
{
    static const double steps[6] = {1, 1.5, 2, 3, 5, 7};
    const char *comma = "";
    fprintf(script, "set xtics (");
    for (int power = -6; power < 6; power++)
        for (int i = 0; i < 6; i++) {
            double tick = steps[i] * pow(10, power);
            if (tick < axes->low || tick > axes->high)
                continue;
            fprintf(script, "%s\"%g\" %g", comma, tick, tick);
            comma = ", ";
        }
    fprintf(script, ")\n");
}

static void plot_script(FILE *script, const struct survey *survey, enum costs_cpu cpu)
{
    struct plot_axes axes = plot_axes(survey, cpu);
    struct plot_mark *marks = model_alloc(survey->count * sizeof *marks);
    unsigned *order = plot_order(survey, cpu);
    plot_layout(survey, cpu, &axes, order, marks);
    fprintf(script,
            "set terminal svg size %d,%d dynamic font \"sans-serif,13\" noenhanced\n"
            "set logscale x\nset key off\nset grid lc rgb \"#808080\" lw .5\n"
            "set xrange [%g:%g]\nset yrange [%g:%g]\nset ytics 5\n"
            "set lmargin at screen %g\nset rmargin at screen %g\nset tmargin at screen %g\nset bmargin at screen %g\n"
            "set xlabel \"million instructions a frame on %s\" offset 0,.4\nset ylabel \"PSNR, dB\" offset 1.5,0\n",
            PLOT_WIDTH, PLOT_HEIGHT, axes.low, axes.high, axes.bottom, axes.top, (double)PLOT_LEFT / PLOT_WIDTH,
            (double)PLOT_RIGHT / PLOT_WIDTH, 1 - (double)PLOT_TOP / PLOT_HEIGHT, 1 - (double)PLOT_BOTTOM / PLOT_HEIGHT,
            costs_cpu_titles[cpu]);
    plot_ticks(script, &axes);
    plot_labels(script, survey, cpu, marks);
    plot_data(script, survey, cpu, order, true);
    bool beaten = plot_data(script, survey, cpu, order, false) > 0;
    fprintf(script,
            "plot $front with steps lw 1.5 lc rgb \"#d9622b\", $front with points pt 7 ps .6 lc rgb \"#d9622b\"%s\n",
            beaten ? ", $beaten with points pt 6 ps .6 lc rgb \"#808080\"" : "");
    free(order);
    free(marks);
}

int plot_write(FILE *out, const struct survey *survey, enum costs_cpu cpu)
{
    char prefix[96];
    FILE *script = tmpfile();
    if (!script) {
        perror("gnuplot's script");
        return CLI_IO;
    }
    snprintf(prefix, sizeof prefix, "%s-%s-", survey->scene, costs_cpu_names[cpu]);
    plot_script(script, survey, cpu);
    int code = gnuplot_run(script, out, prefix);
    fclose(script);
    return code;
}
