/* SPDX-License-Identifier: MIT */
/* What the subcommands share: exit codes, and option values read strictly. */
#ifndef CLI_H
#define CLI_H

#include "pack/pack.h"

#include <stdbool.h>
#include <stdint.h>

enum cli_exit { CLI_DONE = PACK_OK, CLI_BAD_DATA = PACK_BAD_DATA, CLI_BAD_USAGE = PACK_BAD_USAGE, CLI_IO = PACK_IO };

/* Prints `command: ...; try 'command --help'` on stderr and returns CLI_BAD_USAGE. */
__attribute__((format(printf, 2, 3))) int cli_usage(const char *command, const char *format, ...);

/* The same for a value that the option `name` does not take: prints what `help` says of that option. */
int cli_refuse(const char *command, const char *help, const char *name, const char *value);

/* A whole number in low..high, a decimal fraction as 1..255 of 256, a decimal number up to 255 in Q8, or WIDTHxHEIGHT
 * with both in 1..GLINT_MAX_SIZE. The outputs change only on success. A turn is two angles in degrees, decimal, each at
 * most 360 either way, apart by a comma: to 1/65536 turns. */
bool cli_number(const char *text, uint32_t low, uint32_t high, uint32_t *value);
bool cli_fraction(const char *text, uint8_t *value);
bool cli_budget(const char *text, uint16_t *value);
bool cli_size(const char *text, uint16_t *width, uint16_t *height);
bool cli_turn(const char *text, uint16_t *yaw, uint16_t *pitch);

/* The index of `text` in names[count], or -1. */
int cli_choice(const char *text, const char *const names[], int count);

/* The names of enum glint_format, in its order. */
extern const char *const cli_formats[];

/* Those of enum glint_texture. */
extern const char *const cli_textures[];

/* From now on SIGINT, SIGTERM, SIGHUP and SIGQUIT only set what cli_interrupted() returns, the signal's number, so that
 * work under way can take back what it has written. To be called before a file is opened for writing, and not long
 * before: until then a signal ends the program at once. */
void cli_catch_signals(void);
int cli_interrupted(void);

/* Milliseconds of an arbitrary origin, steady. */
double cli_clock(void);

#endif
