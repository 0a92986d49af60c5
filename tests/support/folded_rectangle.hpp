// A rectangle that is folded in layers: paths along it are straight lines of the flat rectangle, while its layers are
// near each other in space.
#pragma once

#include "host/distribution/surfaces/surface_files.hpp"
#include "host/sampling/surfaces/surface_darts.hpp"
#include "tests/support/meshes.hpp"

#include <array>
#include <cmath>
#include <memory>

namespace poissonlab {

inline constexpr double fold_length = 6, fold_width = 1; // of the rectangle, in units of a layer

/// A rectangle in six layers, each inclined by `angle` to the last one.
inline TriangleMesh folded_mesh(double angle)
{
    return textured_mesh(6 * 4, 5, [=](double u, double v) {
        const double along = u * fold_length, layer = std::min(std::floor(along), 5.0), rest = along - layer;
        const bool goes_back = static_cast<int>(layer) % 2 == 1;
        return MeshPoint{(goes_back ? 1 - rest : rest) * std::cos(angle), v * fold_width, along * std::sin(angle)};
    });
}

/// A folded rectangle, and where its points lie in the flat one.
struct FoldedRectangle
{
    explicit FoldedRectangle(double angle)
        : mesh(folded_mesh(angle)), surface(std::make_shared<const FixedSurface>(fixed_surface(mesh)))
    {}

    std::array<double, 2> flat(const SurfacePoint& point) const
    {
        const MeshPoint shares = barycentrics_of(point);
        std::array<double, 2> at{};
        for (std::size_t c = 0; c < 3; ++c) {
            const TexturePoint& corner = mesh.texture_points[mesh.texture_triangles[surface->faces[point.triangle]][c]];
            at[0] += shares[c] * corner[0] * fold_length;
            at[1] += shares[c] * corner[1] * fold_width;
        }
        return at;
    }

    double between(const SurfacePoint& a, const SurfacePoint& b) const
    {
        const auto p = flat(a), q = flat(b);
        return std::hypot(p[0] - q[0], p[1] - q[1]);
    }

    SurfaceDartRequest request(double distance) const
    {
        return {.surface = surface, .min_distance = distance, .stream = stream_key(5, Purpose::surface_darts, 0)};
    }

    TriangleMesh mesh;
    std::shared_ptr<const FixedSurface> surface;
};

}
