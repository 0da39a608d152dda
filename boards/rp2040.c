/* SPDX-License-Identifier: MIT */
#include "boards/rp2040.h"

const struct board *board_start(void)
{
    rp2040_start();
    rp2040_panel.bus = rp2040_bus();
    return &rp2040_app;
}
