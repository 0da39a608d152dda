/* SPDX-License-Identifier: MIT */
#include "import/importer.h"

#include <assimp/cimport.h>
#include <assimp/config.h>
#include <assimp/GltfMaterial.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Beyond this the quantiser's numbers are meaningless and squares leave the doubles' comfort. */
#define MOST_POSITION 1e15f

/* What the importer says on the way. The last line of `lost` is kept before any other: it means that part of the model
 * is missing, which is not a model. */
struct log {
    char *first;
    size_t size;
    bool lost;
};

/* Of the file's words what a message holds: they go to a terminal, on a line. */
static char *make_legible(char *text)
{
    text[strcspn(text, "\r\n")] = 0;
    for (unsigned char *at = (unsigned char *)text; *at; at++)
        *at = *at < ' ' || *at == 0x7f || (at[0] == 0xc2 && at[1] < 0xa0) ? '?' : *at; /* C1 in UTF-8, too */
    return text;
}

static void hear(const char *line, char *user)
{
    static const char *const lost[] = {"Ignoring empty face", "faces were dropped", "the TRIANGLES mode"};
    struct log *log = (struct log *)user;
    const char *text = strstr(line, ": ");
    text = text ? text + 2 : line;
    for (size_t i = 0; !log->lost && i < sizeof lost / sizeof *lost; i++)
        if (strstr(text, lost[i])) {
            log->lost = true;
            log->first[0] = 0;
        }
    if (!log->first[0] && (log->lost || !strncmp(line, "Error", 5)))
        snprintf(log->first, log->size, "%s", text);
    make_legible(log->first);
}

static bool get_colour(const struct aiMaterial *in, const char *key, double out[3])
{
    struct aiColor4D c;
    if (aiGetMaterialColor(in, key, 0, 0, &c) != AI_SUCCESS)
        return false;
    const float rgb[3] = {c.r, c.g, c.b};
    for (int k = 0; k < 3; k++)
        out[k] = rgb[k] >= 0 ? fmin(rgb[k], 1) : 0; /* a NaN is black */
    return true;
}

static double get_number(const struct aiMaterial *in, const char *key, double fallback)
{
    ai_real value;
    /* the functions for one number are inline in the header, which is not enough for an unoptimised build */
    return aiGetMaterialFloatArray(in, key, 0, 0, &value, NULL) == AI_SUCCESS && isfinite(value) ? value : fallback;
}

/* The mapping described in import.h for metalness and roughness. */
static void physical(const struct aiMaterial *in, const double base[3], struct model_material *out)
{
    double metal = fmin(fmax(get_number(in, "$mat.metallicFactor", 1), 0), 1);
    double rough = fmin(fmax(get_number(in, "$mat.roughnessFactor", 1), 0.1), 1);
    out->shininess = fmin(fmax(2 / pow(rough, 4) - 2, 1), 1023);
    for (int k = 0; k < 3; k++) {
        double f0 = 0.04 + (base[k] - 0.04) * metal;
        out->diffuse[k] = pow(base[k] * (1 - metal / 2), 1 / 2.2);
        out->specular[k] = fmin(1, f0 * (out->shininess + 8) / 8);
    }
    out->ks = 1;
}

/* A picture inside the model: its bytes, as they would be in a file, to the first material that has it. */
static void read_inside(const struct aiScene *scene, const struct model *model, struct model_material *out)
{
    char *end;
    const unsigned long index = strtoul(out->picture + 1, &end, 10);
    const struct aiTexture *texture = *end == 0 && index < scene->mNumTextures ? scene->mTextures[index] : NULL;
    for (const struct model_material *m = model->materials; texture && m < out; m++)
        if (m->inside && !strcmp(m->picture, out->picture))
            return;
    if (!texture || texture->mHeight != 0 || texture->mWidth == 0) /* else mWidth counts bytes */
        return;
    out->inside_size = texture->mWidth;
    out->inside = model_alloc(out->inside_size);
    memcpy(out->inside, texture->pcData, out->inside_size);
}

/* The file of the colours' texture, or *N, number N of those inside the model; null: none. */
static char *picture_of(const struct aiMaterial *in)
{
    static const enum aiTextureType types[] = {aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE};
    struct aiString path;
    for (int i = 0; i < 2; i++)
        if (aiGetMaterialTexture(in, types[i], 0, &path, NULL, NULL, NULL, NULL, NULL, NULL) == AI_SUCCESS &&
            path.length > 0)
            return make_legible(model_copy(path.data));
    return NULL;
}

static void read_material(const struct aiScene *scene, const struct aiMaterial *in, struct model *model)
{
    struct aiString name = {0};
    double base[3];
    bool named = aiGetMaterialString(in, AI_MATKEY_NAME, &name) == AI_SUCCESS && name.length > 0;
    struct model_material *out = model_add_material(model, named ? name.data : "unnamed");
    int two_sided = 0;
    out->two_sided = aiGetMaterialIntegerArray(in, AI_MATKEY_TWOSIDED, &two_sided, NULL) == AI_SUCCESS && two_sided;
    out->picture = picture_of(in);
    if (out->picture && out->picture[0] == '*')
        read_inside(scene, model, out);
    for (int k = 0; k < 3; k++)
        out->diffuse[k] = 0.75;
    if (get_colour(in, "$clr.base", base)) {
        physical(in, base, out);
        return;
    }
    if (!named || !strcmp(name.data, AI_DEFAULT_MATERIAL_NAME)) { /* the importer's own, or none at all */
        out->ks = 0.35;
        out->shininess = 30;
        return;
    }
    get_colour(in, "$clr.diffuse", out->diffuse);
    out->shininess = get_number(in, "$mat.shininess", 0);
    if (get_colour(in, "$clr.specular", out->specular) && out->shininess >= 0.5)
        out->ks = 1;
    out->shininess = fmin(fmax(round(out->shininess), 1), 1023);
}

/* Appends one of assimp's meshes; null or why not. */
static const char *read_mesh(const struct aiMesh *in, uint32_t material, struct model_mesh *out)
{
    static const double none[3];
    const size_t first = out->vertex_count;
    if (first + in->mNumVertices > UINT32_MAX)
        return "too many vertices";
    for (unsigned i = 0; i < in->mNumVertices; i++) {
        const struct aiVector3D *p = &in->mVertices[i], *n = in->mNormals ? &in->mNormals[i] : NULL;
        const struct aiVector3D *uv = in->mTextureCoords[0] ? &in->mTextureCoords[0][i] : NULL;
        if (!(fabsf(p->x) < MOST_POSITION && fabsf(p->y) < MOST_POSITION && fabsf(p->z) < MOST_POSITION))
            return "a vertex is not finite, or too far away";
        const double position[3] = {p->x, p->y, p->z};
        model_add_vertex(out, position, n ? (const double[3]){n->x, n->y, n->z} : none, uv ? uv->x : 0, uv ? uv->y : 0);
        if (in->mTangents) /* glTF's; tangents_make() makes others, and takes no notice of what is not finite */
            memcpy(out->vertices[first + i].tangent,
                   (double[]){in->mTangents[i].x, in->mTangents[i].y, in->mTangents[i].z}, 3 * sizeof(double));
        out->has_uvs |= uv && isfinite(uv->x) && isfinite(uv->y);
    }
    for (unsigned i = 0; i < in->mNumFaces; i++) {
        const struct aiFace *face = &in->mFaces[i];
        if (face->mNumIndices != 3)
            continue; /* points and lines that the importer could not sort out */
        for (int k = 0; k < 3; k++)
            if (face->mIndices[k] >= in->mNumVertices)
                return "a face refers to a vertex that is not there";
        model_add_triangle(out, (uint32_t)(first + face->mIndices[0]), (uint32_t)(first + face->mIndices[1]),
                           (uint32_t)(first + face->mIndices[2]), material);
    }
    return NULL;
}

static const struct aiScene *load(const char *path)
{
    const unsigned steps = aiProcess_ValidateDataStructure | aiProcess_RemoveComponent | aiProcess_Triangulate |
                           aiProcess_SortByPType | aiProcess_PreTransformVertices;
    struct aiPropertyStore *properties = aiCreatePropertyStore();
    aiSetImportPropertyInteger(properties, AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    aiSetImportPropertyInteger(properties, AI_CONFIG_PP_RVC_FLAGS,
                               aiComponent_COLORS | aiComponent_BONEWEIGHTS | aiComponent_ANIMATIONS |
                                   aiComponent_LIGHTS | aiComponent_CAMERAS);
    const struct aiScene *scene = aiImportFileExWithProperties(path, steps, NULL, properties);
    aiReleasePropertyStore(properties);
    return scene;
}

const char *importer_read(const char *path, struct model *model, size_t mesh, bool *has_normals, char *said,
                          size_t size)
{
    struct log log = {said, size, false};
    struct aiLogStream stream = {hear, (char *)&log};
    said[0] = 0;
    aiAttachLogStream(&stream);
    const struct aiScene *scene = load(path);
    aiDetachLogStream(&stream);
    if (!scene) {
        const char *error = aiGetErrorString();
        snprintf(said, size, "%s", *error ? error : "cannot be read as a model");
        return make_legible(said);
    }
    const char *reason = log.lost ? said : NULL;
    const size_t first_material = model->material_count;
    for (unsigned i = 0; i < scene->mNumMaterials; i++)
        read_material(scene, scene->mMaterials[i], model);
    *has_normals = true;
    for (unsigned i = 0; !reason && i < scene->mNumMeshes; i++) {
        const struct aiMesh *in = scene->mMeshes[i];
        if (in->mMaterialIndex >= scene->mNumMaterials)
            reason = "a mesh refers to a material that is not there";
        else
            reason = read_mesh(in, (uint32_t)first_material + in->mMaterialIndex, &model->meshes[mesh]);
        *has_normals = *has_normals && in->mNormals;
    }
    aiReleaseImport(scene);
    return reason;
}
