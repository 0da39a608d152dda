/* SPDX-License-Identifier: MIT */
#include "report/gnuplot.h"

#include "glint/cli.h"
#include "scene/model.h"

#include <errno.h>
#include <fcntl.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#define GNUPLOT_MISSING 127 /* as a shell says it */

static int gnuplot_fail(const char *reason)
{
    fprintf(stderr, "gnuplot: %s\n", reason);
    return CLI_IO;
}

/* In the child. What gnuplot complains of is not shown: the message is the caller's. */
static void gnuplot_become(int script, int output)
{
    int nothing = open("/dev/null", O_WRONLY);
    if (nothing < 0 || dup2(script, 0) < 0 || dup2(output, 1) < 0 || dup2(nothing, 2) < 0)
        _exit(GNUPLOT_MISSING);
    execlp("gnuplot", "gnuplot", "-", (char *)NULL);
    _exit(GNUPLOT_MISSING);
}

/* All that comes from a descriptor, as a string from malloc. */
static char *gnuplot_read(int file)
{
    size_t size = 0, room = 1 << 16;
    char *text = model_alloc(room);
    ssize_t got;
    while ((got = read(file, text + size, room - size - 1)) > 0 || (got < 0 && errno == EINTR)) {
        size += got > 0 ? (size_t)got : 0;
        if (size + 1 < room)
            continue;
        char *more = model_alloc(room *= 2);
        memcpy(more, text, size);
        free(text);
        text = more;
    }
    text[size] = 0;
    return text;
}

/* Length of what a picture is the same without: a group that holds nothing, or white space after a line's end. */
static size_t gnuplot_waste(const char *text)
{
    static const char space[] = "\n\t ", close[] = "</g>";
    if (*text == '\n')
        return strspn(text, space);
    const char *end = strncmp(text, "<g ", 3) == 0 ? strchr(text, '>') : NULL;
    if (!end)
        return 0;
    end += 1 + strspn(end + 1, space);
    return strncmp(end, close, strlen(close)) == 0 ? (size_t)(end - text) + strlen(close) : 0;
}

/* The text less waste, with `prefix` at the start of each id and of each reference to one. */
static void gnuplot_rename(FILE *out, const char *text, const char *prefix)
{
    static const char *const marks[] = {" id='", " id=\"", "href='#", "url(#"};
    while (*text) {
        size_t length = gnuplot_waste(text);
        if (length) {
            fputs(*text == '\n' ? "\n" : "", out);
            text += length;
            continue;
        }
        for (size_t i = 0; i < sizeof marks / sizeof *marks && !length; i++)
            if (strncmp(text, marks[i], strlen(marks[i])) == 0)
                length = strlen(marks[i]);
        fwrite(text, 1, length ? length : 1, out);
        if (length)
            fputs(prefix, out);
        text += length ? length : 1;
    }
}

static int gnuplot_copy(char *text, FILE *out, const char *prefix)
{
    char *svg = strstr(text, "<svg"), *title = strstr(text, "<title>"), *end = strstr(text, "</desc>");
    if (!svg || !strstr(text, "</svg>") || !title || !end || title < svg || end < title)
        return gnuplot_fail("what it prints is no SVG");
    *title = 0;
    gnuplot_rename(out, svg, prefix);
    gnuplot_rename(out, end + strlen("</desc>"), prefix);
    return CLI_DONE;
}

int gnuplot_run(FILE *script, FILE *out, const char *prefix)
{
    int ends[2], status = 0;
    if (fflush(script) != 0 || fflush(out) != 0 || lseek(fileno(script), 0, SEEK_SET) != 0 || pipe(ends) != 0)
        return gnuplot_fail(strerror(errno));
    pid_t child = fork();
    if (child == 0)
        gnuplot_become(fileno(script), ends[1]);
    close(ends[1]);
    char *text = child > 0 ? gnuplot_read(ends[0]) : NULL;
    close(ends[0]);
    if (child < 0)
        return gnuplot_fail(strerror(errno));
    while (waitpid(child, &status, 0) < 0 && errno == EINTR)
        ;
    int code = CLI_IO;
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0)
        code = gnuplot_copy(text, out, prefix);
    else if (WIFEXITED(status) && WEXITSTATUS(status) == GNUPLOT_MISSING)
        gnuplot_fail("not found: it draws the plots");
    else
        gnuplot_fail("it does not take the plot's script");
    free(text);
    return code;
}
