/* SPDX-License-Identifier: MIT */
/*
 * Model files: any bytes become a scene that passes the check and is drawn, or are refused with exit code 1 and the
 * reason. Input: a letter for the kind, then the file; after a zero byte in an .obj, its .mtl. The letter's upper half
 * says in what way assimp's answer is spoilt: it checks its own, so that nothing else would ever try our checks.
 *
 * assimp itself crashes, loops or wants all memory over some bytes, which is why the tool has it in a process of its
 * own. Only while that process is inside assimp may it break down. What it got through within its limits is then read
 * once more in this process, where the fuzzer sees which lines of importer.c it reaches.
 */
#define _GNU_SOURCE
#include "fuzz/load.h"
#include "import/importer.h"
#include "import/normals.h"

#include <assimp/cimport.h>
#include <assimp/scene.h>
#include <fcntl.h>
#include <math.h>
#include <signal.h>
#include <sys/resource.h>

/* The sanitizers', if they are there. */
void __sanitizer_set_death_callback(void (*callback)(void)) __attribute__((weak));
void __lsan_disable(void) __attribute__((weak));
void __lsan_enable(void) __attribute__((weak));

/* Of this process and the importing one. */
static struct {
    volatile bool inside, got; /* is in assimp, was given a scene by it */
} * shared;
static pid_t own;

const struct aiScene *__real_aiImportFileExWithProperties(const char *path, unsigned steps, struct aiFileIO *files,
                                                          const struct aiPropertyStore *properties);
const struct aiScene *__wrap_aiImportFileExWithProperties(const char *path, unsigned steps, struct aiFileIO *files,
                                                          const struct aiPropertyStore *properties);

/* --- assimp's answer, as a faulty assimp might give it ---------------------------------------------------------------
 */

static unsigned spoilt; /* which of the next, from 1 */

static void spoil_index(struct aiScene *scene, struct aiMesh *mesh)
{
    (void)scene;
    mesh->mFaces[mesh->mNumFaces - 1].mIndices[2] = mesh->mNumVertices;
}
static void spoil_index_more(struct aiScene *scene, struct aiMesh *mesh)
{
    (void)scene;
    mesh->mFaces[0].mIndices[0] = UINT32_MAX;
}
static void spoil_material(struct aiScene *scene, struct aiMesh *mesh)
{
    mesh->mMaterialIndex = scene->mNumMaterials;
}
static void spoil_vertex(struct aiScene *scene, struct aiMesh *mesh)
{
    (void)scene;
    mesh->mVertices[mesh->mNumVertices - 1].y = NAN;
}
static void spoil_vertex_far(struct aiScene *scene, struct aiMesh *mesh)
{
    (void)scene;
    mesh->mVertices[0].z = -1e15f;
}
static void spoil_normal(struct aiScene *scene, struct aiMesh *mesh)
{
    (void)scene;
    if (mesh->mNormals)
        mesh->mNormals[0].x = NAN;
}
static void spoil_uv(struct aiScene *scene, struct aiMesh *mesh)
{
    (void)scene;
    if (mesh->mTextureCoords[0])
        mesh->mTextureCoords[0][0].y = INFINITY;
}
static void spoil_tangent(struct aiScene *scene, struct aiMesh *mesh)
{
    (void)scene;
    if (mesh->mTangents)
        mesh->mTangents[0].x = NAN;
}
static void spoil_picture(struct aiScene *scene, struct aiMesh *mesh)
{
    (void)mesh;
    if (scene->mNumTextures)
        scene->mTextures[0]->mWidth = 0;
}
static void spoil_face(struct aiScene *scene, struct aiMesh *mesh)
{
    (void)scene;
    mesh->mFaces[0].mNumIndices = 2;
}

static const struct {
    void (*how)(struct aiScene *scene, struct aiMesh *last);
    bool refused;
} spoils[] = {{NULL, false},          {spoil_index, true},      {spoil_index_more, true}, {spoil_material, true},
              {spoil_vertex, true},   {spoil_vertex_far, true}, {spoil_normal, false},    {spoil_uv, false},
              {spoil_tangent, false}, {spoil_face, false},      {spoil_picture, false}};
enum { SPOILS = sizeof spoils / sizeof *spoils };

/* What assimp's own check let through: there is a mesh, with a face of three corners. */
static void spoil(const struct aiScene *given)
{
    struct aiScene *scene = (struct aiScene *)(uintptr_t)given;
    if (scene && scene->mNumMeshes && spoils[spoilt].how)
        spoils[spoilt].how(scene, scene->mMeshes[scene->mNumMeshes - 1]);
}

/* --- assimp itself ---------------------------------------------------------------------------------------------------
 */

/* The fuzzer's clock, which would interrupt us while we wait for the importing process. */
static const sigset_t *alarms(void)
{
    static sigset_t set;
    sigemptyset(&set);
    sigaddset(&set, SIGALRM);
    return &set;
}

/* The importing process' stderr, which is a stream in memory here, cannot be opened anew. */
FILE *__wrap_freopen(const char *path, const char *mode, FILE *stream);
FILE *__wrap_freopen(const char *path, const char *mode, FILE *stream)
{
    FUZZ_CHECK(stream == stderr);
    return stderr = fopen(path, mode);
}

/* A crash in there is neither the fuzzer's to report nor a sanitizer's; what assimp leaks is not ours. */
const struct aiScene *__wrap_aiImportFileExWithProperties(const char *path, unsigned steps, struct aiFileIO *files,
                                                          const struct aiPropertyStore *properties)
{
    static const int signals[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGALRM};
    const bool apart = getpid() != own;
    struct rlimit seconds;
    const int heard = apart ? dup(STDERR_FILENO) : -1, nowhere = apart ? open("/dev/null", O_WRONLY) : -1;
    if (apart) {
        sigprocmask(SIG_UNBLOCK, alarms(), NULL);
        getrlimit(RLIMIT_CPU, &seconds);
        setrlimit(RLIMIT_CPU, &(struct rlimit){1, seconds.rlim_max}); /* or it takes gigabytes for a few bytes */
        dup2(nowhere, STDERR_FILENO);
        for (size_t i = 0; i < sizeof signals / sizeof *signals; i++)
            signal(signals[i], SIG_DFL);
        if (__sanitizer_set_death_callback)
            __sanitizer_set_death_callback(NULL);
    }
    if (__lsan_disable)
        __lsan_disable();
    shared->inside = true;
    const struct aiScene *scene = __real_aiImportFileExWithProperties(path, steps, files, properties);
    shared->inside = false;
    shared->got = scene != NULL;
    spoil(scene);
    if (__lsan_enable)
        __lsan_enable();
    if (apart) {
        setrlimit(RLIMIT_CPU, &seconds);
        dup2(heard, STDERR_FILENO);
        close(heard);
        close(nowhere);
    }
    return scene;
}

/* In this process. */
static void read_again(const char *path)
{
    char said[256];
    bool has_normals;
    struct model model = {0};
    model_add_mesh(&model, "");
    const char *reason = importer_read(path, &model, 0, &has_normals, said, sizeof said);
    struct model_mesh *mesh = &model.meshes[0];
    for (size_t i = 0; i < mesh->vertex_count; i++)
        for (int k = 0; k < 3; k++)
            FUZZ_CHECK(fabs(mesh->vertices[i].position[k]) < 1e16);
    for (size_t i = 0; i < mesh->triangle_count; i++) {
        FUZZ_CHECK(mesh->triangles[i].material < model.material_count);
        for (int k = 0; k < 3; k++)
            FUZZ_CHECK(mesh->triangles[i].corner[k] < mesh->vertex_count);
    }
    if (!reason && !has_normals)
        normals_smooth(mesh, .8);
    for (size_t i = 0; i < model.material_count; i++) {
        const struct model_material *m = &model.materials[i];
        FUZZ_CHECK(m->shininess >= 1 && m->shininess <= 1023 && m->ks >= 0 && m->ks <= 1);
        for (int k = 0; k < 3; k++)
            FUZZ_CHECK(m->diffuse[k] >= 0 && m->diffuse[k] <= 1 && m->specular[k] >= 0 && m->specular[k] <= 1);
    }
    model_free(&model);
}

/* The last line is the reason why not; all others are of pictures that cannot be read, or warnings. */
static void judge(const struct load *load, const char *path)
{
    const char *last = load->told;
    for (const char *end; (end = strchr(last, '\n')) && end[1];)
        last = end + 1;
    FUZZ_CHECK(load->code == 0 || load->code == 1);
    if (load->code)
        FUZZ_CHECK(strncmp(last, path, strlen(path)) == 0 && !strstr(last, ": warning: "));
    else
        FUZZ_CHECK(!*last || strstr(last, ": warning: "));
}

static void try(const char *path)
{
    shared->inside = shared->got = false;
    sigprocmask(SIG_BLOCK, alarms(), NULL);
    struct load load = load_path(path);
    sigprocmask(SIG_UNBLOCK, alarms(), NULL);
    const bool broke =
        strstr(load.told, ": malformed: the importer ") || strstr(load.told, ": too large: the importer ");
    judge(&load, path);
    FUZZ_CHECK(broke == shared->inside);
    FUZZ_CHECK(!(shared->got && spoils[spoilt].refused) || load.code == 1);
    if (load.code == 0)
        load_draw(&load);
    if (!broke)
        read_again(path);
    load_free(&load);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static const char *const names[] = {"a.stl", "a.obj", "a.ply", "a.gltf", "a.glb"}; /* s, o, p, g, c, modulo 5 */
    char path[LOAD_PATH], path_beside[LOAD_PATH];
    if (!shared) {
        shared = mmap(NULL, sizeof *shared, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
        FUZZ_CHECK(shared != MAP_FAILED);
    }
    own = getpid();
    if (size == 0)
        return 0;
    spoilt = data[0] < 128 ? 0 : (data[0] - 128u) / 5 % SPOILS;
    const char *name = names[data++[0] % 5];
    const uint8_t *end = data + size - 1, *split = strcmp(name, "a.obj") ? NULL : memchr(data, 0, size - 1);
    int file = load_file(name, data, (size_t)((split ? split : end) - data), path);
    int beside = split ? load_file("a.mtl", split + 1, (size_t)(end - split - 1), path_beside) : -1;
    try(path);
    if (split)
        load_close(beside, path_beside);
    load_close(file, path);
    return 0;
}
