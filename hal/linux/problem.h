/* SPDX-License-Identifier: MIT */
/* Why something of the machine's does not work, told to the user: one line on standard error. */
#ifndef HAL_LINUX_PROBLEM_H
#define HAL_LINUX_PROBLEM_H

struct problem {
    char text[240]; /* empty: none */
};

/* Tells a problem, unless there is one already: what comes of it is no news. Whoever sees that it is over empties the
 * text. Returns HAL_E_IO. */
__attribute__((format(printf, 2, 3))) int problem_set(struct problem *problem, const char *format, ...);

#endif
