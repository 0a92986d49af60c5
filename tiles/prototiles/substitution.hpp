// Tilings by substitution: a tile is enlarged and divided into parts, these are divided in turn, and so on.
//
// Kaplan, Introductory Tiling Theory for Computer Graphics, 2009 (SIGGRAPH 2008 class notes, II), section 8.1: a rule
// gives a prototile k parts, each a prototile with a similarity. Parts need not fill the tile exactly, as long as those
// of its neighbours make up for it, and may overlap others of the same shape and place, which then are one tile. All
// places are exact. A tile is known by its address, the numbers of the parts that lead to it, and can be made from it
// alone.
//
// The shapes of some tiles, such as clusters of hats, differ from level to level by a linear map that is no similarity:
// their places are enlarged by that map. Smith, Myers, Kaplan and Goodman-Strauss, An aperiodic monotile, 2024 (arXiv
// 2303.10798), and A chiral aperiodic monotile, 2024 (arXiv 2305.17743); the return modules are those of Baake, Gaehler
// and Sadun, Dynamics and topology of the Hat family of tilings (arXiv 2305.05639).
#pragma once

#include "tiles/prototiles/polygon_tiling.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace poissonlab {

/// The numbers of the parts that lead to a tile: first the tile of the start, then a part for each level.
using TileAddress = std::vector<std::uint32_t>;

struct AddressedTile
{
    PlacedTile tile;
    TileAddress address;
};

class Substitution
{
public:
    /// `start` is one of the tiling's. Keeps a reference to the tiling.
    Substitution(const PolygonTiling& tiling, std::size_t start);

    /// Tiles of each prototile after `depth` divisions, by the substitution's matrix, and so with those that coincide
    /// counted as often as they are made. Nothing where there are more than `most` in all.
    std::optional<std::vector<std::uint64_t>> counts(int depth, std::uint64_t most) const;

    /// The largest depth at which all places are certain to fit into 64-bit integers.
    int deepest() const { return static_cast<int>(levels_.size()) - 1; }

    /// Returns the ratio of a tile's length to the length of its parts, in the limit of many levels.
    double inflation() const;

    /// The tile of an address, whose length is the depth and one. Throws InputError for a number that is no part.
    PlacedTile tile_at(const TileAddress& address) const;

    /// All tiles after `depth` divisions, in the order of their addresses. Of tiles that coincide the first one stays.
    /// Throws InputError where there are more than `most` of them, and Interrupted.
    std::vector<AddressedTile> tiles(int depth, std::size_t most) const;

    /// Those that may reach into a disk around `middle`, a place among the tiles of this depth: all that do, and some
    /// that nearly do. The radius is in units of the prototiles.
    std::vector<AddressedTile> tiles_near(int depth, const RingPlace& middle, double radius, std::size_t most) const;

    /// Returns the tile that a place lies in, the first one of several at edges, or nothing if it lies in no tile.
    std::optional<AddressedTile> tile_around(int depth, const RingPlace& place) const;

private:
    /// The map of places by a number of divisions, and how far from its place a tile's descendants reach.
    struct Level
    {
        std::array<RingMap, 2> maps; ///< of tiles that are not mirrored, and of those that are
        /// The reach of a tile of scale 1, in the plane with the lengths of edges and in the ring's two planes (see
        /// RootRing::sizes()).
        std::array<double, 3> reach{};
    };

    PlacedTile part_of(const PlacedTile& whole, std::size_t index) const;
    std::array<double, 3> sizes(const RingPlace& place) const;
    void add_levels();
    Level next_level() const;
    bool fits(const Level& level) const;

    const PolygonTiling& tiling_;
    const StartPatch& start_;
    RingPlace mirrored_turn_; ///< magnification over its conjugate
    bool flips_ = false;      ///< parts are mirrored where their tile is not
    std::vector<Level> levels_;
};

/// Returns the quotient of a magnification and its conjugate if it is a root of unity of the ring. It is 1 for real
/// numbers and for linear maps that are no multiplication.
std::optional<RingPlace> turn_of_magnification(const RootRing& ring, const RingMap& magnification);

/// True if the map is a multiplication.
bool is_multiplication(const RootRing& ring, const RingMap& map);

}
