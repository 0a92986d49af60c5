// The triangles of a surface in the plane of its texture coordinates, in whole numbers: which one a place belongs to is
// decided exactly.
#pragma once

#include "host/sampling/surfaces/fixed_surface.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace poissonlab {

/// Places in the plane count in steps, 2^step_bits of which are a unit of tiles, 1/65,536 of their side.
inline constexpr int step_bits = 8;
using TexturePlace = std::array<std::int64_t, 2>;

/// Tiles from 0 that texture coordinates may be away: exact tests then fit in 128 bits.
inline constexpr double farthest_tile = 1 << 22;

struct TextureTriangle
{
    std::array<TexturePlace, 3> corners{}; ///< not on a line
    std::uint32_t triangle = 0;            ///< its number among those of the surface

    /// The shares of the second and third corner at a place inside, in units of 2^-31, rounded down; nothing outside. A
    /// place on an edge is where it would be if it lay a bit to the right, and, less than that, a bit higher: it is
    /// inside of exactly one of the triangles around it.
    std::optional<std::array<std::uint32_t, 2>> shares_at(const TexturePlace& place) const;

    /// Twice its area, in squares of steps, with its sign: it is exact until it is rounded, and so never 0.
    double twice_area() const;
};

/// A surface in the plane of its texture coordinates.
struct TexturePlane
{
    double tiles_per_unit = 1;
    std::vector<TextureTriangle> triangles; ///< with an area in the plane, in the order of the surface's
    std::size_t without_coordinates = 0;    ///< triangles of the surface
    std::size_t without_area = 0;           ///< triangles of the surface that are a line or a point in the plane
    double bare_area = 0;                   ///< of both, in squares of the mesh's units
};

/// The texture coordinates of the corners of a surface's triangle; nothing where it has none. `number` is that of
/// the mesh.
std::optional<std::array<TexturePoint, 3>> texture_of(const TriangleMesh& mesh, std::uint32_t number);

/// Makes the plane with so many tiles a unit of texture coordinates. Throws InputError, a sentence, where coordinates
/// are too far from 0, or no triangle has an area.
TexturePlane texture_plane(const TriangleMesh& mesh, const FixedSurface& surface, double tiles_per_unit);

/// The sum of the areas of triangles in the plane, in squares of units of texture coordinates.
double texture_area(const TriangleMesh& mesh, const FixedSurface& surface);

// The stretch of a parametrisation of a surface: the singular values of the map from texture coordinates to space.
//
// Sander, Snyder, Gortler, Hoppe, Texture mapping progressive meshes, SIGGRAPH 2001, section 3.

/// The singular values of a triangle's map: how long a unit of texture coordinates becomes in space, in the mesh's
/// units, where it becomes shortest and longest.
struct Stretch
{
    double least = 0;
    double greatest = 0;
};

/// Returns the singular values of a triangle with these corners in space.
Stretch stretch_of(const std::array<MeshPoint, 3>& places, const TextureTriangle& triangle, double tiles_per_unit);

/// Returns the singular values of the plane's triangles, in their order.
std::vector<Stretch> stretches_of(const FixedSurface& surface, const TexturePlane& plane);

/// The stretch of all triangles with an area in the plane.
struct StretchOfAll
{
    Stretch extremes;            ///< the least and the greatest of all
    double area_distortion = 1;  ///< the greatest area in space of an area in the plane, over the least
    double root_mean_square = 1; ///< Sander's L2, of equal areas in both: 1 where all lengths are kept
};
StretchOfAll stretch_of_all(const FixedSurface& surface, const TexturePlane& plane, const std::vector<Stretch>& each);

}
