/* SPDX-License-Identifier: MIT */
/* Text from a device on the user's terminal. */
#ifndef VIEW_WORDS_H
#define VIEW_WORDS_H

#include <stddef.h>
#include <stdio.h>

/* Writes UTF-8 with a question mark for what a terminal would obey: control characters, C0 and C1, also as bare bytes.
 */
void words_put(FILE *out, const char *text, size_t length);

#endif
