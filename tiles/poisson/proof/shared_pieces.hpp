// The pieces of a tile set as its points say they are, and the closures of its tiles.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, sections 4.3 to 4.6. A tile holds only its side of
// the pieces around it. All tiles that have a variant on the same side must hold the same points there; then
// the variant is the union of what the tiles around its cell hold, whichever they are. The closure of a tile
// is its interior with the whole pieces of its corners, edges and faces, those of their points included that
// lie in tiles around it: all that is known of a tiling when one tile is.
#pragma once

#include "tiles/poisson/poisson_tile_set.hpp"
#include "tiles/poisson/tile_pieces.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace poissonlab {

/// The points of a tile, each with its cell, in order of cell and then of coordinates.
class SortedTile
{
public:
    SortedTile(const PoissonTileSet& set, const TileRegions& regions, std::uint32_t tile);

    /// The points in the region of a cell, as numbers: equal numbers are equal points.
    std::span<const std::uint64_t> in(const TileCell& cell) const;

    /// Finds two equal points: the number of one of them, or null where all points differ.
    const std::uint64_t* duplicate() const;

    /// The position of the point with a number.
    static UnitPosition position(std::uint64_t number);

private:
    std::vector<std::uint64_t> numbers_; ///< cell (16 bits), x, y, z
};

class SharedPieces
{
public:
    /// The set must outlive this. Throws InputError, a sentence that starts with the tile, where tiles
    /// disagree on a variant, or a tile has two equal points. Runs on all threads.
    explicit SharedPieces(const PoissonTileSet& set) : SharedPieces(set, regions_of(set.parameters)) {}

    /// Takes the regions of a set that this one is a part of.
    SharedPieces(const PoissonTileSet& set, const TileRegions& regions);

    const TileRegions& regions() const { return regions_; }

    /// The points of a variant relative to its cell's base.
    const std::vector<UnitPosition>& piece(std::uint8_t axes, std::uint32_t variant) const
    {
        return pieces_[axes][variant];
    }

    /// The points of a tile's closure, in no particular order.
    void closure(std::uint32_t tile, std::vector<UnitPosition>& points) const;

private:
    /// One side of a variant: the tile that tells what is there, the lowest that has it, and its points.
    struct Part
    {
        std::uint32_t tile = UINT32_MAX;
        std::vector<std::uint64_t> points;
    };

    Part& part(const PlacedPiece& piece);
    void find_parts();
    void join_parts();
    const PlacedPiece* first_disagreement(std::uint32_t tile, const std::vector<PlacedPiece>& pieces) const;
    bool is_sound(std::uint32_t tile) const;
    void check_tiles() const;
    [[noreturn]] void refuse(std::uint32_t tile) const;

    const PoissonTileSet& set_;
    TileRegions regions_;
    std::array<std::vector<std::array<Part, 8>>, 8> parts_;        ///< by axes, variant, side of the tile
    std::array<std::vector<std::vector<UnitPosition>>, 8> pieces_; ///< by axes and variant
};

// The reach of the pieces of a tile set, and the least distance of points whose cells have no tile in common: the
// second part of the proof in tile_certificate.hpp.

/// The smallest and largest coordinates of points, relative to the base of their cell.
struct Extents
{
    UnitPosition low{INT32_MAX, INT32_MAX, INT32_MAX};
    UnitPosition high{INT32_MIN, INT32_MIN, INT32_MIN};

    bool are_empty() const { return low[0] > high[0]; }
    void include(const UnitPosition& position);
    void include(const Extents& other);
};

/// The extents of the pieces of all variants by their axes, those of the interiors of all tiles last.
std::vector<Extents> piece_extents(const PoissonTileSet& set, const SharedPieces& pieces);

/// The lower bound of the squared distance of a point of one set from a point of the other one whose cell has no tile
/// in common with the cell of the first. The sets may be the same.
std::uint64_t squared_separation(const std::vector<Extents>& one, const std::vector<Extents>& other, int dimension);

}
