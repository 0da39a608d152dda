/* SPDX-License-Identifier: MIT */
#include "report/csv.h"

#include "glint/cli.h"

#include <ctype.h>
#include <errno.h>
#include <stdio.h>
#include <string.h>

#define CSV_LINE 256

/* Splits at commas; the number of fields, or CSV_FIELDS + 1 if there are more. */
static unsigned csv_split(char *text, char *field[CSV_FIELDS])
{
    unsigned count = 0;
    while (text && count < CSV_FIELDS) {
        field[count++] = text;
        text = strchr(text, ',');
        if (text)
            *text++ = 0;
    }
    return text ? CSV_FIELDS + 1 : count;
}

static const char *csv_line(char *text, unsigned line, const char *head, csv_take *take, void *context)
{
    char *field[CSV_FIELDS], *end = strchr(text, '\n');
    unsigned wanted = 1;
    if (!end)
        return "no end of line: cut short, or longer than 254 characters";
    *end = 0;
    if (line == 1)
        return strcmp(text, head) == 0 ? NULL : head; /* says what belongs there */
    for (const char *c = head; *c; c++)
        wanted += *c == ',';
    return csv_split(text, field) == wanted ? take(context, field, line) : head;
}

int csv_read(const char *path, const char *head, csv_take *take, const char *(*end)(void *context), void *context)
{
    char text[CSV_LINE];
    const char *problem = NULL;
    unsigned line = 0;
    errno = 0;
    FILE *file = fopen(path, "r");
    while (file && !problem && fgets(text, sizeof text, file))
        problem = csv_line(text, ++line, head, take, context);
    if (!file || ferror(file)) { /* a directory opens, but does not read */
        fprintf(stderr, "%s: %s\n", path, strerror(errno));
        if (file)
            fclose(file);
        return CLI_IO;
    }
    fclose(file);
    if (!line) {
        fprintf(stderr, "%s: empty\n", path);
        return CLI_BAD_DATA;
    }
    if (!problem && end)
        problem = end(context);
    if (problem)
        fprintf(stderr, "%s:%u: %s%s\n", path, line, problem == head ? "the columns are " : "", problem);
    return problem ? CLI_BAD_DATA : CLI_DONE;
}

const char *csv_name(char *out, size_t size, const char *text, const char *more)
{
    size_t length = strlen(text);
    for (const char *c = text; *c; c++)
        if (!isalnum((unsigned char)*c) && !strchr(more, *c))
            return "a name has other characters than letters, digits, space, - and _";
    if (length == 0 || length >= size)
        return "a name is empty or too long";
    memcpy(out, text, length + 1);
    return NULL;
}
