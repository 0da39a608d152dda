/* SPDX-License-Identifier: MIT */
/* Where there is nobody to say how to begin. */
#include "app/app.h"

int main(void)
{
    return app_run(board_start(), &(const struct app_start){0});
}
