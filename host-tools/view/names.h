/* SPDX-License-Identifier: MIT */
/* What a device is and offers, from its hello. */
#ifndef VIEW_NAMES_H
#define VIEW_NAMES_H

#include "stream/protocol.h"

enum names_list { NAMES_SCENES, NAMES_METHODS, NAMES_LISTS };

struct names {
    char text[STREAM_MAX_NAMES]; /* the board's, then the lists' as hello has them */
    uint32_t length;             /* 0: no hello so far */
};

/* Hello's payload, which ends with a zero byte. */
void names_set(struct names *names, const char *text, uint32_t length);

/* The name at a place of a list, or null. */
const char *names_at(const struct names *names, enum names_list list, uint32_t index);

uint32_t names_count(const struct names *names, enum names_list list);

/* The place of a name, or that behind the last. */
uint32_t names_find(const struct names *names, enum names_list list, const char *name);

/* Lines for standard output: board, scenes, methods. */
void names_print(const struct names *names);

#endif
