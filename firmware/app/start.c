/* SPDX-License-Identifier: MIT */
/* Where there is nobody to say how to begin. */
#include "app/app.h"

int main(void)
{
    struct app_start start;
    app_usual(&start);
    return app_run(board_start(), &start);
}
