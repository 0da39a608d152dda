/* SPDX-License-Identifier: MIT */
/*
 * A measuring program that runs alike on the desktop and on a bare board: program_host.c or program_device.c starts it
 * and takes its lines.
 */
#ifndef PROGRAM_H
#define PROGRAM_H

#include "app/program_scene.h"
#include "glint.h"

#define PROGRAM_ARGUMENTS 8

/* The program: argv[0] is its name. Returns the exit code. */
int program_main(int argc, char **argv);

/* Writes a text on standard output. */
void program_write(const char *text);

/* Instructions counted since program_count_start(), or 0 where the machine counts none. */
void program_count_start(void);
uint32_t program_count(void);

/* A line under construction; what does not fit is cut off. */
struct line {
    char text[160];
    unsigned length;
};

void line_text(struct line *line, const char *text);
void line_decimal(struct line *line, uint32_t value);
void line_hex(struct line *line, uint32_t value);
void line_end(struct line *line); /* writes it and begins anew */

int text_equal(const char *a, const char *b);
/* The decimal number in text, or 0. */
uint32_t text_number(const char *text);

#endif
