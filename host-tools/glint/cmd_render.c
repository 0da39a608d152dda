/* SPDX-License-Identifier: MIT */
#include "glint/cli.h"
#include "glint/commands.h"
#include "glint/hashes.h"
#include "glint/output.h"
#include "glint/progress.h"
#include "glint/renderer.h"
#include "glint/streamer.h"
#include "glint/tally.h"

#include <getopt.h>
#include <stdio.h>
#include <string.h>

static const char render_name[] = "glint render";

static const char render_help[] =
    "usage: glint render FILE [OPTION]...\n\n"
    "Draws a scene or model as a device would.\n\n"
    "  -o, --output FILE      .png (animated if there are several frames), .apng, .ppm, .y4m, .raw (the bytes as "
    "drawn),\n"
    "                         a folder with '/' at its end (numbered PNG files), or - for standard output\n"
    "      --output-format F  " OUTPUT_FORMATS ", whatever the ending\n"
    "      --stream FILE      instead of -o: as a device sends it to glint-view (firmware/stream/PROTOCOL.md); - for\n"
    "                         standard output\n"
    "      --key N            of a stream: a picture in N refers to none before it, 1..1000000, default 60\n"
    "      --method M         one of `glint methods`, default auto\n"
    "      --show plan        auto: each triangle in the colour of what was chosen for it\n"
    "      --budget N         auto: how far a pixel may be off, .01 to 255 in 1/255, default 2\n"
    "      --subdivide MODE   with --method subdivide: centre (default), regular, highlight, recursive, hybrid, "
    "hybrid-x\n"
    "      --tolerance N      subdivide centre: splits while the centre errs by more, 1..255 in 1/255, default 4\n"
    "      --area N           subdivide recursive and regular: splits down to N pixels, 1..65535, default 32\n"
    "      --threshold F      subdivide highlight: halves edges while the colour errs by more, .004 to .996 of it,\n"
    "                         default .3\n"
    "      --power P          of the highlight: table (default), exact, or free of powers by squarings: 4, 8, 16\n"
    "      --texture KIND     how its coordinates are interpolated: affine, quadratic, split (quadratic, of triangles\n"
    "                         split where that errs by more than the budget) or perspective; default: perspective,\n"
    "                         with --method auto what the budget allows\n"
    "      --perspective      the method's perspective-correct variant\n"
    "      --size WxH         in pixels, each 1..2048; the default is the camera's\n"
    "      --frames N         1..1000000; default 1, for .apng, .y4m, folders and streams one loop of the animation\n"
    "      --fps F            frames a second, 1..1000, default 30; frame i shows the moment i * 1000 / F ms\n"
    "      --time MS          the moment of the first frame in milliseconds, default 0\n"
    "      --turn YAW,PITCH   turns each object about its own origin, its front to the right and up, in degrees; "
    "default 0,0\n"
    "      --format F         rgb565, rgb888 (default), grey8 or grey4\n"
    "      --dither           ordered dither for rgb565 and grey4\n"
    "      --band-rows N      rows drawn at a time, 1..2048; the default is all. The picture is the same\n"
    "      --tables N         tables of colours or highlights, one a material, 0..255, default 0\n"
    "      --no-plan          compute also what cannot be seen. The picture is the same\n"
    "      --every-zigzag     biquadratic: bends every edge that passes the paper's test, also where the triangles at "
    "it\n"
    "                         have no inflection\n"
    "      --shininess N      1..1023, replaces every material's exponent\n"
    "      --stats[=json]     print counts of triangles and pixels, memory and time\n"
    "      --hash             print '<index> <hash>' for each frame: CRC-32 of its bytes in the chosen format\n"
    "      --expect FILE      fail at the first frame whose hash is not that of FILE, a list as --hash prints it\n"
    "      --progress         show a progress bar also where stderr is no terminal\n"
    "      --help\n";

struct render {
    struct renderer renderer;
    struct output output;
    struct streamer streamer;
    struct hashes expected;
    struct tally tally;
    struct pack_options pack;
    const char *scene, *path, *output_format, *expect, *method, *subdivide;
    uint32_t frames, rate, time_ms, band_rows;
    uint16_t yaw, pitch;
    bool stats, json, hash, progress, perspective, show;
};

enum render_option {
    RENDER_OUTPUT = 'o',
    RENDER_HELP = 'h',
    RENDER_OUTPUT_FORMAT = 256,
    RENDER_METHOD,
    RENDER_BUDGET,
    RENDER_SHOW,
    RENDER_POWER,
    RENDER_SUBDIVIDE,
    RENDER_TOLERANCE,
    RENDER_AREA,
    RENDER_THRESHOLD,
    RENDER_PERSPECTIVE,
    RENDER_TEXTURE,
    RENDER_SIZE,
    RENDER_FRAMES,
    RENDER_FPS,
    RENDER_TIME,
    RENDER_TURN,
    RENDER_FORMAT,
    RENDER_DITHER,
    RENDER_BAND_ROWS,
    RENDER_TABLES,
    RENDER_NO_PLAN,
    RENDER_EVERY_ZIGZAG,
    RENDER_SHININESS,
    RENDER_STATS,
    RENDER_HASH,
    RENDER_EXPECT,
    RENDER_PROGRESS,
    RENDER_STREAM,
    RENDER_KEY,
};

static const struct option render_options[] = {{"output", required_argument, NULL, RENDER_OUTPUT},
                                               {"output-format", required_argument, NULL, RENDER_OUTPUT_FORMAT},
                                               {"method", required_argument, NULL, RENDER_METHOD},
                                               {"show", required_argument, NULL, RENDER_SHOW},
                                               {"budget", required_argument, NULL, RENDER_BUDGET},
                                               {"power", required_argument, NULL, RENDER_POWER},
                                               {"subdivide", required_argument, NULL, RENDER_SUBDIVIDE},
                                               {"tolerance", required_argument, NULL, RENDER_TOLERANCE},
                                               {"area", required_argument, NULL, RENDER_AREA},
                                               {"threshold", required_argument, NULL, RENDER_THRESHOLD},
                                               {"perspective", no_argument, NULL, RENDER_PERSPECTIVE},
                                               {"texture", required_argument, NULL, RENDER_TEXTURE},
                                               {"size", required_argument, NULL, RENDER_SIZE},
                                               {"frames", required_argument, NULL, RENDER_FRAMES},
                                               {"fps", required_argument, NULL, RENDER_FPS},
                                               {"time", required_argument, NULL, RENDER_TIME},
                                               {"turn", required_argument, NULL, RENDER_TURN},
                                               {"format", required_argument, NULL, RENDER_FORMAT},
                                               {"dither", no_argument, NULL, RENDER_DITHER},
                                               {"band-rows", required_argument, NULL, RENDER_BAND_ROWS},
                                               {"tables", required_argument, NULL, RENDER_TABLES},
                                               {"no-plan", no_argument, NULL, RENDER_NO_PLAN},
                                               {"every-zigzag", no_argument, NULL, RENDER_EVERY_ZIGZAG},
                                               {"shininess", required_argument, NULL, RENDER_SHININESS},
                                               {"stats", optional_argument, NULL, RENDER_STATS},
                                               {"hash", no_argument, NULL, RENDER_HASH},
                                               {"expect", required_argument, NULL, RENDER_EXPECT},
                                               {"progress", no_argument, NULL, RENDER_PROGRESS},
                                               {"stream", required_argument, NULL, RENDER_STREAM},
                                               {"key", required_argument, NULL, RENDER_KEY},
                                               {"help", no_argument, NULL, RENDER_HELP},
                                               {0}};

/* Stores a number that fits 0..255 or an index; false for what cli_choice() did not find. */
static bool render_choose(int choice, uint8_t *out)
{
    if (choice >= 0)
        *out = (uint8_t)choice;
    return choice >= 0;
}

static bool render_choose_power(const char *text, const struct glint_power **power)
{
    int choice = cli_choice(text, renderer_power_names, RENDERER_POWERS);
    if (choice >= 0)
        *power = renderer_powers[choice];
    return choice >= 0;
}

/* The options that say what to draw, and how; false if `text` is not a value of one. */
static bool render_value(struct render *render, int option, const char *text)
{
    struct glint_config *config = &render->renderer.config;
    uint32_t number;
    switch (option) {
    case RENDER_METHOD:
        render->method = text;
        return true;
    case RENDER_FORMAT:
        return render_choose(cli_choice(text, cli_formats, GLINT_FORMATS), &config->format);
    case RENDER_SHOW:
        render->show = true;
        return strcmp(text, "plan") == 0;
    case RENDER_BUDGET:
        return cli_budget(text, &config->budget);
    case RENDER_POWER:
        return render_choose_power(text, &config->power);
    case RENDER_TEXTURE:
        return render_choose(cli_choice(text, cli_textures, GLINT_TEXTURES), &config->texture);
    case RENDER_SIZE:
        return cli_size(text, &config->width, &config->height);
    case RENDER_FRAMES:
        return cli_number(text, 1, 1000000, &render->frames);
    case RENDER_FPS:
        return cli_number(text, 1, 1000, &render->rate);
    case RENDER_KEY:
        return cli_number(text, 1, 1000000, &render->streamer.key_every);
    case RENDER_TIME:
        return cli_number(text, 0, UINT32_MAX, &render->time_ms);
    case RENDER_TURN:
        return cli_turn(text, &render->yaw, &render->pitch);
    case RENDER_BAND_ROWS:
        return cli_number(text, 1, GLINT_MAX_SIZE, &render->band_rows);
    case RENDER_TABLES:
        return cli_number(text, 0, 255, &number) && render_choose((int)number, &config->tables);
    case RENDER_TOLERANCE:
        return cli_number(text, 1, 255, &number) && render_choose((int)number, &config->subdivide_tolerance);
    case RENDER_AREA:
        return cli_number(text, 1, UINT16_MAX, &number) && (config->subdivide_area = (uint16_t)number, true);
    case RENDER_THRESHOLD:
        return cli_fraction(text, &config->subdivide_threshold);
    case RENDER_SHININESS:
        return cli_number(text, 1, FX_POWER_MAX_EXPONENT, &number) && (render->pack.shininess = number, true);
    default: /* RENDER_STATS */
        render->stats = true;
        render->json = text != NULL;
        return !text || strcmp(text, "json") == 0;
    }
}

static void render_flag(struct render *render, int option)
{
    switch (option) {
    case RENDER_OUTPUT:
        render->path = optarg;
        break;
    case RENDER_STREAM:
        render->streamer.path = optarg;
        break;
    case RENDER_OUTPUT_FORMAT:
        render->output_format = optarg;
        break;
    case RENDER_EXPECT:
        render->expect = optarg;
        break;
    case RENDER_SUBDIVIDE:
        render->subdivide = optarg;
        break;
    case RENDER_PERSPECTIVE:
        render->perspective = true;
        break;
    case RENDER_DITHER:
        render->renderer.config.flags |= GLINT_DITHER;
        break;
    case RENDER_NO_PLAN:
        render->renderer.config.flags |= GLINT_NO_PLAN;
        break;
    case RENDER_EVERY_ZIGZAG:
        render->renderer.config.flags |= GLINT_EVERY_ZIGZAG;
        break;
    case RENDER_HASH:
        render->hash = true;
        break;
    case RENDER_PROGRESS:
        render->progress = true;
        break;
    }
}

/* Finds the method by --method, --subdivide and --perspective together: "subdivide-centre", "x-perspective". */
static int render_choose_method(struct render *render)
{
    static const struct glint_choice shown = {"auto", &glint_auto_shown};
    const bool planned = strcmp(render->method, "auto") == 0; /* it sees to perspective itself */
    char name[64];
    if (render->show && !planned)
        return cli_usage(render_name, "--show plan is of --method auto");
    if (!render->subdivide && strcmp(render->method, "subdivide") == 0)
        render->subdivide = "centre";
    int length =
        snprintf(name, sizeof name, "%s%s%s%s", render->method, render->subdivide ? "-" : "",
                 render->subdivide ? render->subdivide : "", render->perspective && !planned ? "-perspective" : "");
    if (length < (int)sizeof name)
        render->renderer.choice = render->show ? &shown : renderer_find(name);
    return render->renderer.choice
               ? -1
               : cli_usage(render_name, "there is no method '%s'; `glint methods` lists them", name);
}

/* Exit code, or -1 to go on. */
static int render_parse(struct render *render, int argc, char **argv)
{
    int option, index = 0;
    while ((option = getopt_long(argc, argv, "o:h", render_options, &index)) != -1) {
        switch (option) {
        case RENDER_HELP:
            fputs(render_help, stdout);
            return CLI_DONE;
        case '?':
            return CLI_BAD_USAGE;
        case RENDER_OUTPUT:
        case RENDER_STREAM:
        case RENDER_OUTPUT_FORMAT:
        case RENDER_EXPECT:
        case RENDER_SUBDIVIDE:
        case RENDER_PERSPECTIVE:
        case RENDER_DITHER:
        case RENDER_NO_PLAN:
        case RENDER_EVERY_ZIGZAG:
        case RENDER_HASH:
        case RENDER_PROGRESS:
            render_flag(render, option);
            break;
        default:
            if (!render_value(render, option, optarg))
                return cli_refuse(render_name, render_help, render_options[index].name, optarg);
        }
    }
    if (argc - optind != 1)
        return cli_usage(render_name, "one scene or model is needed");
    const char *path = render->path ? render->path : render->streamer.path;
    if (render->path && render->streamer.path)
        return cli_usage(render_name, "give -o or --stream, not both");
    if (!path && !render->hash && !render->expect && !render->stats)
        return cli_usage(render_name, "nothing to do: give -o, --stream, --hash, --expect or --stats");
    if (path && strcmp(path, "-") == 0 && (render->hash || render->stats))
        return cli_usage(render_name, "--hash and --stats print where the picture is written");
    return render_choose_method(render);
}

/* What the command line left open, from the scene. */
static void render_defaults(struct render *render, const struct scene_header *scene)
{
    struct glint_config *config = &render->renderer.config;
    if (config->width == 0) {
        config->width = scene->camera.reference_width;
        config->height = scene->camera.reference_height;
    }
    bool whole = render->band_rows == 0 || render->band_rows > config->height;
    config->band_rows = whole ? config->height : (uint16_t)render->band_rows;
    if (render->frames == 0 && (render->streamer.path || (render->path && render->output.animates)))
        render->frames = (uint32_t)(((uint64_t)scene->duration_ms * render->rate + 500) / 1000);
    if (render->frames == 0)
        render->frames = 1;
}

static uint32_t render_moment(const struct render *render, uint32_t index)
{
    return render->time_ms + (uint32_t)((uint64_t)index * 1000 / render->rate);
}

/* Draws a frame to where it goes, if anywhere: an exit code. */
static int render_picture(struct render *render, uint32_t index, uint32_t *crc)
{
    struct hal_display *display = render->path ? &render->output.host.display : NULL;
    uint32_t time = render_moment(render, index);
    int result = 0;
    if (display && display->ops->frame_begin)
        result = display->ops->frame_begin(display, index, render_moment(render, index + 1) - time);
    if (!result)
        result = renderer_draw(&render->renderer, time, display, crc, &render->tally.milliseconds);
    if (!result && display && display->ops->frame_end)
        result = display->ops->frame_end(display);
    return output_step(&render->output, result);
}

static int render_message(struct render *render, uint32_t index, uint32_t *crc)
{
    struct streamer *streamer = &render->streamer;
    uint32_t time = render_moment(render, index);
    double before = render->tally.milliseconds;
    int code = streamer_begin(streamer, &render->renderer, index, time);
    if (!code)
        code = streamer_step(
            streamer, renderer_draw(&render->renderer, time, &streamer->display, crc, &render->tally.milliseconds));
    return code ? code : streamer_end(streamer, &render->renderer, render->tally.milliseconds - before);
}

static int render_frame(struct render *render, uint32_t index)
{
    uint32_t crc = 0, *hash = render->hash || render->expect ? &crc : NULL;
    int code = render->streamer.path ? render_message(render, index, hash) : render_picture(render, index, hash);
    if (code)
        return code;
    tally_add(&render->tally, &render->renderer.frame.stats);
    if (render->hash)
        printf("%u %08x\n", (unsigned)index, (unsigned)crc);
    if (render->expect)
        code = hashes_check(&render->expected, index, crc);
    return code;
}

static int render_frames(struct render *render)
{
    const struct glint_config *config = &render->renderer.config;
    struct progress progress;
    int code = render->expect ? hashes_check_count(&render->expected, render->frames) : CLI_DONE;
    if (!code && render->path)
        code = output_open(&render->output, config->width, config->height, (enum hal_pixel_format)config->format,
                           render->frames, render->rate);
    if (!code && render->streamer.path)
        code = streamer_open(&render->streamer, &render->renderer, render->scene);
    progress_begin(&progress, render->progress);
    for (uint32_t i = 0; !code && i < render->frames; i++) {
        code = cli_interrupted() ? CLI_IO : render_frame(render, i);
        progress_step(&progress, i + 1, render->frames);
    }
    progress_end(&progress);
    int closed = render->streamer.path ? streamer_close(&render->streamer, code == CLI_DONE)
                                       : output_close(&render->output, code == CLI_DONE);
    code = code ? code : closed;
    if (!code && render->stats)
        tally_print(&render->tally, &render->renderer, render->json);
    return code;
}

int cmd_render(int argc, char **argv)
{
    struct render render = {
        .rate = 30, .method = "auto", .renderer.config.format = GLINT_RGB888, .streamer.key_every = 60};
    struct pack_result packed = {0};
    argv[0] = (char *)render_name;
    int code = render_parse(&render, argc, argv);
    if (code >= 0)
        return code;
    if (render.path && (code = output_choose(&render.output, render_name, render.path, render.output_format)))
        return code;
    if (render.expect && (code = hashes_read(render.expect, &render.expected)))
        return code;
    render.scene = argv[optind];
    code = pack_load(render.scene, &render.pack, &packed);
    if (!code) {
        render_defaults(&render, packed.scene);
        code = renderer_open(&render.renderer, packed.scene);
        if (!code) {
            glint_turn(&render.renderer.frame, render.yaw, render.pitch);
            code = render_frames(&render);
        }
        if (!code)
            renderer_warn(&render.renderer, argv[optind]);
        renderer_close(&render.renderer);
    }
    pack_free(&packed);
    hashes_free(&render.expected);
    return code;
}
