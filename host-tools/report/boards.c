/* SPDX-License-Identifier: MIT */
#include "report/boards.h"

#include "glint/cli.h"

#include <errno.h>
#include <string.h>

#define BOARDS_LINE   256
#define BOARDS_FIELDS 5
#define COUNT(array)  (sizeof(array) / sizeof *(array))

/* Figures of a row, in their order in the file. */
struct boards_kind {
    const char *unit; /* of its figures that are no bytes; null: millions of the first one's, or bytes */
    const char *const (*figures)[2];
    unsigned count;
};

static const char *const boards_program[][2] = {
    {"flash", "flash, all methods"}, {"flash_x", "x alone"}, {"static", "static RAM"},     {"bands", "bands in it"},
    {"renderer", "renderer\u2019s"}, {"stack", "stack"},     {"stack_used", "of it used"},
};
static const char *const boards_picture[][2] = {
    {"drawn", "drawn"},
    {"whole", "and sent whole"},
    {"row", "one of many in a row"},
    {"changes", "and its changes sent"},
    {"bytes", "bytes"},
    {"bytes_changes", "bytes of changes"},
};
static const char *const boards_speed[][2] = {
    {"real", "a picture"},       {"user", "of it in the program"},
    {"system", "in the kernel"}, {"cpu", "CPU, %"},
    {"bytes", "bytes"},          {"wire", "whole on a real panel\u2019s wire"},
};
static const struct boards_kind boards_kinds[] = {
    {"bytes", boards_program, COUNT(boards_program)},
    {NULL, boards_picture, COUNT(boards_picture)},
    {"ms", boards_speed, COUNT(boards_speed)},
};

static const char boards_head[] = "board,what,figure,unit,number";

struct boards {
    FILE *out;
    const struct boards_kind *kind; /* of the table under way, or null */
    char board[64], what[128];      /* of the row under way */
    unsigned next;                  /* figure of it; 0: none is under way */
};

/* Names stand in the page as they are. */
static bool boards_name(const char *text, size_t size)
{
    size_t length = strlen(text);
    return length && length < size && strspn(text, "abcdefghijklmnopqrstuvwxyz0123456789- ") == length;
}

static void boards_row(struct boards *boards, const char *board, const char *what, const char *unit)
{
    const struct boards_kind *kind = &boards_kinds[strcmp(what, "program") == 0 ? 0 : strcmp(unit, "us") == 0 ? 2 : 1];
    if (kind != boards->kind || strcmp(board, boards->board) != 0) {
        fprintf(boards->out, "%s<div class=\"wide\"><table>\n<tr><th>%s, %s%s</th>",
                boards->kind ? "</table></div>\n" : "", board, kind->unit ? "" : "million ",
                kind->unit ? kind->unit : unit);
        for (unsigned i = 0; i < kind->count; i++)
            fprintf(boards->out, "<th>%s</th>", kind->figures[i][1]);
        fprintf(boards->out, "</tr>\n");
    }
    boards->kind = kind;
    strcpy(boards->board, board);
    strcpy(boards->what, what);
    fprintf(boards->out, "<tr><td>%s</td>", what);
}

/* A figure, in its row; or why it will not do. */
static const char *boards_take(struct boards *boards, char *field[BOARDS_FIELDS])
{
    uint32_t number;
    if (!boards_name(field[0], sizeof boards->board) || !boards_name(field[1], sizeof boards->what) ||
        !boards_name(field[3], 32))
        return "a name is empty, too long, or has other letters than a-z, 0-9, space and -";
    if (!cli_number(field[4], 0, UINT32_MAX, &number))
        return "the number is none";
    if (!boards->next)
        boards_row(boards, field[0], field[1], field[3]);
    else if (strcmp(boards->board, field[0]) != 0 || strcmp(boards->what, field[1]) != 0)
        return "the row before has too few figures";
    if (strcmp(field[2], boards->kind->figures[boards->next][0]) != 0)
        return "not the figure that comes next";
    if (strcmp(field[3], "us") == 0)
        fprintf(boards->out, "<td>%.1f</td>", number / 1e3);
    else if (strcmp(field[3], "bytes") == 0 || strcmp(field[3], "percent") == 0)
        fprintf(boards->out, "<td>%u</td>", (unsigned)number);
    else
        fprintf(boards->out, "<td>%.2f</td>", number / 1e6);
    if (++boards->next == boards->kind->count) {
        fprintf(boards->out, "</tr>\n");
        boards->next = 0;
    }
    return NULL;
}

static const char *boards_line(struct boards *boards, char *text, unsigned line)
{
    char *field[BOARDS_FIELDS], *at = text, *end = strchr(text, '\n');
    if (!end)
        return "no end of line: cut short, or longer than 254 characters";
    *end = 0;
    if (line == 1)
        return strcmp(text, boards_head) == 0 ? NULL : boards_head;
    for (unsigned i = 0; i < BOARDS_FIELDS; i++) {
        char *comma = strchr(at, ',');
        if ((comma == NULL) != (i == BOARDS_FIELDS - 1))
            return boards_head;
        field[i] = at;
        if (comma)
            *comma = 0, at = comma + 1;
    }
    return boards_take(boards, field);
}

int boards_write(FILE *out, const char *path)
{
    struct boards boards = {.out = out};
    char text[BOARDS_LINE];
    const char *problem = NULL;
    unsigned line = 0;
    fprintf(
        out,
        "<h2 id=\"boards\">On boards</h2>\n"
        "<p>The handhelds\u2019 program on emulated boards: a picture drawn by one core, or two; drawn and sent to the "
        "panel whole; one of many that follow each other; and the one 50 ms later, of which only the rows that changed "
        "are sent. Instructions are counted by "
        "QEMU, where sending costs what the core does for it and no waiting; cycles by rp2040js, without waits for "
        "flash. Flash is the program\u2019s without its scenes. Under "
        "Linux, time is the guest\u2019s, an instruction a nanosecond, and its CPU makes the bits of the emulated wire "
        "itself.</p>\n");
    errno = 0;
    FILE *file = fopen(path, "r");
    while (file && !problem && fgets(text, sizeof text, file))
        problem = boards_line(&boards, text, ++line);
    if (!file || ferror(file)) { /* a directory opens, but does not read */
        fprintf(stderr, "%s: %s\n", path, strerror(errno));
        if (file)
            fclose(file);
        return CLI_IO;
    }
    fclose(file);
    fprintf(out, "%s", boards.kind ? "</table></div>\n" : "");
    if (!problem && (boards.next || !boards.kind))
        problem = "figures are missing at its end";
    if (problem)
        fprintf(stderr, "%s:%u: %s%s\n", path, line, problem == boards_head ? "the columns are " : "", problem);
    return problem ? CLI_BAD_DATA : CLI_DONE;
}
