/* SPDX-License-Identifier: MIT */
#include "report/angle.h"

#include "glint/cli.h"
#include "reference/curve.h"
#include "reference/worse.h"
#include "report/gnuplot.h"

#include <math.h>

#define ANGLE_END       120 /* degrees */
#define ANGLE_TRIANGLES 100000u

/* One of the two: what is drawn of a point of the curve, for X, the six samples and the line. */
struct angle_plot {
    const char *prefix, *axes;
    void (*values)(const struct curve_point *point, double out[3]);
};

static void angle_norms(const struct curve_point *point, double out[3])
{
    out[0] = point->norm;
    out[1] = 1;
    out[2] = point->linear_norm;
}

static void angle_errors(const struct curve_point *point, double out[3])
{
    out[0] = 255 * point->error;
    out[1] = 255 * point->six_error;
    out[2] = 255 * point->linear_error;
}

static const struct angle_plot angle_plots[] = {
    {"angle-norm-",
     "set ylabel \"norm of the middle vector\" offset 1.5,0\nset yrange [.5:1.02]\nset key bottom left\n", angle_norms},
    {"angle-error-",
     "set ylabel \"largest error of N.L, 1/255\" offset 1.5,0\nset logscale y\nset yrange [.01:200]\n"
     "set ytics (\"0.01\" .01, \"0.1\" .1, \"1\" 1, \"10\" 10, \"100\" 100)\nset key bottom right\n",
     angle_errors},
};

static int angle_draw(FILE *out, const struct angle_plot *plot)
{
    FILE *script = tmpfile();
    if (!script) {
        perror("gnuplot's script");
        return CLI_IO;
    }
    fprintf(script, "$curve << END\n");
    for (int degrees = 1; degrees <= ANGLE_END; degrees++) {
        struct curve_point point = curve_x(degrees);
        double value[3];
        plot->values(&point, value);
        fprintf(script, "%d %.6f %.6f %.6f\n", degrees, value[0], value[1], value[2]);
    }
    fprintf(script,
            "END\nset terminal svg size 430,360 dynamic font \"sans-serif,13\" noenhanced\n"
            "set grid lc rgb \"#808080\" lw .5\nset xrange [0:%d]\nset xtics 20\n"
            "set xlabel \"degrees between the normals of an edge\" offset 0,.4\n%s"
            "plot $curve using 1:4 with lines lw 1.5 lc rgb \"#808080\" title \"Gouraud's line\","
            " $curve using 1:2 with lines lw 2 lc rgb \"#d9622b\" title \"X\","
            " $curve using 1:3 with lines lw 1.5 lc rgb \"#3f8fd0\" title \"through the true middle\"\n",
            ANGLE_END, plot->axes);
    int code = gnuplot_run(script, out, plot->prefix);
    fclose(script);
    return code;
}

static void angle_worse(FILE *out)
{
    static const double cones[] = {10, 30, 50, 80};
    fprintf(out,
            "<p>That it is \u201calways better than a linear approximation\u201d, as its paper says, holds in the "
            "middle of an edge, and nearly so over "
            "a triangle. Of %u random triangles under a random light, these have an N\u00b7L by X whose RMS difference "
            "from Phong\u2019s is larger than the line\u2019s; on the right as it is seen, clamped to 0..1.</p>\n"
            "<div class=\"wide\"><table>\n<tr><th>normals lean up to</th><th>worse</th><th>at most</th>"
            "<th>clamped, worse</th><th>at most</th><th>normals at least apart</th></tr>\n",
            ANGLE_TRIANGLES);
    for (unsigned i = 0; i < sizeof cones / sizeof *cones; i++) {
        struct worse_count count = worse_count(cones[i], ANGLE_TRIANGLES);
        fprintf(out, "<tr><td>%.0f\u00b0</td><td>%.3f %%</td><td>%.3f times</td><td>%.3f %%</td>", cones[i],
                100. * count.worse / ANGLE_TRIANGLES, count.ratio, 100. * count.clamped_worse / ANGLE_TRIANGLES);
        if (count.clamped_worse)
            fprintf(out, "<td>%.3f times</td><td>%.0f\u00b0</td></tr>\n", count.clamped_ratio,
                    floor(count.clamped_degrees));
        else
            fprintf(out, "<td></td><td></td></tr>\n");
    }
    fprintf(out, "</table></div>\n");
}

int angle_write(FILE *out)
{
    struct curve_point small = curve_x(15), large = curve_x(60);
    int code = CLI_DONE;
    fprintf(
        out,
        "<h2 id=\"angle\">X-shading\u2019s error</h2>\n"
        "<p>X needs no normal but those of the corners, and pays for it where they differ much: its middle vector is "
        "too short (left), and N\u00b7L errs, under the worst light and at the worst place of an edge, by what is "
        "shown on the right. At 15\u00b0 between the normals that is %.2f of 255, at 60\u00b0 %.1f; Gouraud\u2019s "
        "line errs by %.1f and %.0f.</p>\n<div class=\"plots\">",
        255 * small.error, 255 * large.error, 255 * small.linear_error, 255 * large.linear_error);
    for (unsigned i = 0; !code && i < sizeof angle_plots / sizeof *angle_plots; i++) {
        fprintf(out, "<figure>");
        code = angle_draw(out, &angle_plots[i]);
        fprintf(out, "</figure>\n");
    }
    fprintf(out, "</div>\n");
    if (!code)
        angle_worse(out);
    return code;
}
