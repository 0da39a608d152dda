/* SPDX-License-Identifier: MIT */
#include "report/page.h"

#include "glint/cli.h"
#include "report/picture.h"
#include "report/plot.h"
#include "report/sweep.h"

static const char page_style[] =
    ":root{color-scheme:light dark;--ink:#1b1b1b;--paper:#fff;--faint:#6b6b6b;--line:#d5d5d5;--best:#b84a16}\n"
    "@media(prefers-color-scheme:dark){:root{--ink:#e6e6e6;--paper:#161616;--faint:#9a9a9a;--line:#3a3a3a;"
    "--best:#f08a55}}\n"
    "body{font:16px/1.45 system-ui,sans-serif;color:var(--ink);background:var(--paper);max-width:72rem;margin:0 auto;"
    "padding:1rem}\n"
    "h1,h2{line-height:1.2}h2{margin-top:2.5em;border-top:1px solid var(--line);padding-top:.6em}\n"
    "p{max-width:44rem}a{color:inherit}nav a{display:inline-block;margin:.2em .7em .2em 0}\n"
    ".wide{overflow-x:auto}table{border-collapse:collapse;font-variant-numeric:tabular-nums}\n"
    "th,td{padding:.25em .6em;text-align:right;border-bottom:1px solid var(--line);white-space:nowrap}\n"
    ".wide th:first-child,.wide td:first-child{text-align:left;position:sticky;left:0;background:var(--paper)}\n"
    ".beaten,.beaten a{color:var(--faint)}.best{color:var(--best);font-weight:600}.best::after{content:\" \\25cf\"}\n"
    ".plots,.cards{display:grid;gap:1rem}.plots{grid-template-columns:repeat(auto-fit,minmax(min(100%,24rem),1fr))}\n"
    ".cards{grid-template-columns:repeat(auto-fill,minmax(min(100%,20rem),1fr))}figure{margin:0;min-width:0}\n"
    ".plots svg{width:100%;height:auto;max-width:32rem}svg [color=black]{color:inherit}\n"
    "svg [fill=black]{fill:currentColor}svg [stroke=black]{stroke:currentColor}\n"
    ".card{border:1px solid var(--line);border-radius:6px;padding:.7rem}.card h3{margin:0 0 .4em;font-size:1.05rem}\n"
    ".pair{display:grid;grid-template-columns:repeat(2,minmax(0,1fr));align-items:start;gap:.4rem}"
    ".pair img,.row img{width:100%;height:auto;display:block}\n"
    ".row{display:grid;grid-template-columns:repeat(auto-fit,minmax(11rem,1fr));gap:.4rem}.rows .card{margin:1rem 0}\n"
    "dl{display:grid;grid-template-columns:auto 1fr;gap:0 .8em;margin:.5em 0 0;font-variant-numeric:tabular-nums}\n"
    "dt{color:var(--faint)}dd{margin:0}\n"
    ".first td{border-top:2px solid var(--line)}\n"
    ".key{font-size:.75rem;line-height:1.25;width:100%;table-layout:fixed}.key td{padding:0 "
    ".3em;text-align:center;border:0}\n"
    "figcaption{font-size:.95rem;margin-top:.4em}\n";

void page_begin(FILE *out, const char *const paths[], unsigned count, const struct page_sections *sections)
{
    char name[SURVEY_NAME];
    fprintf(out,
            "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
            "<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">\n"
            "<title>Glint: what accuracy costs</title>\n<style>\n%s</style>\n</head>\n<body>\n",
            page_style);
    fprintf(
        out,
        "<h1>Glint: what accuracy costs</h1>\n"
        "<p>Every scene drawn by every shading method in integers, beside the truth: per-pixel Phong in double "
        "precision, the normal interpolated correctly in perspective. Pictures are 8-bit grey.</p>\n"
        "<p><b>PSNR</b> in dB, <b>RMS</b> and <b>largest difference</b> in 1/255, over the pixels that the scene "
        "covers, are taken from the truth before it is rounded: 8-bit output alone allows 58.9 dB. "
        "<b>Instructions</b> of one frame, clear and depth included, drawn in one piece, counted by QEMU on its "
        "mps2 boards as a Cortex-M3 and a Cortex-M0+ (gcc&nbsp;&#8209;O2). <b>Flash</b> is that of a program which "
        "draws by "
        "this method alone, mem* and libgcc included, its scene not.</p>\n"
        "<p>A figure is <span class=\"best\">marked</span> where a method belongs to the Pareto set of that CPU: "
        "none that costs no more is closer to the truth; in the plots the set is filled and joined. "
        "<span class=\"beaten\">Faint</span> is what another method beats on both.</p>\n"
        "<p><b>auto</b> takes, a triangle, the cheapest way that its bounds allow within a budget: how many 255ths a "
        "pixel may be off, roundings of at most 1.5 apart; by itself 2. Its budgets are the blue line in the plots, "
        "each by its number. In their "
        "tables <b>bound</b> is the largest error that a triangle of the frame was promised, and a way has its "
        "triangles and its share of the pixels; lights and highlights are <b>hidden</b> that can reach no pixel of a "
        "triangle, <b>dropped</b> that are within the budget, dot products <b>straightened</b> that are drawn linear, "
        "triangles <b>undivided</b> that a perspective view draws as a flat one. Below them, what each triangle was "
        "drawn "
        "by:");
    sweep_legend(out);
    fprintf(out, ".</p>\n<nav>");
    for (unsigned i = 0; i < count; i++)
        if (survey_name(paths[i], name))
            fprintf(out, "<a href=\"#%s\">%s</a>\n", name, name);
    const struct {
        const char *id, *title;
        bool there;
    } links[] = {{"effects", "Effects", sections->effects},
                 {"angle", "X-shading\u2019s error", true},
                 {"power", "The highlight\u2019s power", sections->power},
                 {"choices", "Fixed-point choices", sections->choices},
                 {"stream", "As a stream", sections->streams},
                 {"boards", "On boards", sections->boards}};
    for (unsigned i = 0; i < sizeof links / sizeof *links; i++)
        if (links[i].there)
            fprintf(out, "<a href=\"#%s\">%s</a>\n", links[i].id, links[i].title);
    fprintf(out, "</nav>\n");
}

static const char *page_class(const struct survey_row *row)
{
    for (enum costs_cpu cpu = 0; cpu < COSTS_CPUS; cpu++)
        if (!row->beaten_by[cpu])
            return "";
    return " class=\"beaten\"";
}

void page_summary(FILE *out, const struct survey *survey)
{
    fprintf(out,
            "<h2>%s at a glance</h2>\n<div class=\"wide\"><table>\n<tr><th>method</th><th>PSNR, dB</th><th>RMS</th>"
            "<th>largest</th>",
            survey->scene);
    for (enum costs_cpu cpu = 0; cpu < COSTS_CPUS; cpu++)
        fprintf(out, "<th>%s, M instr.</th>", costs_cpu_titles[cpu]);
    for (enum costs_cpu cpu = 0; cpu < COSTS_CPUS; cpu++)
        fprintf(out, "<th>%s, flash bytes</th>", costs_cpu_titles[cpu]);
    fprintf(out, "</tr>\n");
    for (unsigned i = 0; i < survey->count; i++) {
        const struct survey_row *row = &survey->rows[i];
        fprintf(out, "<tr%s><td><a href=\"#%s-%s\">%s</a></td><td>%.1f</td><td>%.2f</td><td>%.1f</td>", page_class(row),
                survey->scene, row->method, row->method, plot_decibel(&row->error), row->error.rms, row->error.max);
        for (enum costs_cpu cpu = 0; cpu < COSTS_CPUS; cpu++)
            fprintf(out, "<td%s>%.2f</td>", row->beaten_by[cpu] ? "" : " class=\"best\"", row->instructions[cpu] / 1e6);
        for (enum costs_cpu cpu = 0; cpu < COSTS_CPUS; cpu++)
            fprintf(out, "<td>%u</td>", (unsigned)row->flash[cpu]);
        fprintf(out, "</tr>\n");
    }
    fprintf(out, "</table></div>\n");
}

static void page_figures(FILE *out, const struct survey_row *row)
{
    fprintf(out, "<dl><dt>PSNR</dt><dd>%.2f dB</dd><dt>RMS, largest</dt><dd>%.3f, %.2f</dd>", plot_decibel(&row->error),
            row->error.rms, row->error.max);
    for (enum costs_cpu cpu = 0; cpu < COSTS_CPUS; cpu++) {
        fprintf(out, "<dt>%s, M instr.</dt><dd><span%s>%.3f</span>", costs_cpu_titles[cpu],
                row->beaten_by[cpu] ? "" : " class=\"best\"", row->instructions[cpu] / 1e6);
        if (row->beaten_by[cpu])
            fprintf(out, ", beaten by %s", row->beaten_by[cpu]);
        fprintf(out, "</dd>");
    }
    fprintf(out, "<dt>flash, B</dt><dd>");
    for (enum costs_cpu cpu = 0; cpu < COSTS_CPUS; cpu++)
        fprintf(out, "%s%s %u", cpu ? ", " : "", costs_cpu_titles[cpu], (unsigned)row->flash[cpu]);
    fprintf(out, "</dd></dl>");
}

/* What is worth showing of a picture as large as the scene's. */
static bool page_picture(FILE *out, const struct survey *survey, const uint8_t *pixels, enum picture_kind kind,
                         const char *caption)
{
    const struct survey_box *box = &survey->box;
    const struct picture picture = {pixels + (size_t)box->top * survey->width + box->left, survey->width, box->width,
                                    box->height, kind};
    return picture_write(out, &picture, caption);
}

/* The truth, and what the colours of a difference mean. */
static bool page_truth(FILE *out, const struct survey *survey)
{
    static const char *const from[PICTURE_LEVELS + 1] = {"0", "\u00bd", "1", "2", "4", "8", "16", "32"};
    char caption[160];
    snprintf(caption, sizeof caption, "%s, the truth", survey->scene);
    fprintf(out, "<figure class=\"card\"><h3>the truth</h3><div class=\"pair\">");
    bool done = page_picture(out, survey, survey->truth, PICTURE_GREY, caption);
    fprintf(out, "<table class=\"key\">");
    for (int level = PICTURE_LEVELS; level >= 0; level--) {
        fprintf(out, "<tr>");
        for (int sign = -1; sign <= 1; sign++) {
            uint8_t rgb[3];
            picture_colour(sign * level, rgb);
            if (sign)
                fprintf(out, "<td style=\"background:#%02x%02x%02x\"></td>", rgb[0], rgb[1], rgb[2]);
            else
                fprintf(out, "<td>%s</td>", from[level]);
        }
        fprintf(out, "</tr>");
    }
    fprintf(out,
            "</table></div><figcaption>Right: the colours of a difference of so many 255ths or more, too dark and too "
            "bright.</figcaption></figure>\n");
    return done;
}

static bool page_card(FILE *out, const struct survey *survey, const struct survey_row *row)
{
    char caption[160];
    fprintf(out, "<figure class=\"card\" id=\"%s-%s\"><h3%s>%s</h3><div class=\"pair\">", survey->scene, row->method,
            page_class(row), row->method);
    snprintf(caption, sizeof caption, "%s by %s", survey->scene, row->method);
    bool done = page_picture(out, survey, row->grey, PICTURE_GREY, caption);
    snprintf(caption, sizeof caption, "%s by %s less the truth", survey->scene, row->method);
    done = done && page_picture(out, survey, row->difference, PICTURE_DIFFERENCE, caption);
    fprintf(out, "</div><figcaption>");
    page_figures(out, row);
    fprintf(out, "</figcaption></figure>\n");
    return done;
}

int page_scene(FILE *out, const struct survey *survey)
{
    fprintf(out, "<h2 id=\"%s\">%s</h2>\n<p>%lu triangles, %u\u00d7%u, %s; %zu pixels compared.", survey->scene,
            survey->scene, survey->triangles, survey->width, survey->height,
            survey->perspective ? "in perspective" : "orthographic", survey->rows[0].error.pixels);
    if (survey->ideal_triangles)
        fprintf(out,
                " Its truth is %s-ideal, the curved surface through the same vertices and normals in %lu triangles; "
                "compared are the pixels that both cover.",
                survey->scene, survey->ideal_triangles);
    fprintf(out, "</p>\n<div class=\"plots\">");
    for (unsigned i = 0; i < (survey->budget_count ? 2 : 1) * COSTS_CPUS; i++) { /* a budget is about the largest */
        fprintf(out, "<figure>");
        int code = plot_write(out, survey, i % COSTS_CPUS, i < COSTS_CPUS ? PLOT_PSNR : PLOT_LARGEST);
        if (code)
            return code;
        fprintf(out, "</figure>\n");
    }
    fprintf(out, "</div>\n");
    bool done = sweep_write(out, survey);
    fprintf(out, "<div class=\"cards\">\n");
    done = done && page_truth(out, survey);
    for (unsigned i = 0; i < survey->count && done; i++)
        done = page_card(out, survey, &survey->rows[i]);
    fprintf(out, "</div>\n");
    if (!done)
        fprintf(stderr, "%s: out of memory\n", survey->scene);
    return done ? CLI_DONE : CLI_IO;
}

void page_end(FILE *out)
{
    fprintf(out, "</body>\n</html>\n");
}

void page_csv_head(FILE *out)
{
    fprintf(out, "scene,method,triangles,pixels,psnr_db,rms,max,p999");
    for (enum costs_cpu cpu = 0; cpu < COSTS_CPUS; cpu++)
        fprintf(out, ",%s_instructions,%s_flash,%s_beaten_by", costs_cpu_names[cpu], costs_cpu_names[cpu],
                costs_cpu_names[cpu]);
    fprintf(out, "\n");
}

void page_csv(FILE *out, const struct survey *survey)
{
    for (unsigned i = 0; i < survey->count; i++) {
        const struct survey_row *row = &survey->rows[i];
        fprintf(out, "%s,%s,%lu,%zu,%.4f,%.6f,%.4f,%g", survey->scene, row->method, survey->triangles,
                row->error.pixels, plot_decibel(&row->error), row->error.rms, row->error.max, row->error.p999);
        for (enum costs_cpu cpu = 0; cpu < COSTS_CPUS; cpu++)
            fprintf(out, ",%u,%u,%s", (unsigned)row->instructions[cpu], (unsigned)row->flash[cpu],
                    row->beaten_by[cpu] ? row->beaten_by[cpu] : "");
        fprintf(out, "\n");
    }
}
