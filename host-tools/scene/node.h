/* SPDX-License-Identifier: MIT */
/*
 * Typed reading of JSON with messages that say where: `scene.json: objects[0].mesh: no mesh named "foo"`.
 *
 * Errors are sticky: the first is printed, later ones are silent, and every reader then returns its fallback, so a
 * caller reads straight on and looks at `failed` once at the end. Ranges are closed. A fallback is for an absent
 * member; one of NAN (or a null string) makes the member required.
 */
#ifndef NODE_H
#define NODE_H

#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>

struct node_file {
    const char *path;
    json_t *root;
    bool failed;
};

/* A value and the way to it. The chain of parents lives on the callers' stacks. */
struct node {
    struct node_file *file;
    const struct node *parent;
    const char *key; /* null: `index` into an array, or the root */
    size_t index;
    json_t *value; /* null: absent */
};

/* Parses a file: an exit code, and if it is not 0, `path:line: reason` or `path: reason` has been printed. Nothing that
 * jansson allocates from here on is null (model_alloc()). */
int node_open(struct node_file *file, const char *path, struct node *root);
void node_close(struct node_file *file);

/* Prints `path: way.to.it: message`, if nothing has failed before. */
__attribute__((format(printf, 2, 3))) void node_fail(const struct node *node, const char *format, ...);

/* Fails unless the node is an object all of whose members are in the space-separated list. */
void node_object(const struct node *node, const char *members);
struct node node_member(const struct node *object, const char *key);
struct node node_item(const struct node *array, size_t index);
/* Elements of an array of `least` to `most` elements; 0 if absent. */
size_t node_length(const struct node *array, size_t least, size_t most);

double node_number(const struct node *node, double least, double most, double fallback);
unsigned node_integer(const struct node *node, unsigned least, unsigned most, double fallback);
bool node_bool(const struct node *node, bool fallback);
const char *node_string(const struct node *node, const char *fallback);
/* The index of the string in a space-separated list of choices. */
int node_choice(const struct node *node, const char *choices, int fallback);
/* An array of exactly `count` numbers; out is left alone if absent. */
void node_vector(const struct node *node, double *out, size_t count, double least, double most);

/* Short forms for a member of an object. */
double node_member_number(const struct node *object, const char *key, double least, double most, double fallback);
unsigned node_member_integer(const struct node *object, const char *key, unsigned least, unsigned most,
                             double fallback);
int node_member_choice(const struct node *object, const char *key, const char *choices, int fallback);
void node_member_vector(const struct node *object, const char *key, double *out, size_t count, double least,
                        double most);

#endif
