/* SPDX-License-Identifier: MIT */
#ifdef HAVE_SDL2
#include "view/window.h"

#include "glint/cli.h"
#include "view/dump.h"
#include "view/pixels.h"

#include <SDL.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define WINDOW_WIDTH   480 /* before a picture has come; and what it is enlarged to, about */
#define WINDOW_HEIGHT  480
#define WINDOW_MAX     6    /* times that a pixel is enlarged at first */
#define WINDOW_LETTERS 240u /* and WINDOW_LINES: what words need where a pixel of theirs is one of the window's */
#define WINDOW_LINES   128u
#define WINDOW_DIM     80 /* of 255 */

struct window {
    SDL_Window *window;
    SDL_Renderer *renderer;
    SDL_Texture *picture, *words;
    int width, height; /* of the picture, as it is turned */
    struct overlay overlay;
    struct overlay_text text[OVERLAY_PLACES];
    bool dim, shown;
};

static int window_problem(const char *what, const char *reason)
{
    fprintf(stderr, "%s: %s; --headless needs no window\n", what, reason);
    return CLI_IO;
}

/* SDL itself would end with a screen that nobody sees, and let Wayland's library complain on its way there. */
static bool window_display(void)
{
    if (SDL_getenv("SDL_VIDEODRIVER"))
        return SDL_Init(SDL_INIT_VIDEO) == 0;
    for (int i = 0; i < SDL_GetNumVideoDrivers(); i++) {
        const char *name = SDL_GetVideoDriver(i);
        if (strcmp(name, "offscreen") == 0 || strcmp(name, "dummy") == 0 || strcmp(name, "evdev") == 0 ||
            (strcmp(name, "wayland") == 0 && !SDL_getenv("XDG_RUNTIME_DIR")))
            continue;
        SDL_setenv("SDL_VIDEODRIVER", name, 1);
        if (SDL_Init(SDL_INIT_VIDEO) == 0)
            return true;
    }
    return false;
}

int window_open(struct window **out)
{
    struct window *w = *out = calloc(1, sizeof *w);
    if (!w) {
        fprintf(stderr, "window: out of memory\n");
        return CLI_IO;
    }
    SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1"); /* cli_catch_signals() has them */
    SDL_SetHint(SDL_HINT_VIDEO_ALLOW_SCREENSAVER, "1");
    SDL_SetHint(SDL_HINT_VIDEO_X11_NET_WM_BYPASS_COMPOSITOR, "0");
    SDL_SetHint(SDL_HINT_RENDER_SCALE_QUALITY, "nearest");
    if (!window_display())
        return window_problem("display", "none can be opened");
    w->window = SDL_CreateWindow("Glint", SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, WINDOW_WIDTH, WINDOW_HEIGHT,
                                 SDL_WINDOW_HIDDEN | SDL_WINDOW_RESIZABLE);
    SDL_StopTextInput(); /* which begins by itself: an input method would keep the letters, which are buttons here */
    /* without waiting for the screen, which for a covered window may be for ever */
    w->renderer = w->window ? SDL_CreateRenderer(w->window, -1, 0) : NULL;
    return w->renderer ? CLI_DONE : window_problem("window", SDL_GetError());
}

void window_close(struct window *w)
{
    if (!w)
        return;
    if (w->renderer)
        SDL_DestroyRenderer(w->renderer); /* and its textures */
    if (w->window)
        SDL_DestroyWindow(w->window);
    SDL_Quit();
    free(w->overlay.pixels);
    free(w);
}

static int window_key(SDL_Keycode code)
{
    static const struct {
        SDL_Keycode code;
        int key;
    } keys[] = {{SDLK_UP, CONTROLS_UP},
                {SDLK_DOWN, CONTROLS_DOWN},
                {SDLK_LEFT, CONTROLS_LEFT},
                {SDLK_RIGHT, CONTROLS_RIGHT},
                {SDLK_PAGEUP, CONTROLS_PAGE_UP},
                {SDLK_PAGEDOWN, CONTROLS_PAGE_DOWN},
                {SDLK_F1, CONTROLS_F1},
                {SDLK_F11, CONTROLS_F11},
                {SDLK_ESCAPE, CONTROLS_ESCAPE},
                {SDLK_KP_PLUS, '+'},
                {SDLK_KP_MINUS, '-'}};
    for (unsigned i = 0; i < sizeof keys / sizeof *keys; i++)
        if (keys[i].code == code)
            return keys[i].key;
    if (code >= SDLK_KP_1 && code <= SDLK_KP_6)
        return '1' + (code - SDLK_KP_1);
    return code < 128 ? code : 0;
}

static bool window_event(const SDL_Event *event, struct controls *controls)
{
    switch (event->type) {
    case SDL_QUIT:
        controls->quit = true;
        return false;
    case SDL_KEYDOWN:
        controls_press(controls, window_key(event->key.keysym.sym), event->key.keysym.mod & KMOD_SHIFT,
                       event->key.repeat);
        return true;
    case SDL_KEYUP:
        controls_release(controls, window_key(event->key.keysym.sym));
        return false;
    case SDL_WINDOWEVENT:
        if (event->window.event == SDL_WINDOWEVENT_FOCUS_LOST)
            controls_leave(controls);
        return true;
    default:
        return event->type == SDL_RENDER_TARGETS_RESET;
    }
}

bool window_keys(struct window *w, struct controls *controls, int wait_ms)
{
    SDL_Event event;
    bool changed = false;
    (void)w;
    /* SDL_WaitEventTimeout() wakes itself by messages that an X server may find when the window is gone: an error */
    if (wait_ms)
        SDL_Delay((uint32_t)wait_ms);
    while (SDL_PollEvent(&event))
        changed |= window_event(&event, controls);
    return changed;
}

void window_size(struct window *w, uint32_t width, uint32_t height, unsigned scale)
{
    SDL_Rect screen = {0, 0, 4096, 4096};
    SDL_GetDisplayUsableBounds(0, &screen);
    int wide = (int)width, high = (int)height, times = (int)scale;
    for (int n = 1; scale == 0 && n <= WINDOW_MAX; n++)
        if (n == 1 || (wide * n * 4 <= screen.w * 3 && high * n * 4 <= screen.h * 3 && wide * n <= 2 * WINDOW_WIDTH &&
                       high * n <= WINDOW_HEIGHT + WINDOW_HEIGHT / 4))
            times = n;
    SDL_RestoreWindow(w->window);
    SDL_SetWindowSize(w->window, wide * times, high * times);
    if (!w->shown) {
        SDL_SetWindowPosition(w->window, SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED);
        SDL_ShowWindow(w->window);
    }
    w->shown = true;
}

void window_fullscreen(struct window *w, bool fullscreen)
{
    SDL_SetWindowFullscreen(w->window, fullscreen ? SDL_WINDOW_FULLSCREEN_DESKTOP : 0);
}

void window_title(struct window *w, const char *title)
{
    SDL_SetWindowTitle(w->window, title);
}

static SDL_Texture *window_texture(struct window *w, int width, int height)
{
    return SDL_CreateTexture(w->renderer, SDL_PIXELFORMAT_ARGB8888, SDL_TEXTUREACCESS_STREAMING, width, height);
}

int window_picture(struct window *w, const struct frames_picture *p, unsigned rotation)
{
    int width = (int)pixels_width(p, rotation), height = (int)pixels_height(p, rotation), pitch;
    void *pixels;
    if (!w->picture || width != w->width || height != w->height) {
        if (w->picture)
            SDL_DestroyTexture(w->picture);
        w->picture = window_texture(w, width, height);
        w->width = width;
        w->height = height;
    }
    if (!w->picture || SDL_LockTexture(w->picture, NULL, &pixels, &pitch) != 0)
        return window_problem("window", SDL_GetError());
    pixels_turn(p, rotation, pixels, (size_t)pitch / sizeof(uint32_t));
    SDL_UnlockTexture(w->picture);
    return CLI_DONE;
}

void window_dim(struct window *w, bool dim)
{
    w->dim = dim;
}

void window_words(struct window *w, const struct overlay_text text[OVERLAY_PLACES])
{
    for (unsigned i = 0; i < OVERLAY_PLACES; i++)
        w->text[i] = text[i];
    if (w->words)
        SDL_DestroyTexture(w->words); /* drawn when it is wanted, in the size of then */
    w->words = NULL;
}

/* The words, of which a pixel is `letter` of the window's. False, and without any, if SDL cannot. */
static bool window_write(struct window *w, unsigned width, unsigned height)
{
    struct overlay *o = &w->overlay;
    if (!w->words || o->width != width || o->height != height) {
        if (w->words)
            SDL_DestroyTexture(w->words);
        free(o->pixels);
        *o = (struct overlay){calloc((size_t)width * height, sizeof *o->pixels), width, height};
        w->words = o->pixels ? window_texture(w, (int)width, (int)height) : NULL;
        if (!w->words)
            return false;
        for (unsigned i = 0; i < OVERLAY_PLACES; i++)
            overlay_draw(o, (enum overlay_place)i, &w->text[i]);
        if (SDL_SetTextureBlendMode(w->words, SDL_BLENDMODE_BLEND) != 0 ||
            SDL_UpdateTexture(w->words, NULL, o->pixels, (int)(width * sizeof *o->pixels)) != 0) {
            SDL_DestroyTexture(w->words);
            w->words = NULL;
        }
    }
    return w->words;
}

/* How large a pixel of words is: two where they fit, larger in a window that is large either way. */
static unsigned window_letter(unsigned width, unsigned height)
{
    unsigned columns = width / WINDOW_LETTERS, lines = height / WINDOW_LINES, most = height / WINDOW_LETTERS;
    unsigned letter = columns < lines ? columns : lines;
    most = most > 2 ? most : 2;
    letter = letter < most ? letter : most;
    return letter ? letter : 1;
}

/* Without showing it; false if something is not there. */
static bool window_paint(struct window *w, int *width, int *height)
{
    if (SDL_GetRendererOutputSize(w->renderer, width, height) != 0)
        return false;
    bool good = SDL_SetRenderDrawColor(w->renderer, 0, 0, 0, 255) == 0 && SDL_RenderClear(w->renderer) == 0;
    if (w->picture) {
        int times = *width / w->width < *height / w->height ? *width / w->width : *height / w->height;
        times = times > 1 ? times : 1;
        const SDL_Rect place = {(*width - w->width * times) / 2, (*height - w->height * times) / 2, w->width * times,
                                w->height * times};
        const uint8_t light = w->dim ? WINDOW_DIM : 255;
        good = SDL_SetTextureColorMod(w->picture, light, light, light) == 0 &&
               SDL_RenderCopy(w->renderer, w->picture, NULL, &place) == 0 && good;
    }
    unsigned wide = (unsigned)*width, high = (unsigned)*height, letter = window_letter(wide, high);
    const bool written = window_write(w, (wide + letter - 1) / letter, (high + letter - 1) / letter);
    const SDL_Rect place = {0, 0, (int)(w->overlay.width * letter), (int)(w->overlay.height * letter)};
    return written && SDL_RenderCopy(w->renderer, w->words, NULL, &place) == 0 && good;
}

void window_draw(struct window *w)
{
    int width, height;
    if (!w->shown || (SDL_GetWindowFlags(w->window) & (SDL_WINDOW_HIDDEN | SDL_WINDOW_MINIMIZED)))
        return;
    window_paint(w, &width, &height); /* of what is not there now, the next time */
    SDL_RenderPresent(w->renderer);
}

int window_save(struct window *w, const char *path)
{
    int width, height;
    if (!window_paint(w, &width, &height))
        return window_problem(path, SDL_GetError());
    uint8_t *pixels = malloc((size_t)width * (size_t)height * 3);
    if (!pixels ? SDL_OutOfMemory()
                : SDL_RenderReadPixels(w->renderer, NULL, SDL_PIXELFORMAT_RGB24, pixels, width * 3)) {
        free(pixels);
        return window_problem(path, SDL_GetError());
    }
    const struct frames_picture picture = {
        .pixels = pixels, .width = (uint16_t)width, .height = (uint16_t)height, .format = STREAM_RGB888};
    int code = dump_file(path, &picture);
    free(pixels);
    return code;
}
#endif
