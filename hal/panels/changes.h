/* SPDX-License-Identifier: MIT */
/* What the panel shows, remembered to the extent that the memory allows. */
#ifndef HAL_PANELS_CHANGES_H
#define HAL_PANELS_CHANGES_H

#include "panels/panel.h"

/* Whether this row of the picture is to be sent; remembers it. */
int changes_row(struct panel *panel, const void *row, uint32_t y);

/* The checksum: 32 bits of `bytes` bytes, the same at any alignment. Not against malice. */
uint32_t changes_sum(const void *row, uint32_t bytes);

#endif
