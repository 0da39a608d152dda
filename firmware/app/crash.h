/* SPDX-License-Identifier: MIT */
/* What a program that failed says on its display when it has started anew (hal/cortexm/fault.h). */
#ifndef APP_CRASH_H
#define APP_CRASH_H

#include "boards/board.h"

/* If the last start ended in a fault: shows it on the board's display, which is open, until a button is pressed and
 * released. */
void crash_show(const struct board *board);

#endif
