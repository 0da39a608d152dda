/* SPDX-License-Identifier: MIT */
/*
 * What a command line tool asks of C, POSIX and zlib, through one seam: the linker's --wrap (FAULTS_WRAPS in seams.mk)
 * leads our objects' calls here, libpng and jansson allocate by functions of ours, and every stream is one of
 * fopencookie(), so that what stdio reads and writes by itself, while flushing or closing, can fail as well. What only
 * takes back (free, close, unlink, rmdir, waitpid) is not made to fail; nor is what assimp does by itself.
 */
#ifndef WRAPS_H
#define WRAPS_H

#include "tests/faults/seam.h"

#include <stddef.h>

extern struct seam *wraps_seam; /* null: nothing is counted */

/* From here on, in this process and its children; standard output too. Input comes, and output goes, in halves of what
 * is asked for if `halves`. */
void wraps_begin(struct seam *seam, bool halves);

#endif
