/* SPDX-License-Identifier: MIT */
/* What is said on standard output or standard error, heard by a test. Include after cmocka.h. */
#ifndef LISTEN_H
#define LISTEN_H

#include <stdio.h>
#include <unistd.h>

struct listen {
    int stream, was;
    FILE *file;
};

/* From here on nothing goes to `stream`, STDOUT_FILENO or STDERR_FILENO. */
static inline struct listen listen_begin(int stream)
{
    struct listen l = {stream, dup(stream), tmpfile()};
    assert_true(l.was >= 0 && l.file);
    fflush(NULL);
    assert_int_equal(dup2(fileno(l.file), stream), stream);
    return l;
}

/* As before; said[room] is what there was to hear, cut off if it has no room. */
static inline void listen_end(const struct listen *l, char *said, size_t room)
{
    fflush(NULL);
    assert_int_equal(dup2(l->was, l->stream), l->stream);
    close(l->was);
    rewind(l->file);
    said[fread(said, 1, room - 1, l->file)] = 0;
    fclose(l->file);
}

#endif
