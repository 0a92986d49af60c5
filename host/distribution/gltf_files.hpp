// Binary glTF 2.0 files of points with normals, and of models that are repeated at places, in nodes.
#pragma once

#include "base/surfaces/triangle_mesh.hpp"

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace poissonlab {

/// Points that a node of a glTF file has: three numbers of each place, and three of each normal.
struct GltfGroup
{
    std::string name; ///< empty: none
    std::vector<double> places;
    std::vector<float> normals;
};

/// Writes a node with a mesh of points for each group, whole or not at all. Groups without points are left out, because
/// glTF has no empty meshes. Places are floats; where they lie far from the origin for their extent, the node is moved
/// there and they count from it. Throws StorageError, and InputError where numbers are too large for floats or the file
/// for glTF.
void write_surface_glb(const std::filesystem::path& file, std::vector<GltfGroup> groups);

/// Copies of a model, which one node of a glTF file draws.
struct GltfInstances
{
    std::string name;
    const TriangleMesh* model = nullptr;
    std::array<float, 3> color{};  ///< linear, from 0 to 1
    std::vector<double> places;    ///< three of each copy
    std::vector<float> turns;      ///< four of each: quaternions x, y, z, w of length 1
    std::vector<float> ids;        ///< one of each
    std::vector<float> scales;     ///< one of each
    std::optional<float> of_class; ///< of all copies
};

/// Writes a node and a mesh for each group, whose copies are attributes of the extension EXT_mesh_gpu_instancing:
/// TRANSLATION, ROTATION, SCALE, _ID and, for groups with a class, _CLASS, all of them floats. The file requires the
/// extension. Groups without copies are left out, and places far from the origin count from their node. Throws
/// StorageError and InputError, as above.
void write_instance_glb(const std::filesystem::path& file, std::vector<GltfInstances> groups);

/// A ring of corners around the y axis.
struct ModelRing
{
    double radius = 0, height = 0;
};

/// A closed body of twelve sides around the y axis, from a point at the height `top` over rings, downwards, to one at
/// `bottom`: a cone has one ring.
TriangleMesh turned_model(double top, const std::vector<ModelRing>& rings, double bottom);

/// Writes a binary glTF file: a description and the bytes of its buffer, which may be empty. Throws StorageError, and
/// InputError where they have 4 GB or more.
void write_glb_parts(const std::filesystem::path& file, std::string json, std::string_view buffer);

}
