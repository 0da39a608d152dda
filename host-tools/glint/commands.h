/* SPDX-License-Identifier: MIT */
/* The subcommands. Each takes the arguments from its own name on and returns the exit code: enum cli_exit. */
#ifndef COMMANDS_H
#define COMMANDS_H

#define GLINT_VERSION "0.1.0"

int cmd_render(int argc, char **argv);
int cmd_pack(int argc, char **argv);
int cmd_reference(int argc, char **argv);
int cmd_compare(int argc, char **argv);
int cmd_info(int argc, char **argv);
int cmd_methods(int argc, char **argv);
int cmd_demo(int argc, char **argv);
int cmd_report(int argc, char **argv);
int cmd_curve(int argc, char **argv);

#endif
