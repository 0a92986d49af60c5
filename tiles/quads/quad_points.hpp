// These Poisson disk tiles for surfaces of quads fit across all edges and around all vertices.
//
// Regions are those of corner-based Poisson disk tiles (Lagae, Tile-Based Methods in Computer Graphics, 2007, section
// 4.5), on a surface that is flat but for its vertices: disks around vertices, which are cones where other than four
// quads meet, then what is left of strips along edges, then what is left of tiles. Points of a region follow from those
// of the regions before it that can be near, and from nothing else. A disk is one of its valence and its colour, and a
// quad has one of its sectors; an edge is one of the two sectors at its ends. Quads with the same four sectors have the
// same tile, turned. Li, Lo, Leung and Fu, Dual Poisson-disk tiling, IEEE TVCG 2010, lay a tile on each vertex instead.
#pragma once

#include "tiles/quads/quad_mesh.hpp"

namespace poissonlab {

/// Up to this distance, in sides of a tile, regions of one kind are that far apart: it is 1 / (1 + 2 r), a disk's
/// radius being r = sqrt((1/sqrt 2 + 1/2)^2 + 1/4) distances.
inline constexpr double most_quad_distance = 0.2766;

struct QuadPointRequest
{
    double min_distance = 0.1; ///< along the surface, in sides of a tile
    std::uint32_t colors = 1;  ///< of vertices
    std::uint64_t seed = 1;
};

struct QuadPoint
{
    std::uint32_t quad = 0;
    double u = 0, v = 0; ///< multiples of 2^-17
};

struct QuadPoints
{
    std::vector<QuadPoint> points;               ///< quad after quad
    std::size_t disks = 0, edges = 0, tiles = 0; ///< how many different ones there are
};

/// Lays tiles on all quads.
QuadPoints lay_quad_points(const QuadMesh& mesh, const QuadTopology& topology, const QuadPointRequest& request);

/// A place near a vertex has the number of its quad there, and its distances along the first and the
/// second side of that quad's corner.
struct WedgePlace
{
    std::uint32_t wedge = 0;
    double a = 0, b = 0;
};

/// Returns the squared length of the shortest way between two places around a vertex, over the quads that meet there.
double cone_squared(std::uint32_t valence, const WedgePlace& p, const WedgePlace& q);

}
