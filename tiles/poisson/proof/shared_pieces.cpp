#include "tiles/poisson/proof/shared_pieces.hpp"

#include "base/errors/errors.hpp"
#include "tiles/poisson/proof/closure_measures.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <bit>

namespace poissonlab {
namespace {

/// The side of the tile that a piece is on: bit k of the cell's `upper`.
std::uint8_t side_of(const PlacedPiece& piece)
{
    return static_cast<std::uint8_t>(piece.base[0] | piece.base[1] << 1 | piece.base[2] << 2);
}

TileCell cell_of(const PlacedPiece& piece) { return {piece.axes, side_of(piece)}; }

std::uint64_t cell_number(const TileCell& cell) { return std::uint64_t{cell.axes} << 3 | cell.upper; }

/// "edge (x, 1)": the upper one of those along x.
std::string described(const TileCell& cell, int dimension)
{
    std::array<std::string, 3> place;
    for (unsigned k = 0; k < 3; ++k)
        place[k] = cell.axes >> k & 1 ? std::string(1, "xyz"[k]) : std::to_string(cell.upper >> k & 1);
    constexpr std::array names{"corner", "edge", "face"};
    return fmt::format("{} ({})", names[static_cast<std::size_t>(std::popcount(cell.axes))],
                       fmt::join(place.begin(), place.begin() + dimension, ", "));
}

}

SortedTile::SortedTile(const PoissonTileSet& set, const TileRegions& regions, std::uint32_t tile)
{
    const std::span<const std::uint16_t> points = set.tile(tile);
    const auto dimension = static_cast<std::size_t>(regions.dimension);
    numbers_.reserve(points.size() / dimension);
    for (std::size_t i = 0; i < points.size(); i += dimension) {
        const auto position = points.subspan(i, dimension);
        std::uint64_t number = cell_number(regions.cell_of(position));
        for (std::size_t k = 0; k < 3; ++k) number = number << tile_bits | (k < dimension ? position[k] : 0u);
        numbers_.push_back(number);
    }
    std::ranges::sort(numbers_);
}

std::span<const std::uint64_t> SortedTile::in(const TileCell& cell) const
{
    const std::uint64_t first = cell_number(cell) << 3 * tile_bits;
    const auto begin = std::ranges::lower_bound(numbers_, first);
    const auto end = std::lower_bound(begin, numbers_.end(), first + (std::uint64_t{1} << 3 * tile_bits));
    return {begin, end};
}

const std::uint64_t* SortedTile::duplicate() const
{
    const auto found = std::ranges::adjacent_find(numbers_);
    return found == numbers_.end() ? nullptr : &*found;
}

UnitPosition SortedTile::position(std::uint64_t number)
{
    const auto coordinate = [&](int shift) {
        return static_cast<std::int32_t>(static_cast<std::uint16_t>(number >> shift));
    };
    return {coordinate(2 * tile_bits), coordinate(tile_bits), coordinate(0)};
}

SharedPieces::SharedPieces(const PoissonTileSet& set, const TileRegions& regions) : set_(set), regions_(regions)
{
    find_parts();
    join_parts();
    check_tiles();
}

SharedPieces::Part& SharedPieces::part(const PlacedPiece& piece)
{
    return parts_[piece.axes][piece.variant][side_of(piece)];
}

/// Every part from the lowest tile that has it.
void SharedPieces::find_parts()
{
    std::size_t missing = 0;
    for (std::uint8_t axes = 0; axes < all_axes(regions_.dimension); ++axes) {
        parts_[axes].resize(piece_count(set_.parameters, axes));
        missing += parts_[axes].size() << (regions_.dimension - std::popcount(axes));
    }
    for (std::uint32_t tile = 0; tile < set_.parameters.tiles && missing > 0; ++tile) {
        const SortedTile points(set_, regions_, tile);
        for (const PlacedPiece& piece : pieces_around(set_.parameters, tile)) {
            Part& there = part(piece);
            if (there.tile != UINT32_MAX) continue;
            const auto found = points.in(cell_of(piece));
            there = {tile, {found.begin(), found.end()}};
            --missing;
        }
    }
}

/// Whole variants: a part on the tile's upper side along an axis lies on the lower side of the cell.
void SharedPieces::join_parts()
{
    for (std::uint8_t axes = 0; axes < all_axes(regions_.dimension); ++axes) {
        for (const auto& sides : parts_[axes]) {
            auto& piece = pieces_[axes].emplace_back();
            for (unsigned side = 0; side < sides.size(); ++side) {
                for (const std::uint64_t number : sides[side].points) {
                    UnitPosition position = SortedTile::position(number);
                    for (unsigned k = 0; k < 3; ++k)
                        if (side >> k & 1) position[k] -= tile_units;
                    piece.push_back(position);
                }
            }
        }
    }
}

const PlacedPiece* SharedPieces::first_disagreement(std::uint32_t tile, const std::vector<PlacedPiece>& pieces) const
{
    const SortedTile points(set_, regions_, tile);
    const auto found = std::ranges::find_if(pieces, [&](const PlacedPiece& piece) {
        return !std::ranges::equal(points.in(cell_of(piece)), parts_[piece.axes][piece.variant][side_of(piece)].points);
    });
    return found == pieces.end() ? nullptr : &*found;
}

bool SharedPieces::is_sound(std::uint32_t tile) const
{
    return SortedTile(set_, regions_, tile).duplicate() == nullptr &&
           first_disagreement(tile, pieces_around(set_.parameters, tile)) == nullptr;
}

/// Names the lowest tile that is wrong, whatever the number of threads.
void SharedPieces::check_tiles() const
{
    const std::uint32_t tiles = set_.parameters.tiles;
    const std::uint32_t wrong = first_tile_where(tiles, [&](std::uint32_t tile) { return !is_sound(tile); });
    if (wrong < tiles) refuse(wrong);
}

void SharedPieces::refuse(std::uint32_t tile) const
{
    const SortedTile points(set_, regions_, tile);
    if (const std::uint64_t* equal = points.duplicate()) {
        const UnitPosition at = SortedTile::position(*equal);
        throw InputError(fmt::format("tile {}: two points at ({}): must differ", tile,
                                     fmt::join(at.begin(), at.begin() + regions_.dimension, ", ")));
    }
    const std::vector<PlacedPiece> pieces = pieces_around(set_.parameters, tile);
    const PlacedPiece& piece = *first_disagreement(tile, pieces);
    throw InputError(fmt::format("tile {}: points near its {}, variant {}, differ from tile {}'s: must be the same in "
                                 "all tiles that have it",
                                 tile, described(cell_of(piece), regions_.dimension), piece.variant,
                                 parts_[piece.axes][piece.variant][side_of(piece)].tile));
}

void SharedPieces::closure(std::uint32_t tile, std::vector<UnitPosition>& points) const
{
    points.clear();
    const SortedTile own(set_, regions_, tile);
    for (const std::uint64_t number : own.in({all_axes(regions_.dimension), 0}))
        points.push_back(SortedTile::position(number));
    for (const PlacedPiece& placed : pieces_around(set_.parameters, tile)) {
        for (UnitPosition position : piece(placed.axes, placed.variant)) {
            for (std::size_t k = 0; k < 3; ++k) position[k] += placed.base[k] * tile_units;
            points.push_back(position);
        }
    }
}

namespace {

/// The extents of the interiors of all tiles.
Extents interior_extents(const PoissonTileSet& set, const TileRegions& regions)
{
    const auto dimension = static_cast<std::size_t>(set.parameters.dimension);
    return tbb::parallel_reduce(
        tbb::blocked_range<std::uint32_t>(0, set.parameters.tiles), Extents{},
        [&](const tbb::blocked_range<std::uint32_t>& range, Extents extents) {
            for (std::uint32_t tile = range.begin(); tile < range.end(); ++tile) {
                const std::span<const std::uint16_t> points = set.tile(tile);
                for (std::size_t i = 0; i < points.size(); i += dimension) {
                    const auto point = points.subspan(i, dimension);
                    if (regions.cell_of(point).axes == all_axes(set.parameters.dimension))
                        extents.include(UnitPosition{point[0], point[1], dimension == 3 ? point[2] : 0});
                }
            }
            return extents;
        },
        [](Extents a, const Extents& b) {
            a.include(b);
            return a;
        });
}

}

void Extents::include(const Extents& other)
{
    if (other.are_empty()) return;
    include(other.low);
    include(other.high);
}

void Extents::include(const UnitPosition& position)
{
    for (std::size_t k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], position[k]);
        high[k] = std::max(high[k], position[k]);
    }
}

std::vector<Extents> piece_extents(const PoissonTileSet& set, const SharedPieces& pieces)
{
    std::vector<Extents> extents(all_axes(set.parameters.dimension));
    for (std::uint8_t axes = 0; axes < extents.size(); ++axes) {
        for (std::uint32_t variant = 0; variant < piece_count(set.parameters, axes); ++variant)
            for (const UnitPosition& position : pieces.piece(axes, variant)) extents[axes].include(position);
    }
    extents.push_back(interior_extents(set, pieces.regions()));
    return extents;
}

std::uint64_t squared_separation(const std::vector<Extents>& one, const std::vector<Extents>& other, int dimension)
{
    std::int64_t smallest = 2 * tile_units; // where no cell has a point, places two above
    const auto consider = [&](const std::vector<Extents>& lowers, const std::vector<Extents>& uppers) {
        for (const Extents& lower : lowers) {
            for (std::size_t axes = 0; axes < uppers.size(); ++axes) {
                const Extents& upper = uppers[axes];
                if (lower.are_empty() || upper.are_empty()) continue;
                for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k) {
                    const int places = axes >> k & 1 ? 1 : 2;
                    smallest = std::min<std::int64_t>(smallest, places * tile_units + upper.low[k] - lower.high[k]);
                }
            }
        }
    };
    consider(one, other);
    consider(other, one);
    return static_cast<std::uint64_t>(std::max<std::int64_t>(smallest, 0) * std::max<std::int64_t>(smallest, 0));
}

}
