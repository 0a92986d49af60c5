// Tilings by substitution: a tile is enlarged and divided into parts, these are divided in turn, and so on.
//
// Kaplan, Introductory Tiling Theory for Computer Graphics, 2009 (SIGGRAPH 2008 class notes, II), section 8.1: a rule
// gives a prototile k parts, each a prototile with a similarity. Parts need not fill the tile exactly, as long as those
// of its neighbours make up for it, and may overlap others of the same shape and place, which then are one tile. All
// places are exact. A tile is known by its address, the numbers of the parts that lead to it, and can be made from it
// alone.
#pragma once

#include "tiles/prototiles/polygon_tiling.hpp"

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
    int deepest() const;

    /// The tile of an address, whose length is the depth and one. Throws InputError for a number that is no part.
    PlacedTile tile_at(const TileAddress& address) const;

    /// All tiles after `depth` divisions, in the order of their addresses. Of tiles that coincide the first one stays.
    /// Throws InputError where there are more than `most` of them, and Interrupted.
    std::vector<AddressedTile> tiles(int depth, std::size_t most) const;

    /// Those that may reach into a disk around `middle`, a place among the tiles of this depth: all that do, and some
    /// that nearly do. The radius is in units of the prototiles.
    std::vector<AddressedTile> tiles_near(int depth, const RingPlace& middle, double radius, std::size_t most) const;

private:
    PlacedTile part_of(const PlacedTile& whole, std::size_t index) const;
    double reach_beyond_parts() const;

    const PolygonTiling& tiling_;
    const StartPatch& start_;
    RingPlace mirrored_turn_; ///< magnification over its conjugate
    double reach_ = 0;        ///< of what a tile becomes, from its place on, in units of the tile
};

/// The number that a magnification is over its conjugate, if the ring has it as a root of unity: real numbers have 1.
std::optional<RingPlace> turn_of_magnification(const RootRing& ring, const RingPlace& magnification);

}
