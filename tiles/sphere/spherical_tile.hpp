// Isohedral tilings of the sphere by tiles whose edges are curves: a finite group of isometries moves one tile to all
// others, each element to another one.
//
// After Grünbaum and Shephard, Spherical tilings with transitivity properties, 1981, and Yen and Séquin, Escher sphere
// construction kit, 2001. Cutting the orbifold of a group leaves a disk, the tile. For rotations about centres of three
// orders the cut is a tree: three edges from a corner, which may be anywhere, to the centres, or two where the corner
// is one of these. Every edge has two sides, and a rotation about its centre moves one to the other. Edges on mirrors
// are straight.
#pragma once

#include "tiles/isohedral/split_tile.hpp"
#include "tiles/sphere/spherical_group.hpp"
#include "tiles/sphere/spherical_polygon.hpp"

#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

/// Names of groups: 532, 432, 332, 22n, these with mirrors, which begin with *, and 3*2 and 2*n.
const std::vector<std::string>& spherical_group_names();

struct SphericalTileSettings
{
    std::string group = "532";
    int n = 5;                             ///< of 22n, *22n and 2*n; at least 2
    std::array<double, 3> corner{1, 1, 1}; ///< weights of the three centres: where their edges meet
    std::vector<PlaneCurve> curves = {};   ///< of the edges to the centres, which are (1, 0); none: straight
    std::optional<TileSplit> split = {};
};

/// A side of a tile, from a corner to the next one.
struct SphericalSide
{
    std::size_t partner = 0;     ///< the side of the neighbour that is the same line
    std::uint32_t neighbour = 0; ///< the tile of element g has that of g * neighbour beyond the side
    bool is_mirror = false;      ///< both tiles run along the side in one direction
};

/// The tile of element 0, and those that the group makes of it.
class SphericalTile
{
public:
    /// Throws InputError for curves of edges that are not there, a tile that meets itself or surrounds the sphere, and
    /// a path that meets its outline.
    explicit SphericalTile(const SphericalTileSettings& settings);

    const SphericalGroup& group() const { return group_; }
    const std::vector<SphericalSide>& sides() const { return sides_; }
    const SphericalPolygon& outline() const { return outline_; }

    /// The corners of the tile in its outline: side i begins at corner i.
    const std::vector<std::size_t>& corners() const { return corners_; }

    /// The outline, or of a tile that a path divides the part with the sides from its first corner on, and the other.
    const std::vector<SphericalPolygon>& parts() const { return parts_; }

    /// The part that has a side.
    std::size_t part_of(std::size_t side) const;

    /// Sides off mirrors across which equal parts meet: of two parts none in a Heaven and Hell pattern.
    std::size_t alike() const;

    /// The numbers of corners of a tiling, of edges and tiles: corners that are centres of order 2 count.
    std::array<std::size_t, 3> counts() const;

    /// A colour for each element: neighbours differ, symmetries permute colours, and no such colouring has fewer.
    std::vector<std::uint32_t> coloring() const;

private:
    void add_side(const PlaneCurve& curve, const UnitVector& from, const UnitVector& to, bool is_backwards,
                  const SphericalSide& side);
    void add_mirror_sides(const std::vector<UnitVector>& corners);
    void make_rotated(const SphericalTileSettings& settings, const std::array<int, 3>& orders);
    void make_mirrored(const std::array<int, 3>& orders);
    void make_gyrated(const SphericalTileSettings& settings, const std::array<int, 3>& orders);
    void split(const TileSplit& path);

    SphericalGroup group_{std::vector<Isometry>{}};
    std::vector<SphericalSide> sides_;
    SphericalPolygon outline_;
    std::vector<std::size_t> corners_;
    std::vector<SphericalPolygon> parts_;
    std::optional<TileSplit> split_;
};

/// The place at (x, y) beside the arc that leads from (0, 0) to (1, 0): lengths are in lengths of the arc, x along its
/// circle and y at right angles to it, to the left.
UnitVector place_beside(const UnitVector& from, const UnitVector& to, const PlanePoint& place);

}
