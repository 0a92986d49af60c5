// Pairs of points on a mesh: the pair correlation function through space and along the surface, and the distribution of
// the differences of points.
//
// g(r) is the number of pairs at distance r over that of random points (analysis/measures/pair_correlation.hpp). A mesh
// has no closed form for the latter. It is measured with random points on the same mesh, between which and the points
// pairs are counted in the same way (Davis, Peebles, A survey of galaxy redshifts V, Astrophysical Journal 267, 1983):
// borders and curvature need no correction then.
//
// The difference of two points is the vector in the tangent plane of the first one which has the direction in which the
// shortest path to the second one begins, and its length (Wei, Wang, Differential domain analysis for non-uniform
// sampling, ACM Transactions on Graphics 30(4), 2011). The localised pair correlation takes the densities within
// reach of the points of each part instead of that of all (after Quan, Guo, Yan, Meng, Zhang, Analyzing surface
// sampling patterns using the localized pair correlation function, Computational Visual Media 2(3), 2016), so that a
// density that varies slowly does not look like an attraction of points.
#pragma once

#include "analysis/measures/pair_correlation.hpp"
#include "analysis/surfaces/refined_mesh.hpp"
#include "base/surfaces/triangle_tree.hpp"
#include "host/sampling/surfaces/fixed_surface.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

/// Distances go up to this multiple of the distance in the densest packing of as many points in a plane.
inline constexpr double farthest_pair = 4;
inline constexpr std::size_t pair_bins = 80;

/// Differences are counted in so many squares along each side of a square around (0, 0), from -4 to 4 distances.
inline constexpr std::size_t difference_squares = 128;

/// Paths from a point are so short that this many triangles lie within, if they are equally large.
inline constexpr double most_path_triangles = 1e5;

/// The points of a mesh as pairs are counted: the mesh, its surface, and random points on it.
struct PairGround
{
    const FixedSurface& surface;
    const TriangleMesh& mesh; ///< the triangles of the surface
    std::vector<SurfacePoint> random;
    std::int32_t least_cosine = 0; ///< of points whose distance through space counts
};

/// The part of the surface on which each point lies.
struct PartsOfPoints
{
    std::vector<std::uint32_t> of_point{};
    std::size_t count = 0; ///< of parts
};

/// Distances are in units of that in the densest packing.
struct MeshPairs
{
    double unit = 0;         ///< the distance in the densest packing, in the mesh's units
    std::size_t sources = 0; ///< points from which paths were followed: all, or the first of a random order
    double reach = 0;        ///< paths are no longer, in units
    /// The error is that of counts of independent pairs. Where only a part of the points are sources, `pairs` along the
    /// surface are those from sources to all points.
    std::vector<PairCorrelationBin> in_space, along;
    std::vector<PairCorrelationBin> localised; ///< the error is the standard deviation over parts; empty: too few parts
    std::vector<std::array<double, 2>> anisotropy; ///< distance, dB
    std::vector<double> differences;   ///< their density over that of random points, row by row from the top
    double nearest_along = 0;          ///< mean distance to the nearest point; infinite where none has one
    std::optional<double> least_along; ///< of all pairs, where paths were followed from all points
};

/// Counts pairs of points, of which there are two or more. Without parts nothing is localised. Results do not depend on
/// the number of threads.
MeshPairs pairs_on_mesh(const PairGround& ground, const std::vector<SurfacePoint>& points, const PartsOfPoints& parts,
                        std::uint64_t seed);

/// Columns distance, along, along_error, in_space, in_space_error, localised, localised_spread.
std::string mesh_pairs_csv(const MeshPairs& pairs);

}
