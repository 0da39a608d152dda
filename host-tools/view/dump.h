/* SPDX-License-Identifier: MIT */
/* A picture of a stream as DIR/frame-0000.png. */
#ifndef VIEW_DUMP_H
#define VIEW_DUMP_H

#include "view/frames.h"

/* Makes the folder if it is not there: an exit code, with a message. */
int dump_folder(const char *folder);

/* The file is there whole or not at all. */
int dump_picture(const char *folder, uint32_t index, const struct frames_picture *picture);

#endif
