/* SPDX-License-Identifier: MIT */
#include "report/boards.h"

#include "glint/cli.h"
#include "report/csv.h"

#include <string.h>

#define COUNT(array) (sizeof(array) / sizeof *(array))

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
static const char *boards_take(void *context, char *field[CSV_FIELDS], unsigned line)
{
    struct boards *boards = context;
    char board[sizeof boards->board], what[sizeof boards->what], unit[32];
    uint32_t number;
    const char *problem = csv_name(board, sizeof board, field[0], " -");
    (void)line;
    if (!problem)
        problem = csv_name(what, sizeof what, field[1], " -");
    if (!problem)
        problem = csv_name(unit, sizeof unit, field[3], " -");
    if (problem)
        return problem;
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

/* After the last line. */
static const char *boards_end(void *context)
{
    const struct boards *boards = context;
    return boards->next || !boards->kind ? "figures are missing at its end" : NULL;
}

int boards_write(FILE *out, const char *path)
{
    struct boards boards = {.out = out};
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
    int code = csv_read(path, boards_head, boards_take, boards_end, &boards);
    fprintf(out, "%s", boards.kind ? "</table></div>\n" : "");
    return code;
}
