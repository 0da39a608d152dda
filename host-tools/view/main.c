/* SPDX-License-Identifier: MIT */
/* glint-view: the pictures of a stream. */
#include "glint/cli.h"
#include "view/session.h"

#include <signal.h>
#include <stdio.h>

int main(int argc, char **argv)
{
    static struct session session;
    struct options options;
    signal(SIGPIPE, SIG_IGN);
    int code = options_parse(&options, argc, argv);
    if (code < 0)
        code = options.list ? port_list() : session_run(&session, &options);
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
