/* SPDX-License-Identifier: MIT */
/* Reads CSV files of our own making: a known head, no quotes. */
#ifndef CSV_H
#define CSV_H

#include <stddef.h>

#define CSV_FIELDS 8

/* Takes a line's fields, in place and as many as the head has, or returns why they will not do. */
typedef const char *csv_take(void *context, char *field[CSV_FIELDS], unsigned line);

/* Gives each line after `head` to `take`; `end`, unless null, says after the last what is missing. Returns the exit
 * code of the command line, 0, 1 or 3; whenever it is not 0, one line `path:line: reason` or `path: reason` has been
 * printed on stderr. */
int csv_read(const char *path, const char *head, csv_take *take, const char *(*end)(void *context), void *context);

/* Copies a name that is neither empty nor too long, of letters, digits and `more`: such stand in a page as they are.
 * Null, or what is wrong with it. */
const char *csv_name(char *out, size_t size, const char *text, const char *more);

#endif
