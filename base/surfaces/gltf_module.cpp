// The module poissonlab_meshes: triangles of glTF 2.0 by assimp.
//
// Nodes are walked here, in doubles, and not by assimp, which would sort meshes by their materials.
#include "base/errors/errors.hpp"
#include "base/surfaces/gltf_mesh.hpp"

#include <assimp/Importer.hpp>
#include <assimp/scene.h>

#include <fmt/format.h>

#include <cmath>
#include <string>

namespace poissonlab {
namespace {

/// Rows of a movement of space: the last column moves.
using Movement = std::array<std::array<double, 4>, 3>;

Movement product(const Movement& a, const aiMatrix4x4& b)
{
    Movement result{};
    for (unsigned row = 0; row < 3; ++row)
        for (unsigned column = 0; column < 4; ++column)
            for (unsigned k = 0; k < 4; ++k)
                result[row][column] += k < 3 || column < 3 ? a[row][k] * static_cast<double>(b[k][column]) : a[row][3];
    return result;
}

double determinant(const Movement& m)
{
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

class GltfScene
{
public:
    GltfScene(const std::filesystem::path& file, const aiScene& scene, TriangleMesh& mesh)
        : file_(file), scene_(scene), mesh_(mesh)
    {}

    void read()
    {
        add_node(*scene_.mRootNode, {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}}, 0);
        if (mesh_.triangles.empty()) fail("has no triangles");
        if (mesh_.texture_points.empty()) mesh_.texture_triangles.clear();
    }

private:
    void add_node(const aiNode& node, const Movement& outside, int depth)
    {
        constexpr int deepest = 1000;
        if (depth > deepest) fail(fmt::format("has nodes within nodes, more than {} deep", deepest));
        const Movement movement = product(outside, node.mTransformation);
        for (unsigned i = 0; i < node.mNumMeshes; ++i) add_mesh(*scene_.mMeshes[node.mMeshes[i]], movement);
        for (unsigned i = 0; i < node.mNumChildren; ++i) add_node(*node.mChildren[i], movement, depth + 1);
    }

    void add_mesh(const aiMesh& part, const Movement& movement)
    {
        const std::size_t first = mesh_.vertices.size(), first_texture = mesh_.texture_points.size();
        if (first + part.mNumVertices > UINT32_MAX / 4 || mesh_.triangles.size() + part.mNumFaces > UINT32_MAX / 4)
            fail(fmt::format("has more than {} vertices or triangles", UINT32_MAX / 4));
        const aiVector3D* const texture = part.mTextureCoords[0];
        for (unsigned i = 0; i < part.mNumVertices; ++i) {
            add_vertex(part.mVertices[i], movement);
            if (texture) add_texture_point(texture[i]);
        }
        const bool is_mirrored = determinant(movement) < 0;
        for (unsigned f = 0; f < part.mNumFaces; ++f) {
            const aiFace& face = part.mFaces[f];
            if (face.mNumIndices != 3) continue; // points and lines
            MeshTriangle triangle{}, corners{no_texture_point, no_texture_point, no_texture_point};
            for (unsigned k = 0; k < 3; ++k) {
                const unsigned corner = face.mIndices[is_mirrored ? 2 - k : k];
                if (corner >= part.mNumVertices) fail("has a triangle with a vertex that is not there");
                triangle[k] = static_cast<std::uint32_t>(first + corner);
                if (texture) corners[k] = static_cast<std::uint32_t>(first_texture + corner);
            }
            mesh_.triangles.push_back(triangle);
            mesh_.texture_triangles.push_back(corners);
        }
    }

    void add_vertex(const aiVector3D& place, const Movement& movement)
    {
        MeshPoint& moved = mesh_.vertices.emplace_back();
        for (std::size_t k = 0; k < 3; ++k) {
            const auto& row = movement[k];
            moved[k] = row[0] * static_cast<double>(place.x) + row[1] * static_cast<double>(place.y) +
                       row[2] * static_cast<double>(place.z) + row[3];
            if (!std::isfinite(moved[k]))
                fail(fmt::format("vertex {} has a coordinate that is no finite number", mesh_.vertices.size()));
        }
    }

    void add_texture_point(const aiVector3D& place)
    {
        const TexturePoint point{static_cast<double>(place.x), static_cast<double>(place.y)};
        if (!std::isfinite(point[0]) || !std::isfinite(point[1]))
            fail(fmt::format("vertex {} has a texture coordinate that is no finite number", mesh_.vertices.size()));
        mesh_.texture_points.push_back(point);
    }

    [[noreturn]] void fail(const std::string& problem) const { throw InputError::at({file_.string()}, problem); }

    const std::filesystem::path& file_;
    const aiScene& scene_;
    TriangleMesh& mesh_;
};

/// Returns the reason that assimp gives, as the end of a sentence.
std::string reason_of(const Assimp::Importer& importer)
{
    std::string reason = importer.GetErrorString();
    while (!reason.empty() && (reason.back() == '\n' || reason.back() == '.')) reason.pop_back();
    return reason.empty() || reason.starts_with("No suitable reader") ? "it is damaged, or no glTF"
                                                                      : shortened(reason, 200);
}

}

}

extern "C" __attribute__((visibility("default"))) void poissonlab_read_gltf(const std::filesystem::path& file,
                                                                            poissonlab::TriangleMesh& mesh)
{
    using namespace poissonlab;
    Assimp::Importer importer;
    const aiScene* scene = nullptr;
    std::string reason;
    try {
        scene = importer.ReadFile(file.string(), 0);
        if (!scene) reason = reason_of(importer);
    } catch (const std::exception&) { // of memory, where counts in the file lie, among others
        reason = "it is damaged";
    }
    if (!scene || !scene->mRootNode)
        throw InputError::at({file.string()},
                             "cannot be read as glTF: " + (reason.empty() ? "it has no nodes" : reason));
    GltfScene(file, *scene, mesh).read();
}
