// The settings of [[distribution]] kind = "surface".
#pragma once

#include "base/word_table.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>

namespace poissonlab {

enum class SurfaceMethod
{
    darts,
    elimination
};

inline constexpr WordTable<SurfaceMethod, 2> surface_methods{
    {{{SurfaceMethod::darts, "darts"}, {SurfaceMethod::elimination, "elimination"}}}};

/// A mesh as it is read: see host/distribution/surfaces/surface_set.hpp.
struct SurfaceMesh;

/// kind = "surface": points on the triangles of a mesh.
struct MeshPointSettings
{
    std::filesystem::path mesh;
    SurfaceMethod method = SurfaceMethod::darts;
    std::optional<std::size_t> points;
    std::optional<double> min_distance;
    std::optional<double> relative_radius;
    double normal_angle = 120;
    double factor = 0.99;
    std::uint32_t candidates = 5;
    std::shared_ptr<const SurfaceMesh> read{}; ///< the mesh, where it was read already
};

}
