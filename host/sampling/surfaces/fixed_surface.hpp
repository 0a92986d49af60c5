// A surface in whole numbers: its corners lie on a grid whose unit is between 2^-30 and 2^-29 of its size.
//
// Distances are then exact, and kernels and their twins come to the same points. Units are powers of two, and the
// grid's origin is a multiple of one, so that places are written as doubles without rounding.
#pragma once

#include "base/geometry/point_set.hpp"
#include "base/surfaces/triangle_mesh.hpp"
#include "kernels/common/surfaces/surface.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace poissonlab {

using SurfacePoint = contract::surface::SurfacePoint;
using SurfaceTriangle = contract::surface::Triangle;
using MeshPlace = std::array<std::int64_t, 3>;

struct FixedSurface
{
    MeshPoint origin{}; ///< the lowest corner of the grid
    double unit = 1;    ///< side of a cell of the grid
    std::vector<SurfaceTriangle> triangles;
    std::vector<std::uint32_t> faces; ///< of each: its number among the mesh's triangles
    std::vector<double> areas;        ///< of each, in squares of the mesh's units
    double area = 0;                  ///< of all
    double size = 0;                  ///< the longest side of the box around the mesh
    std::size_t flat = 0;             ///< triangles without an area, which were left out
    std::size_t open_edges = 0;       ///< with a triangle on one side only; corners at one place count as one

    double units_of(double length) const { return length / unit; }
};

/// Rounds the corners of a mesh to a grid. Throws InputError: no triangle has an area, or the mesh lies so far from 0
/// that doubles do not tell its places apart.
FixedSurface fixed_surface(const TriangleMesh& mesh);

/// The place of shares of a triangle's second and third corner, in units of 2^-31, as kernels have it.
MeshPlace place_on(const SurfaceTriangle& triangle, std::uint32_t share_1, std::uint32_t share_2);

MeshPlace place_of(const SurfacePoint& point);

/// The exact squared distance, in squares of the grid's unit.
std::uint64_t squared_distance(const MeshPlace& a, const MeshPlace& b);

/// The product of the normals of two triangles, in units of 2^-30.
std::int32_t cosine_between(const SurfaceTriangle& a, const SurfaceTriangle& b);

/// The least product of normals that are at most so far apart; of 180 degrees, that of any.
std::int32_t least_cosine(double degrees);

/// Points in the mesh's own units, exactly.
PointSet points_of(const FixedSurface& surface, const std::vector<SurfacePoint>& points);

/// The normal of a triangle, of length 1 as far as whole numbers allow.
MeshPoint normal_of(const SurfaceTriangle& triangle);

}
