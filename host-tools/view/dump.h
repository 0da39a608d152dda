/* SPDX-License-Identifier: MIT */
/* A picture of a stream as DIR/frame-0000.png. */
#ifndef VIEW_DUMP_H
#define VIEW_DUMP_H

#include "view/frames.h"

/* Makes the folder if it is not there: an exit code, with a message. */
int dump_folder(const char *folder);

/* The files are there whole or not at all. */
int dump_picture(const char *folder, uint32_t index, const struct frames_picture *picture);
int dump_file(const char *path, const struct frames_picture *picture);

/* The first of `kind`-0000.png, -0001 and so on that is not there; an empty name if there are all ten thousand. */
#define DUMP_NAME 32
void dump_name(char name[DUMP_NAME], const char *kind);

#endif
