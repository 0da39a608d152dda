/* SPDX-License-Identifier: MIT */
/*
 * The importer works in a process of its own, because a malformed file can make it crash or loop. What it read comes
 * back through a pipe, in the order of send_model().
 */
#include "import/import.h"

#include "import/importer.h"
#include "import/limits.h"
#include "import/normals.h"
#include "scene/picture.h"

#include <errno.h>
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#define NO_PIPE 4 /* the importing process' exit status; 3 is model_alloc()'s */

struct reply {
    char said[256]; /* the reason, or a warning */
    bool failed, has_uvs;
    enum model_normals normals;
    size_t materials, vertices, triangles;
};

static bool ends_with(const char *path, const char *ending)
{
    size_t length = strlen(path), tail = strlen(ending);
    return length > tail && !strcasecmp(path + length - tail, ending);
}

bool import_knows(const char *path)
{
    return ends_with(path, ".obj") || ends_with(path, ".ply") || ends_with(path, ".stl") || ends_with(path, ".gltf") ||
           ends_with(path, ".glb");
}

static int fail(const char *path, const char *reason, int code)
{
    fprintf(stderr, "%s: %.*s\n", path, (int)strcspn(reason, "\r\n"), reason);
    return code;
}

int import_check_readable(const char *path)
{
    struct stat status;
    if (stat(path, &status) != 0)
        return fail(path, strerror(errno), 3);
    if (!S_ISREG(status.st_mode)) /* before opening, which would wait for a pipe's other end */
        return fail(path, S_ISDIR(status.st_mode) ? strerror(EISDIR) : "not a regular file", 3);
    FILE *file = fopen(path, "rb");
    if (!file)
        return fail(path, strerror(errno), 3);
    fclose(file);
    return 0;
}

/* False if the other end has not got all. */
static bool send_model(FILE *out, const char *path, double crease)
{
    bool has_normals = false;
    struct reply reply = {0};
    struct model model = {0};
    model_add_mesh(&model, "");
    const char *reason = importer_read(path, &model, 0, &has_normals, reply.said, sizeof reply.said);
    struct model_mesh *mesh = &model.meshes[0];
    if (!reason && mesh->triangle_count == 0)
        reason = "has no triangles";
    if (!reason && mesh->triangle_count > UINT32_MAX / 3)
        reason = "has too many triangles";
    if (reason && reason != reply.said)
        snprintf(reply.said, sizeof reply.said, "%s", reason);
    if (!reason && (!has_normals || ends_with(path, ".stl")))
        normals_smooth(mesh, crease);
    reply.failed = reason != NULL;
    reply.normals = mesh->normals;
    reply.has_uvs = mesh->has_uvs;
    reply.materials = model.material_count;
    reply.vertices = mesh->vertex_count;
    reply.triangles = mesh->triangle_count;
    fwrite(&reply, sizeof reply, 1, out);
    for (size_t i = 0; !reason && i < model.material_count; i++) {
        size_t length = strlen(model.materials[i].name);
        fwrite(&model.materials[i], sizeof model.materials[i], 1, out);
        fwrite(&length, sizeof length, 1, out);
        fwrite(model.materials[i].name, 1, length, out);
        length = model.materials[i].picture ? strlen(model.materials[i].picture) : 0;
        fwrite(&length, sizeof length, 1, out);
        if (length)
            fwrite(model.materials[i].picture, 1, length, out);
        if (model.materials[i].inside)
            fwrite(model.materials[i].inside, 1, model.materials[i].inside_size, out);
    }
    if (!reason) {
        fwrite(mesh->vertices, sizeof *mesh->vertices, mesh->vertex_count, out);
        fwrite(mesh->triangles, sizeof *mesh->triangles, mesh->triangle_count, out);
    }
    model_free(&model);
    return !ferror(out);
}

/* False if the pipe ended early. */
static bool receive(FILE *in, struct reply *reply, struct model *model, size_t index)
{
    if (fread(reply, sizeof *reply, 1, in) != 1)
        return false;
    if (reply->failed)
        return true;
    const size_t first = model->material_count;
    for (size_t i = 0; i < reply->materials; i++) {
        struct model_material material;
        size_t length;
        if (fread(&material, sizeof material, 1, in) != 1 || fread(&length, sizeof length, 1, in) != 1)
            return false;
        material.name = model_alloc(length + 1);
        material.picture = NULL;
        material.inside = NULL;
        bool whole = fread(material.name, 1, length, in) == length && fread(&length, sizeof length, 1, in) == 1;
        if (whole && length) {
            material.picture = model_alloc(length + 1);
            whole = fread(material.picture, 1, length, in) == length;
        }
        if (whole && material.inside_size) {
            material.inside = model_alloc(material.inside_size);
            whole = fread(material.inside, 1, material.inside_size, in) == material.inside_size;
        }
        struct model_material *out = model_add_material(model, "");
        free(out->name);
        *out = material;
        if (!whole)
            return false;
    }
    struct model_mesh *mesh = &model->meshes[index];
    mesh->vertices = model_alloc(reply->vertices * sizeof *mesh->vertices);
    mesh->triangles = model_alloc(reply->triangles * sizeof *mesh->triangles);
    mesh->vertex_count = mesh->vertex_room = reply->vertices;
    mesh->triangle_count = mesh->triangle_room = reply->triangles;
    mesh->has_uvs = reply->has_uvs;
    mesh->normals = reply->normals;
    if (fread(mesh->vertices, sizeof *mesh->vertices, reply->vertices, in) != reply->vertices ||
        fread(mesh->triangles, sizeof *mesh->triangles, reply->triangles, in) != reply->triangles)
        return false;
    for (size_t i = 0; i < mesh->triangle_count; i++)
        mesh->triangles[i].material += (uint32_t)first;
    return true;
}

/* The importing process, and the pipe from it; null if there can be none. */
static FILE *start(const char *path, double crease, pid_t *child)
{
    int ends[2];
    if (pipe(ends) != 0)
        return NULL;
    fflush(NULL); /* or both processes would write what is still buffered */
    *child = fork();
    if (*child == 0) {
        close(ends[0]);
        /* its last words before a crash are not ours, unless a sanitizer says them */
        if (!LIMITS_SANITIZED && !freopen("/dev/null", "w", stderr))
            _exit(NO_PIPE);
        limits_set(path);
        FILE *out = fdopen(ends[1], "wb");
        const bool sent = out && send_model(out, path, crease);
        _exit(out && fclose(out) == 0 && sent ? 0 : NO_PIPE);
    }
    close(ends[1]);
    FILE *in = *child > 0 ? fdopen(ends[0], "rb") : NULL;
    if (!in)
        close(ends[0]);
    return in;
}

/* Reads the pictures of the materials from `first` on, which are beside the model or inside it. What is no PNG that can
 * be read, or not wanted, is left out: a warning says so, once for each. */
static void read_pictures(const char *path, struct model *model, size_t first, bool has_uvs)
{
    for (size_t i = first; i < model->material_count; i++) {
        struct model_material *m = &model->materials[i];
        bool known = false;
        for (size_t k = first; m->picture && k < i; k++)
            if (model->materials[k].picture && !strcmp(model->materials[k].picture, m->picture)) {
                m->texture = model->materials[k].texture;
                known = true;
            }
        if (!m->picture || known || !has_uvs)
            continue;
        if (m->picture[0] == '*')
            picture_inside(path, m, model, &m->texture);
        else
            picture_beside(path, m->picture, model, &m->texture);
    }
    for (size_t i = first; i < model->material_count; i++) {
        free(model->materials[i].picture);
        model->materials[i].picture = NULL;
        free(model->materials[i].inside);
        model->materials[i].inside = NULL;
    }
}

int import_file(const char *path, double crease, struct model *model, size_t mesh)
{
    const size_t materials = model->material_count;
    struct reply reply;
    pid_t child;
    int code = import_check_readable(path);
    FILE *in = code ? NULL : start(path, crease, &child);
    if (code)
        return code;
    if (!in)
        return fail(path, strerror(errno), 3);
    bool whole = receive(in, &reply, model, mesh), unread = ferror(in);
    int status = 0, reason = errno;
    fclose(in);
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    if (signal == SIGXCPU || signal == SIGKILL || signal == SIGALRM)
        return fail(path, "malformed: the importer finds no end of it", 1);
    if (unread || (WIFEXITED(status) && WEXITSTATUS(status) == NO_PIPE))
        return fail(path, strerror(unread ? reason : EIO), 3);
    if (WIFEXITED(status) && WEXITSTATUS(status) == 3)
        return fail(path, "too large: the importer has not enough memory for it", 1);
    if (!whole)
        return fail(path, "malformed: the importer breaks down over it", 1);
    reply.said[sizeof reply.said - 1] = 0;
    if (reply.failed)
        return fail(path, reply.said, 1);
    if (reply.said[0])
        fprintf(stderr, "%s: warning: %s\n", path, reply.said);
    read_pictures(path, model, materials, reply.has_uvs);
    return 0;
}

void import_fit(struct model_mesh *mesh)
{
    double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY}, radius = 0;
    for (size_t i = 0; i < mesh->vertex_count; i++)
        for (int k = 0; k < 3; k++) {
            low[k] = fmin(low[k], mesh->vertices[i].position[k]);
            high[k] = fmax(high[k], mesh->vertices[i].position[k]);
        }
    for (size_t i = 0; i < mesh->vertex_count; i++) {
        double *p = mesh->vertices[i].position;
        for (int k = 0; k < 3; k++)
            p[k] -= (low[k] + high[k]) / 2;
        radius = fmax(radius, hypot(hypot(p[0], p[1]), p[2]));
    }
    for (size_t i = 0; radius > 0 && i < mesh->vertex_count; i++)
        for (int k = 0; k < 3; k++)
            mesh->vertices[i].position[k] /= radius;
}
