/* SPDX-License-Identifier: MIT */
/*
 * A list of frame hashes, as `glint render --hash` prints it and `--expect` reads it: one line a frame,
 *
 *     <index> <hash>
 *
 * index counting from 0 in decimal, hash the CRC-32 of the frame's bytes, top row first, in 8 lower-case hexadecimal
 * digits. In a file, empty lines and what follows a '#' are left out.
 */
#ifndef HASHES_H
#define HASHES_H

#include <stddef.h>
#include <stdint.h>

struct hashes_entry {
    uint32_t hash;
    unsigned line; /* of the file, for messages */
};

struct hashes {
    const char *path;
    struct hashes_entry *entry;
    size_t count;
};

/* Reads a list: an exit code; after an error, one line has been printed and there is nothing to free. */
int hashes_read(const char *path, struct hashes *hashes);

/* Compares frame `index` with the list: CLI_DONE, or CLI_BAD_DATA and a message that names the frame. */
int hashes_check(const struct hashes *hashes, uint32_t index, uint32_t hash);

/* The same for the number of frames, before they are drawn. */
int hashes_check_count(const struct hashes *hashes, uint32_t frames);

void hashes_free(struct hashes *hashes);

#endif
