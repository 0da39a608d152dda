/* SPDX-License-Identifier: MIT */
#include "scene/node.h"

#include "scene/model.h"

#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Without memory it would say that the file is malformed. */
static json_t *parse(FILE *file, json_error_t *error)
{
    json_set_alloc_funcs(model_alloc, free);
    return json_loadf(file, JSON_REJECT_DUPLICATES, error);
}

/* Names come back in messages: to a terminal, and a line each. What that would obey is U+0080 to U+009F as well. */
static char *find_control(char *text)
{
    unsigned char *at = (unsigned char *)text;
    while (*at >= ' ' && *at != 0x7f && !(at[0] == 0xc2 && at[1] < 0xa0))
        at++;
    return *at ? (char *)at : NULL;
}

static bool is_legible(const char *text)
{
    return !find_control((char *)(uintptr_t)text);
}

/* All strings and keys; nested as deep as jansson lets them, 2048. */
static bool are_legible(json_t *value)
{
    bool good = !json_is_string(value) || is_legible(json_string_value(value));
    const char *key;
    json_t *element;
    size_t i;
    json_object_foreach(value, key, element) good = good && is_legible(key) && are_legible(element);
    json_array_foreach(value, i, element) good = good && are_legible(element);
    return good;
}

int node_open(struct node_file *file, const char *path, struct node *root)
{
    json_error_t error;
    FILE *stream = fopen(path, "rb");
    *file = (struct node_file){.path = path, .root = stream ? parse(stream, &error) : NULL};
    *root = (struct node){.file = file, .value = file->root};
    const bool unread = !stream || ferror(stream);
    if (unread) {
        fprintf(stderr, "%s: %s\n", path, strerror(errno));
        node_close(file);
    } else if (!file->root) {
        for (char *at = error.text; (at = find_control(at));) /* it quotes the file, which may not be text */
            *at = '?';
        fprintf(stderr, "%s:%d: %s\n", path, error.line > 0 ? error.line : 1, error.text);
    } else if (!are_legible(file->root)) {
        fprintf(stderr, "%s: a name or text has a control character\n", path);
        node_close(file);
    }
    if (stream)
        fclose(stream);
    file->failed = !file->root;
    return unread ? 3 : file->failed;
}

void node_close(struct node_file *file)
{
    json_decref(file->root);
    file->root = NULL;
}

/* The way from the root: the chain is turned round by printing from its far end. JSON nests at most 2048 deep, the
 * chain only as deep as a scene's own structure. */
static void print_way(const struct node *node)
{
    if (!node->parent)
        return;
    print_way(node->parent);
    if (node->key)
        fprintf(stderr, "%s%s", node->parent->parent ? "." : "", node->key);
    else
        fprintf(stderr, "[%zu]", node->index);
}

void node_fail(const struct node *node, const char *format, ...)
{
    if (node->file->failed)
        return;
    node->file->failed = true;
    fprintf(stderr, "%s: ", node->file->path);
    print_way(node);
    if (node->parent)
        fputs(": ", stderr);
    va_list arguments;
    va_start(arguments, format);
    vfprintf(stderr, format, arguments);
    va_end(arguments);
    fputc('\n', stderr);
}

/* Index of a word of `length` letters in a space-separated list, or -1. */
static int find_word(const char *list, const char *word)
{
    size_t length = strlen(word);
    for (int index = 0; *list; index++) {
        size_t here = strcspn(list, " ");
        if (here == length && !strncmp(list, word, length))
            return index;
        list += here + (list[here] == ' ');
    }
    return -1;
}

void node_object(const struct node *node, const char *members)
{
    const char *key;
    json_t *value;
    if (!json_is_object(node->value))
        node_fail(node, node->value ? "must be an object" : "missing");
    json_object_foreach(node->value, key, value) if (find_word(members, key) < 0)
        node_fail(node, "unknown member \"%s\"; known are: %s", key, members);
}

struct node node_member(const struct node *object, const char *key)
{
    return (struct node){object->file, object, key, 0, json_object_get(object->value, key)};
}

struct node node_item(const struct node *array, size_t index)
{
    return (struct node){array->file, array, NULL, index, json_array_get(array->value, index)};
}

size_t node_length(const struct node *array, size_t least, size_t most)
{
    size_t length = json_array_size(array->value);
    if (!array->value)
        return 0;
    if (!json_is_array(array->value))
        node_fail(array, "must be an array");
    else if (length < least || length > most)
        node_fail(array, least == most ? "must have %zu elements" : "must have %zu to %zu elements", least, most);
    return array->file->failed ? 0 : length;
}

double node_number(const struct node *node, double least, double most, double fallback)
{
    double value = json_number_value(node->value);
    if (!node->value && isnan(fallback))
        node_fail(node, "missing");
    else if (node->value && !json_is_number(node->value))
        node_fail(node, "must be a number");
    else if (node->value && !(value >= least && value <= most))
        node_fail(node, "%.10g is outside %.10g .. %.10g", value, least, most);
    else if (node->value)
        return value;
    return isnan(fallback) ? least : fallback;
}

unsigned node_integer(const struct node *node, unsigned least, unsigned most, double fallback)
{
    double value = node_number(node, least, most, fallback);
    if (value != floor(value))
        node_fail(node, "must be a whole number");
    return node->file->failed ? least : (unsigned)value;
}

bool node_bool(const struct node *node, bool fallback)
{
    if (!node->value)
        return fallback;
    if (!json_is_boolean(node->value))
        node_fail(node, "must be true or false");
    return json_is_true(node->value);
}

const char *node_string(const struct node *node, const char *fallback)
{
    if (json_is_string(node->value))
        return json_string_value(node->value);
    if (node->value)
        node_fail(node, "must be a string");
    else if (!fallback)
        node_fail(node, "missing");
    return fallback ? fallback : "";
}

int node_choice(const struct node *node, const char *choices, int fallback)
{
    if (!node->value && fallback >= 0)
        return fallback;
    const char *text = node_string(node, NULL);
    int index = find_word(choices, text);
    if (index < 0)
        node_fail(node, "\"%s\" is none of: %s", text, choices);
    return index < 0 ? 0 : index;
}

void node_vector(const struct node *node, double *out, size_t count, double least, double most)
{
    if (node_length(node, count, count) == count)
        for (size_t i = 0; i < count; i++) {
            struct node item = node_item(node, i);
            out[i] = node_number(&item, least, most, NAN);
        }
}

double node_member_number(const struct node *object, const char *key, double least, double most, double fallback)
{
    struct node member = node_member(object, key);
    return node_number(&member, least, most, fallback);
}

unsigned node_member_integer(const struct node *object, const char *key, unsigned least, unsigned most, double fallback)
{
    struct node member = node_member(object, key);
    return node_integer(&member, least, most, fallback);
}

int node_member_choice(const struct node *object, const char *key, const char *choices, int fallback)
{
    struct node member = node_member(object, key);
    return node_choice(&member, choices, fallback);
}

void node_member_vector(const struct node *object, const char *key, double *out, size_t count, double least,
                        double most)
{
    struct node member = node_member(object, key);
    node_vector(&member, out, count, least, most);
}
