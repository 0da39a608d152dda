/* SPDX-License-Identifier: MIT */
/* Pictures to a file or pipe as a device sends them: firmware/stream with the heap's memory. */
#ifndef STREAMER_H
#define STREAMER_H

#include "glint/renderer.h"
#include "host/sink.h"
#include "stream/stream.h"

#include <stdbool.h>

struct streamer {
    struct hal_display display; /* flush alone: the frame is begun and ended by the functions here */
    const char *path;           /* "-": standard output. Set before opening */
    uint32_t key_every;         /* a key frame in so many; 0: the first alone. Set before opening */
    struct stream stream;
    struct sink sink;
    double pack_ms; /* of the frame under way */
    bool open;
};

/* Exit codes, with a message. From opening on signals are caught (cli.h). `scene` names the one scene of hello. */
int streamer_open(struct streamer *streamer, const struct renderer *renderer, const char *scene);
/* The stream's clock is the animation's: it is shown and recorded as fast as that runs, however fast it was drawn. */
int streamer_begin(struct streamer *streamer, const struct renderer *renderer, uint32_t index, uint32_t moment_ms);
int streamer_end(struct streamer *streamer, const struct renderer *renderer, double draw_ms);

/* What a call of `display` returned, as an exit code with a message. */
int streamer_step(struct streamer *streamer, int result);

/* Harmless when not open. */
int streamer_close(struct streamer *streamer, bool keep);

#endif
