// Places of tiles as other tiles see them that may have these beside them, and grids of places to find near ones.
#pragma once

#include "tiles/recursive/recursive_tile_set.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace poissonlab {

/// A place in a tile or beside it, in units of 2^-32 of its side.
using PlanePlace = std::array<std::int64_t, 2>;

inline constexpr std::int64_t tile_side = std::int64_t{1} << 32;

inline PlanePlace plane_place(const RecursivePlace& place) { return {place[0], place[1]}; }

/// The squared distance of places less than 2^31 units from each other along both axes.
inline std::uint64_t squared_between(const PlanePlace& a, const PlanePlace& b)
{
    const std::int64_t x = a[0] - b[0], y = a[1] - b[1];
    return static_cast<std::uint64_t>(x * x) + static_cast<std::uint64_t>(y * y);
}

/// A tile that sees another one at an offset in tiles.
struct TileView
{
    std::size_t by = 0;
    std::array<int, 2> offset{};
};

/// The ways in which a tile is seen: by itself at no offset, and by all that it may lie beside.
const std::vector<TileView>& views_of(std::size_t tile);

/// Shows a tile's place as all tiles see it, by visit(tile, place), that are not farther away than `reach`.
template <class Visit>
void visit_views(std::size_t tile, const RecursivePlace& place, std::int64_t reach, const Visit& visit)
{
    for (const TileView& view : views_of(tile)) {
        const PlanePlace seen{place[0] + view.offset[0] * tile_side, place[1] + view.offset[1] * tile_side};
        if (std::min(seen[0], seen[1]) >= -reach && std::max(seen[0], seen[1]) < tile_side + reach)
            visit(view.by, seen);
    }
}

/// Places in square cells of a tile; those beside it are in the cells at its border.
class PlaceGrid
{
public:
    /// Makes a grid for about so many places.
    explicit PlaceGrid(std::size_t places);

    void add(const PlanePlace& place);

    const PlanePlace& operator[](std::size_t i) const { return places_[i]; }

    /// Shows the numbers of all places that are no farther away than `reach` along both axes.
    template <class Visit>
    void visit_near(const PlanePlace& place, std::int64_t reach, const Visit& visit) const
    {
        for (std::int64_t y = index(place[1] - reach); y <= index(place[1] + reach); ++y)
            for (std::int64_t x = index(place[0] - reach); x <= index(place[0] + reach); ++x)
                for (const std::uint32_t i : lists_[static_cast<std::size_t>(y << bits_ | x)])
                    if (std::abs(places_[i][0] - place[0]) <= reach && std::abs(places_[i][1] - place[1]) <= reach)
                        visit(i);
    }

private:
    std::int64_t index(std::int64_t coordinate) const
    {
        return std::clamp<std::int64_t>(coordinate, 0, tile_side - 1) >> (32 - bits_);
    }

    int bits_ = 0;
    std::vector<PlanePlace> places_;
    std::vector<std::vector<std::uint32_t>> lists_;
};

}
