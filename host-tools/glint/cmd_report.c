/* SPDX-License-Identifier: MIT */
#include "glint/cli.h"
#include "glint/commands.h"
#include "glint/progress.h"
#include "glint/renderer.h"
#include "host/sink.h"
#include "report/angle.h"
#include "report/boards.h"
#include "report/choices.h"
#include "report/effects.h"
#include "report/page.h"
#include "report/powers.h"
#include "report/streams.h"
#include "report/sweep.h"
#include "scene/model.h"

#include <errno.h>
#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static const char report_name[] = "glint report";

static const char report_help[] =
    "usage: glint report -o FOLDER --costs FILE.csv --flash FILE.csv [OPTION]... SCENE...\n\n"
    "Draws scenes by every method and measures them against per-pixel Phong in double precision. Writes\n"
    "FOLDER/index.html, a page with pictures, differences and plots of cost against accuracy, and\n"
    "FOLDER/report.csv, with --stream FOLDER/stream.csv too. `make report` counts the costs and calls this. gnuplot\n"
    "draws the plots.\n\n"
    "  -o, --output FOLDER  made if it is not there\n"
    "      --costs FILE     cpu,scene,method,width,height,format,instructions,picture: of a frame on m3 and on m0plus\n"
    "      --flash FILE     cpu,method,bytes: of a program that draws by that method\n"
    "      --budgets FILE   cpu,scene,budget_q8,instructions: of a frame by auto; with it the page shows what a "
    "budget\n"
    "                       buys, and FOLDER/sweep.csv is written\n"
    "      --powers FILE    cpu,scene,power,exponent,instructions: of a frame of the first scene by x; with it the\n"
    "                       page compares the forms of the highlight's power at exponents 5, 20, 50 and 200\n"
    "      --effect SCENE   shows it by auto beside the truth, for a section of all scenes so given\n"
    "      --stream SCENE   measures the bytes of its pictures as a stream, for a section of all scenes so given\n"
    "      --packing FILE   cpu,scene,format,codec,pixels,bytes,instructions: of `make bench-stream`, for that "
    "section\n"
    "      --choices FILE   choice,value,where,figure,number: of tests/choices; with it the page has their tables\n"
    "      --boards FILE    board,what,figure,unit,number: of `make bench-boards`; with it the page has their tables\n"
    "      --methods A,B    some of `glint methods`; default those that the file of --flash has\n"
    "      --help\n";

enum report_file { REPORT_PAGE, REPORT_TABLE, REPORT_SWEEP, REPORT_STREAM, REPORT_FILES };

struct report {
    const char *folder, *boards_path, *choices_path;
    const char **methods, **streams, **effects; /* the last two: scenes' paths */
    unsigned method_count, stream_count, effect_count;
    bool chosen;        /* methods, by --methods */
    struct costs costs; /* its paths are the options' */
    char *path[REPORT_FILES];
    struct sink sink[REPORT_FILES];
    bool made; /* the folder was not there */
};

/* The method whose name is the first `length` characters, unless it is chosen already. */
static const char *report_method(const struct report *report, const char *text, size_t length)
{
    const char *found = NULL;
    for (unsigned m = 0; m < glint_choice_count; m++)
        if (strlen(glint_choices[m].name) == length && strncmp(glint_choices[m].name, text, length) == 0)
            found = glint_choices[m].name;
    for (unsigned m = 0; m < report->method_count; m++)
        if (report->methods[m] == found)
            return NULL;
    return found;
}

/* Of a list with commas. False: something in it is no method, or there twice. */
static bool report_choose(struct report *report, const char *names)
{
    report->method_count = 0;
    report->chosen = true;
    for (;;) {
        size_t length = strcspn(names, ",");
        const char *method = report_method(report, names, length);
        if (!method)
            return false;
        report->methods[report->method_count++] = method;
        if (!names[length])
            return true;
        names += length + 1;
    }
}

/* Exit code, or -1 to go on. */
static int report_parse(struct report *report, int argc, char **argv)
{
    static const struct option long_options[] = {{"output", required_argument, NULL, 'o'},
                                                 {"costs", required_argument, NULL, 'c'},
                                                 {"flash", required_argument, NULL, 'f'},
                                                 {"methods", required_argument, NULL, 'm'},
                                                 {"powers", required_argument, NULL, 'p'},
                                                 {"boards", required_argument, NULL, 'b'},
                                                 {"stream", required_argument, NULL, 's'},
                                                 {"packing", required_argument, NULL, 'k'},
                                                 {"effect", required_argument, NULL, 'e'},
                                                 {"budgets", required_argument, NULL, 'g'},
                                                 {"choices", required_argument, NULL, 'x'},
                                                 {"help", no_argument, NULL, 'h'},
                                                 {0}};
    int option;
    for (unsigned m = 0; m < glint_choice_count; m++)
        report->methods[report->method_count++] = glint_choices[m].name;
    while ((option = getopt_long(argc, argv, "o:h", long_options, NULL)) != -1) {
        switch (option) {
        case 'o':
            report->folder = optarg;
            break;
        case 'c':
            report->costs.frames_path = optarg;
            break;
        case 'f':
            report->costs.flash_path = optarg;
            break;
        case 'p':
            report->costs.powers_path = optarg;
            break;
        case 'b':
            report->boards_path = optarg;
            break;
        case 's':
            report->streams[report->stream_count++] = optarg;
            break;
        case 'e':
            report->effects[report->effect_count++] = optarg;
            break;
        case 'k':
            report->costs.streams_path = optarg;
            break;
        case 'x':
            report->choices_path = optarg;
            break;
        case 'g':
            report->costs.budgets_path = optarg;
            break;
        case 'm':
            if (!report_choose(report, optarg))
                return cli_refuse(report_name, report_help, "methods", optarg);
            break;
        case 'h':
            fputs(report_help, stdout);
            return CLI_DONE;
        default:
            return CLI_BAD_USAGE;
        }
    }
    if (optind == argc)
        return cli_usage(report_name, "at least one scene is needed");
    if (!report->folder || !report->folder[0] || !report->costs.frames_path || !report->costs.flash_path)
        return cli_usage(report_name, "-o, --costs and --flash are needed");
    return -1;
}

/* Without --methods: those that the file of --flash has. */
static void report_default(struct report *report)
{
    unsigned count = 0;
    for (unsigned m = 0; !report->chosen && m < report->method_count; m++)
        if (costs_find_flash(&report->costs, COSTS_M3, report->methods[m]))
            report->methods[count++] = report->methods[m];
    report->method_count = report->chosen ? report->method_count : count;
}

static bool report_wants(const struct report *report, enum report_file file)
{
    return file < REPORT_SWEEP ||
           (file == REPORT_SWEEP ? report->costs.budgets_path != NULL : report->stream_count > 0);
}

static int report_problem(const char *path)
{
    fprintf(stderr, "%s: %s\n", path, strerror(errno ? errno : EIO));
    return CLI_IO;
}

static int report_open(struct report *report)
{
    static const char *const names[REPORT_FILES] = {"index.html", "report.csv", "sweep.csv", "stream.csv"};
    cli_catch_signals();
    report->made = mkdir(report->folder, 0777) == 0;
    if (!report->made && errno != EEXIST)
        return report_problem(report->folder);
    for (unsigned i = 0; i < REPORT_FILES; i++) {
        if (!report_wants(report, i))
            continue;
        size_t size = strlen(report->folder) + strlen(names[i]) + 2;
        report->path[i] = model_alloc(size);
        snprintf(report->path[i], size, "%s/%s", report->folder, names[i]);
        if (sink_open(&report->sink[i], report->path[i]) != 0)
            return report_problem(report->path[i]);
    }
    return CLI_DONE;
}

static int report_scenes(struct report *report, const char *const paths[], unsigned count)
{
    FILE *page = report->sink[REPORT_PAGE].stream, *table = report->sink[REPORT_TABLE].stream;
    struct progress progress;
    int code = CLI_DONE;
    const struct page_sections sections = {.effects = report->effect_count > 0,
                                           .power = report->costs.powers_path != NULL,
                                           .choices = report->choices_path != NULL,
                                           .streams = report->stream_count > 0,
                                           .boards = report->boards_path != NULL};
    page_begin(page, paths, count, &sections);
    page_csv_head(table);
    if (report->costs.budgets_path)
        sweep_csv_head(report->sink[REPORT_SWEEP].stream);
    progress_begin(&progress, false);
    for (unsigned i = 0; !code && i < count; i++) {
        struct survey survey;
        code = survey_open(&survey, paths[i], report->methods, report->method_count, &report->costs);
        if (!code && i == 0)
            page_summary(page, &survey);
        if (!code)
            code = page_scene(page, &survey);
        if (!code)
            page_csv(table, &survey);
        if (!code && report->costs.budgets_path)
            sweep_csv(report->sink[REPORT_SWEEP].stream, &survey);
        survey_free(&survey);
        if (cli_interrupted())
            code = CLI_IO;
        progress_step(&progress, i + 1, count);
    }
    progress_end(&progress);
    if (!code && report->effect_count)
        code = effects_write(page, report->effects, report->effect_count);
    if (!code)
        code = angle_write(page);
    if (!code && report->costs.powers_path)
        code = powers_write(page, paths[0], &report->costs);
    if (!code && report->choices_path)
        code = choices_write(page, report->choices_path);
    if (!code && report->stream_count)
        code = streams_write(page, report->sink[REPORT_STREAM].stream, report->streams, report->stream_count,
                             &report->costs);
    if (!code && report->boards_path)
        code = boards_write(page, report->boards_path);
    page_end(page);
    return code;
}

/* What model_alloc() without memory ends, among others: leaves no half a report. */
static struct report *report_under_way;
static pid_t report_process; /* not the importer's */

static void report_close(struct report *report)
{
    for (unsigned i = 0; i < REPORT_FILES; i++)
        sink_close(&report->sink[i], 0);
    if (report->made)
        rmdir(report->folder);
}

static void report_abandon(void)
{
    if (report_under_way && getpid() == report_process)
        report_close(report_under_way);
}

static int report_run(struct report *report, const char *const paths[], unsigned count)
{
    int code = costs_read(&report->costs);
    report_default(report);
    report_under_way = report;
    report_process = getpid();
    atexit(report_abandon);
    if (!code)
        code = report_open(report);
    if (!code)
        code = report_scenes(report, paths, count);
    for (unsigned i = REPORT_FILES; i-- > 0;) /* the page last: it is never there without the tables */
        if (report_wants(report, i) && sink_close(&report->sink[i], !code) != 0 && !code)
            code = report_problem(report->path[i]);
    if (code)
        report_close(report);
    report_under_way = NULL;
    if (!code)
        printf("%s: %u scene%s by %u methods\n", report->path[REPORT_PAGE], count, count == 1 ? "" : "s",
               report->method_count);
    for (unsigned i = 0; i < REPORT_FILES; i++)
        free(report->path[i]);
    costs_free(&report->costs);
    return code;
}

int cmd_report(int argc, char **argv)
{
    struct report report = {.methods = model_alloc(glint_choice_count * sizeof *report.methods),
                            .streams = model_alloc((size_t)argc * sizeof *report.streams),
                            .effects = model_alloc((size_t)argc * sizeof *report.effects)};
    argv[0] = (char *)(uintptr_t)report_name;
    int code = report_parse(&report, argc, argv);
    if (code < 0)
        code = report_run(&report, (const char *const *)argv + optind, (unsigned)(argc - optind));
    free(report.methods);
    free(report.streams);
    free(report.effects);
    return code;
}
