/* SPDX-License-Identifier: MIT */
#include "import/import.h"

#include "import/normals.h"

#include <assimp/cimport.h>
#include <assimp/config.h>
#include <assimp/GltfMaterial.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

/* Beyond this the quantiser's numbers are meaningless and squares leave the doubles' comfort. */
#define MOST_POSITION 1e15f

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

static int fail(const char *path, const char *reason)
{
    fprintf(stderr, "%s: %.*s\n", path, (int)strcspn(reason, "\r\n"), reason);
    return 1;
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
    return aiGetMaterialFloat(in, key, 0, 0, &value) == AI_SUCCESS && isfinite(value) ? value : fallback;
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
        out->specular[k] = pow(fmin(1, f0 * (out->shininess + 8) / 8), 1 / 2.2);
    }
    out->ks = 1;
}

static void read_material(const struct aiMaterial *in, struct model *model)
{
    struct aiString name = {0};
    double base[3];
    bool named = aiGetMaterialString(in, AI_MATKEY_NAME, &name) == AI_SUCCESS && name.length > 0;
    struct model_material *out = model_add_material(model, named ? name.data : "unnamed");
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
                                   aiComponent_TEXTURES | aiComponent_LIGHTS | aiComponent_CAMERAS |
                                   aiComponent_TANGENTS_AND_BITANGENTS);
    const struct aiScene *scene = aiImportFileExWithProperties(path, steps, NULL, properties);
    aiReleasePropertyStore(properties);
    return scene;
}

int import_file(const char *path, double crease, struct model *model, size_t mesh)
{
    const struct aiScene *scene = load(path);
    const char *reason = NULL;
    if (!scene)
        return fail(path, *aiGetErrorString() ? aiGetErrorString() : "cannot be read as a model");
    const size_t first_material = model->material_count;
    for (unsigned i = 0; i < scene->mNumMaterials; i++)
        read_material(scene->mMaterials[i], model);
    struct model_mesh *out = &model->meshes[mesh];
    bool normals = !ends_with(path, ".stl");
    for (unsigned i = 0; !reason && i < scene->mNumMeshes; i++) {
        const struct aiMesh *in = scene->mMeshes[i];
        if (in->mMaterialIndex >= scene->mNumMaterials)
            reason = "a mesh refers to a material that is not there";
        else
            reason = read_mesh(in, (uint32_t)first_material + in->mMaterialIndex, out);
        normals = normals && in->mNormals;
    }
    aiReleaseImport(scene);
    if (!reason && out->triangle_count == 0)
        reason = "has no triangles";
    if (!reason && out->triangle_count > UINT32_MAX / 3)
        reason = "too many triangles";
    if (reason)
        return fail(path, reason);
    if (!normals)
        normals_smooth(out, crease);
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
