/* SPDX-License-Identifier: MIT */
/* The viewer's window on SDL's driver without a screen, while one or two calls of SDL fail. */
#include "view/window.h"

#include "glint/cli.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "listen.h"

#include "tests/faults/pairs.h"

#ifdef HAVE_SDL2
#include <SDL.h>

enum { WIDTH = 32, HEIGHT = 20, MOST_FILE = 1 << 20 };

static struct seam seam;
static int windows, renderers;

static int fails(void)
{
    return seam_fails(&seam) ? SDL_SetError("a fault") : 0;
}

/* Defines __wrap_NAME, which returns `lost` when the call fails, else what NAME does. */
#define WRAP(type, lost, name, parameters, arguments)      \
    type __real_##name parameters;                         \
    type __wrap_##name parameters;                         \
    type __wrap_##name parameters                          \
    {                                                      \
        return fails() ? (lost) : __real_##name arguments; \
    }

WRAP(int, -1, SDL_Init, (Uint32 flags), (flags))
WRAP(SDL_Texture *, NULL, SDL_CreateTexture, (SDL_Renderer * r, Uint32 format, int access, int w, int h),
     (r, format, access, w, h))
WRAP(int, -1, SDL_LockTexture, (SDL_Texture * t, const SDL_Rect *part, void **pixels, int *pitch),
     (t, part, pixels, pitch))
WRAP(int, -1, SDL_UpdateTexture, (SDL_Texture * t, const SDL_Rect *part, const void *pixels, int pitch),
     (t, part, pixels, pitch))
WRAP(int, -1, SDL_SetTextureColorMod, (SDL_Texture * t, Uint8 r, Uint8 g, Uint8 b), (t, r, g, b))
WRAP(int, -1, SDL_SetTextureBlendMode, (SDL_Texture * t, SDL_BlendMode mode), (t, mode))
WRAP(int, -1, SDL_GetRendererOutputSize, (SDL_Renderer * r, int *width, int *height), (r, width, height))
WRAP(int, -1, SDL_SetRenderDrawColor, (SDL_Renderer * r, Uint8 red, Uint8 g, Uint8 b, Uint8 a), (r, red, g, b, a))
WRAP(int, -1, SDL_RenderClear, (SDL_Renderer * r), (r))
WRAP(int, -1, SDL_RenderCopy, (SDL_Renderer * r, SDL_Texture *t, const SDL_Rect *from, const SDL_Rect *to),
     (r, t, from, to))
WRAP(int, -1, SDL_RenderReadPixels, (SDL_Renderer * r, const SDL_Rect *part, Uint32 format, void *pixels, int pitch),
     (r, part, format, pixels, pitch))
WRAP(int, -1, SDL_GetDisplayUsableBounds, (int display, SDL_Rect *bounds), (display, bounds))
WRAP(int, -1, SDL_SetWindowFullscreen, (SDL_Window * w, Uint32 flags), (w, flags))

/* What is opened is closed, too. */
SDL_Window *__real_SDL_CreateWindow(const char *title, int x, int y, int w, int h, Uint32 flags);
SDL_Window *__wrap_SDL_CreateWindow(const char *title, int x, int y, int w, int h, Uint32 flags);
SDL_Window *__wrap_SDL_CreateWindow(const char *title, int x, int y, int w, int h, Uint32 flags)
{
    SDL_Window *window = fails() ? NULL : __real_SDL_CreateWindow(title, x, y, w, h, flags);
    windows += window != NULL;
    return window;
}
SDL_Renderer *__real_SDL_CreateRenderer(SDL_Window *window, int index, Uint32 flags);
SDL_Renderer *__wrap_SDL_CreateRenderer(SDL_Window *window, int index, Uint32 flags);
SDL_Renderer *__wrap_SDL_CreateRenderer(SDL_Window *window, int index, Uint32 flags)
{
    SDL_Renderer *renderer = fails() ? NULL : __real_SDL_CreateRenderer(window, index, flags);
    renderers += renderer != NULL;
    return renderer;
}
#define UNWRAP(count, name, parameters, argument) \
    void __real_##name parameters;                \
    void __wrap_##name parameters;                \
    void __wrap_##name parameters                 \
    {                                             \
        count--;                                  \
        __real_##name argument;                   \
    }
UNWRAP(windows, SDL_DestroyWindow, (SDL_Window * window), (window))
UNWRAP(renderers, SDL_DestroyRenderer, (SDL_Renderer * renderer), (renderer))

static struct overlay_text text[OVERLAY_PLACES];
static struct frames_picture picture;
static char path[] = "/tmp/glint-window-XXXXXX/window.png";
static uint8_t good[MOST_FILE], file[MOST_FILE];
static size_t good_size;
static bool differs;

/* The file's bytes, once. */
static size_t saved(uint8_t *bytes)
{
    FILE *in = fopen(path, "rb");
    size_t size = in ? fread(bytes, 1, MOST_FILE, in) : 0;
    if (in)
        fclose(in);
    remove(path);
    return size;
}

/* Saves the window, which shows what it should unless it says that it does not. */
static int save(struct window *w)
{
    int code = window_save(w, path);
    if (code)
        return code;
    const size_t size = saved(file);
    if (!good_size)
        memcpy(good, file, good_size = size);
    differs |= size != good_size || memcmp(file, good, size) != 0;
    return 0;
}

/* A session: an exit code. */
static int use(struct window *w)
{
    static struct controls controls;
    window_size(w, WIDTH, HEIGHT, 0);
    window_title(w, "a title");
    window_words(w, text);
    window_draw(w);
    int code = window_picture(w, &picture, 0);
    window_draw(w);
    window_keys(w, &controls, 0);
    code = code ? code : window_picture(w, &picture, 1);
    if (code)
        return code;
    window_size(w, HEIGHT, WIDTH, 3);
    window_dim(w, true);
    window_draw(w);
    code = save(w);
    window_fullscreen(w, true);
    window_keys(w, &controls, 0);
    window_draw(w);
    seam.fails_at = seam.then_at = 0; /* from here on all is well again */
    window_fullscreen(w, false);
    window_size(w, HEIGHT, WIDTH, 3);
    differs |= save(w) != 0;
    return code;
}

static void run(const struct seam *next)
{
    struct window *w;
    char told[4096];
    seam = *next;
    differs = false;
    const struct listen errors = listen_begin(STDERR_FILENO);
    int code = window_open(&w);
    if (code == 0)
        code = use(w);
    window_close(w);
    listen_end(&errors, told, sizeof told);
    const char *end = strchr(told, '\n');
    if (code == 0 ? told[0] : code != CLI_IO || !end || end[1])
        fail_msg("calls %d and %d: code %d, told '%s'", next->fails_at, next->then_at, code, told);
    if (differs)
        fail_msg("calls %d and %d: another picture, told '%s'", next->fails_at, next->then_at, told);
    assert_int_equal(windows, 0);
    assert_int_equal(renderers, 0);
    assert_int_equal(SDL_WasInit(SDL_INIT_VIDEO), 0);
}

static int begin(void **state)
{
    static uint8_t pixels[3 * WIDTH * HEIGHT];
    (void)state;
    for (size_t i = 0; i < sizeof pixels; i++)
        pixels[i] = (uint8_t)(i * 7 & 255);
    picture = (struct frames_picture){.pixels = pixels, .width = WIDTH, .height = HEIGHT, .format = STREAM_RGB888};
    overlay_add(&text[OVERLAY_TOP], "a line");
    overlay_add(&text[OVERLAY_BOTTOM], "and another");
    setenv("SDL_VIDEODRIVER", "dummy", 1);
    *strrchr(path, '/') = 0;
    if (!mkdtemp(path))
        return 1;
    path[strlen(path)] = '/';
    return 0;
}

static int end(void **state)
{
    (void)state;
    *strrchr(path, '/') = 0;
    return rmdir(path);
}

static void calls_of_sdl_that_fail_are_told_or_mended(void **state)
{
    (void)state;
    run(&(struct seam){0});
    const int calls = seam.calls;
    assert_true(good_size > 0);
    for (int k = 1; k <= calls; k++)
        run(&(struct seam){.fails_at = k, .reason = EIO});
    struct pairs pairs = pairs_of(calls, pairs_most(100));
    for (struct seam next; pairs_next(&pairs, &next);)
        run(&next);
    print_message("%u runs with one or two failing of %d calls\n", (unsigned)calls + pairs.tried, calls);
}

#else

static void a_window_without_sdl_is_refused(void **state)
{
    struct window *w;
    char told[4096];
    (void)state;
    const struct listen errors = listen_begin(STDERR_FILENO);
    assert_int_equal(window_open(&w), CLI_IO);
    listen_end(&errors, told, sizeof told);
    assert_non_null(strstr(told, "--headless"));
}

#endif

int main(void)
{
#ifdef HAVE_SDL2
    const struct CMUnitTest tests[] = {cmocka_unit_test(calls_of_sdl_that_fail_are_told_or_mended)};
    return cmocka_run_group_tests(tests, begin, end);
#else
    const struct CMUnitTest tests[] = {cmocka_unit_test(a_window_without_sdl_is_refused)};
    return cmocka_run_group_tests(tests, NULL, NULL);
#endif
}
