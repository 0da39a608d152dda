/* SPDX-License-Identifier: MIT */
/* glint-view: the pictures of a stream. */
#include "glint/cli.h"
#include "view/session.h"

#include <signal.h>
#include <stdio.h>
#include <stdlib.h>

static struct session main_session;

/* An X server that goes ends the program, by exit() from within SDL. */
static void main_leave(void)
{
    session_keep(&main_session);
}

int main(int argc, char **argv)
{
    struct options options;
    atexit(main_leave);
    signal(SIGPIPE, SIG_IGN);
    int code = options_parse(&options, argc, argv);
    if (code < 0)
        code = options.list ? port_list() : session_run(&main_session, &options);
    if (cli_interrupted()) { /* the caller sees by what */
        signal(cli_interrupted(), SIG_DFL);
        raise(cli_interrupted());
    }
    if ((fflush(stdout) != 0 || ferror(stdout)) && code == CLI_DONE) {
        fprintf(stderr, "standard output: cannot be written\n");
        code = CLI_IO;
    }
    return code;
}
