/* SPDX-License-Identifier: MIT */
#include "report/streams.h"

#include "glint/cli.h"
#include "report/gnuplot.h"
#include "report/traffic.h"
#include "scene/model.h"

#include <math.h>
#include <stdlib.h>

#define STREAMS_USB    1e6   /* bytes a second: bulk over full speed */
#define STREAMS_SERIAL 11520 /* 115,200 baud, ten bits a byte */
#define STREAMS_RATE   (1000 / TRAFFIC_STEP_MS)
#define STREAMS_FITS   (STREAMS_USB / STREAMS_RATE)

/* Places in traffic_kinds[] of what the text speaks of. */
enum { STREAMS_PLAIN, STREAMS_DITHERED, STREAMS_OLED = TRAFFIC_KINDS - 1, STREAMS_PLOTS = 2 };

struct streams {
    struct traffic *scenes;
    unsigned count;
};

static double streams_sum(const struct streams *s, unsigned kind, enum traffic_way way)
{
    double sum = 0;
    for (unsigned i = 0; i < s->count; i++)
        sum += s->scenes[i].mean[kind][way];
    return sum;
}

/* Over the same of another kind or way, in percent. */
static double streams_percent(const struct streams *s, unsigned kind, enum traffic_way way, unsigned of_kind,
                              enum traffic_way of_way)
{
    return 100 * streams_sum(s, kind, way) / streams_sum(s, of_kind, of_way);
}

/* Scenes whose pictures go over full speed at STREAMS_RATE. */
static unsigned streams_fit(const struct streams *s, unsigned kind)
{
    unsigned fit = 0;
    for (unsigned i = 0; i < s->count; i++)
        fit += s->scenes[i].mean[kind][TRAFFIC_CHANGE] <= STREAMS_FITS;
    return fit;
}

static void streams_text(FILE *out, const struct streams *s)
{
    const struct traffic_kind *plain = &traffic_kinds[STREAMS_PLAIN], *oled = &traffic_kinds[STREAMS_OLED];
    double change[TRAFFIC_KINDS], alone[TRAFFIC_KINDS];
    for (unsigned kind = 0; kind < TRAFFIC_KINDS; kind++) {
        change[kind] = streams_sum(s, kind, TRAFFIC_CHANGE) / s->count;
        alone[kind] = streams_sum(s, kind, TRAFFIC_ALONE) / s->count;
    }
    fprintf(
        out,
        "<h2 id=\"stream\">As a stream</h2>\n"
        "<p>Bytes of a picture sent as firmware/stream/PROTOCOL.md has it, headers included, in four bands, "
        "drawn by x: the mean of %d pictures over a loop, each %d ms after the one before it; a scene that stands "
        "still is given a turn in 4 s. <b>Raw</b> is codec 0. <b>Changed rows</b> are those that a panel is sent, "
        "raw. <b>Alone</b> is a key frame, codec 1. <b>As sent</b> is against the last picture, codec 2; either "
        "takes a band raw that would be no shorter. The last four columns are pictures a second over %.0f MB/s, what "
        "full-speed USB carries in bulk, and over 115,200 baud; the dashed line is %d of them over USB.</p>\n",
        TRAFFIC_MOMENTS, TRAFFIC_STEP_MS, STREAMS_USB / 1e6, STREAMS_RATE);
    fprintf(out,
            "<p><b>What to choose.</b> Against the last picture wherever one more has room, %u bytes of %s at "
            "%u\u00d7%u: it takes %.0f %% of what pictures take alone, %.0f %% dithered, and %.0f %% of the changed "
            "rows. Full speed has %.0f bytes for each of %d pictures a second: %u of %u scenes keep to them, %u "
            "dithered. Alone where memory has no such room, and where every picture is asked for: over 115,200 "
            "baud %u\u00d7%u takes %.1f s, %.1f dithered, but %u\u00d7%u in 16 greys comes %.0f times a second, "
            "against the last one %.0f times. Dithering adds %.0f %% to what is sent: leave it off where the line is "
            "the limit. Raw is the way out for a band of noise. To try both codecs on each band and take the shorter "
            "would save %.2f %%, and is not done.</p>\n",
            2u * plain->width * plain->height, plain->name, plain->width, plain->height,
            streams_percent(s, STREAMS_PLAIN, TRAFFIC_CHANGE, STREAMS_PLAIN, TRAFFIC_ALONE),
            streams_percent(s, STREAMS_DITHERED, TRAFFIC_CHANGE, STREAMS_DITHERED, TRAFFIC_ALONE),
            streams_percent(s, STREAMS_PLAIN, TRAFFIC_CHANGE, STREAMS_PLAIN, TRAFFIC_ROWS), STREAMS_FITS, STREAMS_RATE,
            streams_fit(s, STREAMS_PLAIN), s->count, streams_fit(s, STREAMS_DITHERED), plain->width, plain->height,
            alone[STREAMS_PLAIN] / STREAMS_SERIAL, alone[STREAMS_DITHERED] / STREAMS_SERIAL, oled->width, oled->height,
            STREAMS_SERIAL / alone[STREAMS_OLED], STREAMS_SERIAL / change[STREAMS_OLED],
            streams_percent(s, STREAMS_DITHERED, TRAFFIC_CHANGE, STREAMS_PLAIN, TRAFFIC_CHANGE) - 100,
            100 - streams_percent(s, STREAMS_PLAIN, TRAFFIC_LEAST, STREAMS_PLAIN, TRAFFIC_CHANGE));
}

/* A scene a line: its changed rows, its picture alone and as sent, up to the longest. */
static int streams_plot(FILE *out, const struct streams *s, unsigned kind)
{
    const struct traffic_kind *k = &traffic_kinds[kind];
    const unsigned height = 130 + 17 * s->count;
    char prefix[32];
    FILE *script = tmpfile();
    if (!script) {
        perror("gnuplot's script");
        return CLI_IO;
    }
    fprintf(script, "$bytes << END\n");
    for (unsigned i = 0; i < s->count; i++)
        fprintf(script, "%u %s %u %u %u %u\n", i, s->scenes[i].scene, (unsigned)s->scenes[i].mean[kind][TRAFFIC_ROWS],
                (unsigned)s->scenes[i].mean[kind][TRAFFIC_ALONE], (unsigned)s->scenes[i].mean[kind][TRAFFIC_CHANGE],
                (unsigned)s->scenes[i].most[kind][TRAFFIC_CHANGE]);
    fprintf(script,
            "END\nset terminal svg size 430,%u dynamic font \"sans-serif,13\" noenhanced\n"
            "set logscale x\nset xrange [500:140000]\nset yrange [%u.6:-0.6]\n"
            "set xtics (\"1k\" 1000, \"2k\" 2000, \"5k\" 5000, \"10k\" 10000, \"20k\" 20000, \"50k\" 50000, "
            "\"100k\" 100000)\nset grid xtics ytics lc rgb \"#808080\" lw .5\n"
            "set lmargin at screen .3\nset rmargin at screen .97\nset bmargin at screen %g\n"
            "set key at screen .97,%g bottom right\n"
            "set xlabel \"bytes a picture, %s %ux%u\" offset 0,.4\n"
            "set arrow from %g,%u.6 to %g,-0.6 nohead lw 1.5 dt 2 lc rgb \"#3f8fd0\"\n"
            "plot $bytes using 3:1:ytic(2) with points pt 6 ps .6 lc rgb \"#808080\" title \"changed rows, raw\", "
            "$bytes using 4:1 with points pt 6 ps .6 lw 1.5 lc rgb \"#3f8fd0\" title \"alone\", "
            "$bytes using 5:1:($6-$5):(0) with vectors nohead lw 1.5 lc rgb \"#d9622b\" notitle, "
            "$bytes using 5:1 with points pt 7 ps .6 lc rgb \"#d9622b\" title \"as sent, and to the longest\"\n",
            height, s->count - 1, 110. / height, 4. / height, k->name, k->width, k->height, STREAMS_FITS, s->count - 1,
            STREAMS_FITS);
    snprintf(prefix, sizeof prefix, "stream-%u-", kind);
    fprintf(out, "<figure>");
    int code = gnuplot_run(script, out, prefix);
    fprintf(out, "</figure>\n");
    fclose(script);
    return code;
}

static void streams_kind(FILE *out, const struct streams *s, unsigned kind)
{
    const struct traffic_kind *k = &traffic_kinds[kind];
    fprintf(out,
            "<div class=\"wide\"><table>\n<tr><th>%s %u\u00d7%u, raw %u</th><th>changed rows</th><th>alone</th>"
            "<th>as sent</th><th>at most</th><th>USB alone</th><th>as sent</th><th>serial alone</th><th>as sent</th>"
            "</tr>\n",
            k->name, k->width, k->height, (unsigned)s->scenes[0].mean[kind][TRAFFIC_RAW]);
    for (unsigned i = 0; i < s->count; i++) {
        const uint32_t *mean = s->scenes[i].mean[kind];
        double alone = mean[TRAFFIC_ALONE], change = mean[TRAFFIC_CHANGE];
        fprintf(out, "<tr><td>%s</td><td>%u</td><td>%u</td><td>%u</td><td>%u</td>", s->scenes[i].scene,
                (unsigned)mean[TRAFFIC_ROWS], (unsigned)mean[TRAFFIC_ALONE], (unsigned)mean[TRAFFIC_CHANGE],
                (unsigned)s->scenes[i].most[kind][TRAFFIC_CHANGE]);
        fprintf(out, "<td>%.0f</td><td>%.0f</td><td>%.1f</td><td>%.1f</td></tr>\n", STREAMS_USB / alone,
                STREAMS_USB / change, STREAMS_SERIAL / alone, STREAMS_SERIAL / change);
    }
    fprintf(out, "</table></div>\n");
}

/* Instructions to pack a picture and check it, a row for each line of the file that is the first of its kind. */
static void streams_costs(FILE *out, const struct costs *costs)
{
    fprintf(out,
            "<p>What packing costs on a device, the check sums and the copy for the next picture included, counted by "
            "QEMU: instructions a pixel, and in millions a picture.</p>\n"
            "<div class=\"wide\"><table>\n<tr><th>scene, format</th><th>codec</th><th>bytes</th>");
    for (unsigned cpu = 0; cpu < COSTS_STREAM_CPUS; cpu++)
        fprintf(out, "<th>%s, a pixel</th>", costs_stream_cpu_titles[cpu]);
    for (unsigned cpu = 0; cpu < COSTS_STREAM_CPUS; cpu++)
        fprintf(out, "<th>%s, M</th>", costs_stream_cpu_titles[cpu]);
    fprintf(out, "</tr>\n");
    for (size_t i = 0; i < costs->stream_count; i++) {
        const struct costs_stream *c = &costs->streams[i], *of[COSTS_STREAM_CPUS];
        bool first = true;
        for (unsigned cpu = 0; cpu < COSTS_STREAM_CPUS; cpu++) {
            of[cpu] = costs_find_stream(costs, cpu, c->scene, c->format, c->codec);
            first = first && (!of[cpu] || of[cpu] >= c);
        }
        if (!first)
            continue;
        fprintf(out, "<tr><td>%s, %s</td><td>%u</td><td>%u</td>", c->scene, c->format, c->codec, (unsigned)c->bytes);
        for (unsigned cpu = 0; cpu < COSTS_STREAM_CPUS; cpu++)
            if (of[cpu])
                fprintf(out, "<td>%.1f</td>", (double)of[cpu]->instructions / of[cpu]->pixels);
            else
                fprintf(out, "<td></td>");
        for (unsigned cpu = 0; cpu < COSTS_STREAM_CPUS; cpu++)
            if (of[cpu])
                fprintf(out, "<td>%.2f</td>", of[cpu]->instructions / 1e6);
            else
                fprintf(out, "<td></td>");
        fprintf(out, "</tr>\n");
    }
    fprintf(out, "</table></div>\n");
}

static void streams_csv(FILE *out, const struct streams *s)
{
    fprintf(out, "scene,format,width,height");
    for (unsigned way = 0; way < TRAFFIC_WAYS; way++)
        fprintf(out, ",%s,%s_most", traffic_ways[way], traffic_ways[way]);
    fprintf(out, "\n");
    for (unsigned i = 0; i < s->count; i++)
        for (unsigned kind = 0; kind < TRAFFIC_KINDS; kind++) {
            const struct traffic_kind *k = &traffic_kinds[kind];
            fprintf(out, "%s,%s,%u,%u", s->scenes[i].scene, k->name, k->width, k->height);
            for (unsigned way = 0; way < TRAFFIC_WAYS; way++)
                fprintf(out, ",%u,%u", (unsigned)s->scenes[i].mean[kind][way], (unsigned)s->scenes[i].most[kind][way]);
            fprintf(out, "\n");
        }
}

int streams_write(FILE *page, FILE *table, const char *const paths[], unsigned count, const struct costs *costs)
{
    struct streams s = {model_alloc(count * sizeof *s.scenes), count};
    int code = CLI_DONE;
    for (unsigned i = 0; !code && i < count; i++)
        code = traffic_measure(&s.scenes[i], paths[i]);
    if (!code) {
        streams_text(page, &s);
        fprintf(page, "<div class=\"plots\">");
        for (unsigned kind = 0; !code && kind < STREAMS_PLOTS; kind++)
            code = streams_plot(page, &s, kind);
        fprintf(page, "</div>\n");
    }
    for (unsigned kind = 0; !code && kind < TRAFFIC_KINDS; kind++)
        streams_kind(page, &s, kind);
    if (!code && costs->stream_count)
        streams_costs(page, costs);
    if (!code)
        streams_csv(table, &s);
    free(s.scenes);
    return code;
}
