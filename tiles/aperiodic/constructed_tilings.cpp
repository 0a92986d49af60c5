#include "tiles/aperiodic/constructed_tilings.hpp"

#include "base/errors/errors.hpp"
#include "base/programs/interrupt.hpp"
#include "base/random/random.hpp"

#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <map>
#include <stdexcept>

namespace poissonlab {
namespace {

constexpr std::uint8_t none = 255; // a tile that has no second row or column

using Successors = std::array<std::uint8_t, 16>;
constexpr Successors top_left{2, 9, 11, 8, 11, 8, 9, 9, 1, 6, 7, 2, 10, 8, 10, 9};
constexpr Successors bottom_left{none, 0, 0, 0, 0, 0, 0, 0, 13, 15, 12, 15, none, none, none, none};
constexpr Successors top_right{none, 3, 3, 1, 3, 7, 3, 5, none, none, none, none, 4, 1, 2, 5};
constexpr Successors bottom_right{none, 12, 14, 13, 12, 12, 14, 13, none, none, none, none, none, none, none, none};

/// A rectangle of tiles, rows from north to south.
struct Patch
{
    std::size_t width = 1;
    std::vector<std::uint8_t> tiles;

    std::size_t height() const { return tiles.size() / width; }
};

Patch substituted(const Patch& patch)
{
    Patch larger{0, {}};
    for (std::size_t row = 0; row < patch.height(); ++row) {
        const std::uint8_t* const tiles = patch.tiles.data() + row * patch.width;
        const auto append = [&](const Successors& left, const Successors& right) {
            const std::size_t before = larger.tiles.size();
            for (std::size_t column = 0; column < patch.width; ++column) {
                larger.tiles.push_back(left[tiles[column]]);
                if (right[tiles[column]] != none) larger.tiles.push_back(right[tiles[column]]);
            }
            larger.width = larger.tiles.size() - before;
        };
        append(top_left, top_right);
        if (bottom_left[tiles[0]] != none) append(bottom_left, bottom_right);
    }
    return larger;
}

}

std::vector<ListPlace> ammann_tiles_of(const TileWindow& window, std::uint64_t seed)
{
    const auto is_inside = [](std::int64_t first, std::uint64_t size) {
        return first >= ammann_first && first < ammann_end && size <= static_cast<std::uint64_t>(ammann_end - first);
    };
    if (!is_inside(window.x, window.width) || !is_inside(window.y, window.height))
        throw InputError(fmt::format("columns and rows of a tiling by substitution are from {} to {}", ammann_first,
                                     ammann_end - 1));
    const auto west = static_cast<std::size_t>(window.x - ammann_first);
    const auto south = static_cast<std::size_t>(window.y - ammann_first);
    const std::size_t east = west + static_cast<std::size_t>(window.width);
    const std::size_t north = south + static_cast<std::size_t>(window.height);
    const auto words = philox({0, 0, 0, 0}, stream_key(seed, Purpose::ammann_tiling, 0));
    Patch patch{1, {static_cast<std::uint8_t>(words[0] % 16)}};
    while (patch.width < east || patch.height() < north) {
        stop_if_interrupted();
        patch = substituted(patch);
    }
    std::vector<ListPlace> tiles;
    tiles.reserve(static_cast<std::size_t>(window.width * window.height));
    for (std::size_t y = north; y-- > south;) {
        const auto row = patch.tiles.begin() + static_cast<std::ptrdiff_t>((patch.height() - 1 - y) * patch.width);
        tiles.insert(tiles.end(), row + static_cast<std::ptrdiff_t>(west), row + static_cast<std::ptrdiff_t>(east));
    }
    return tiles;
}

namespace {

/// The quotient by 2, rounded down.
std::int64_t half(std::int64_t value) { return value >> 1; }

/// The Wang tiles below a window of corner tiles.
TileWindow covered_window(CornerConstruction construction, const TileWindow& window)
{
    const auto end_x = window.x + static_cast<std::int64_t>(window.width);
    const auto end_y = window.y + static_cast<std::int64_t>(window.height);
    const auto between = [](std::int64_t x, std::int64_t y, std::int64_t to_x, std::int64_t to_y) {
        return TileWindow{x, y, static_cast<std::uint64_t>(to_x - x), static_cast<std::uint64_t>(to_y - y)};
    };
    switch (construction) {
    case CornerConstruction::diagonal:
        return between(window.x, window.y, end_x + 1, end_y + 1);
    case CornerConstruction::horizontal:
        return between(window.x, window.y, end_x + 1, end_y);
    case CornerConstruction::vertical:
        return between(window.x, window.y, end_x, end_y + 1);
    case CornerConstruction::subdivision:
        return between(half(window.x), half(window.y), half(end_x - 1) + 1, half(end_y - 1) + 1);
    case CornerConstruction::rotation:
        return between(half(window.x - end_y + 1), half(window.x + window.y), half(end_x - 1 - window.y) + 2,
                       half(end_x + end_y - 2) + 2);
    }
    return {};
}

/// A window of a tiling with Wang tiles, by places.
class WangWindow
{
public:
    WangWindow(const WangList& wang, const TileWindow& window, std::vector<ListPlace> places)
        : wang_(wang), window_(window), places_(std::move(places))
    {}

    ListPlace place(std::int64_t x, std::int64_t y) const
    {
        const auto column = static_cast<std::uint64_t>(x - window_.x);
        const auto row = window_.height - 1 - static_cast<std::uint64_t>(y - window_.y);
        return places_.at(static_cast<std::size_t>(row * window_.width + column));
    }
    const WangTile& tile(std::int64_t x, std::int64_t y) const { return wang_.tiles[place(x, y)]; }

private:
    const WangList& wang_;
    TileWindow window_;
    std::vector<ListPlace> places_;
};

/// A white tile lies over a Wang tile, a black one over a corner of four, which is the upper right corner of tile (x,
/// y).
CornerTile turned_tile(const WangWindow& tiles, Color first_vertical, std::int64_t column, std::int64_t row)
{
    const std::int64_t x = half(column - row), y = half(column + row);
    if ((column + row) % 2 == 0) {
        const WangTile& t = tiles.tile(x, y);
        return {t.north, first_vertical + t.east, t.south, first_vertical + t.west};
    }
    return {first_vertical + tiles.tile(x, y + 1).east, tiles.tile(x + 1, y + 1).south,
            first_vertical + tiles.tile(x, y).east, tiles.tile(x, y + 1).south};
}

CornerTile divided_tile(const WangWindow& tiles, const WangList& wang, std::int64_t column, std::int64_t row)
{
    const std::int64_t x = half(column), y = half(row);
    const WangTile& t = tiles.tile(x, y);
    const Color middle = color_count(wang) + tiles.place(x, y);
    const Color star = color_count(wang) + static_cast<Color>(wang.tiles.size());
    const bool is_east = column % 2 != 0, is_north = row % 2 != 0;
    if (is_north)
        return is_east ? CornerTile{star, t.east, middle, t.north} : CornerTile{t.north, middle, t.west, star};
    return is_east ? CornerTile{t.east, star, t.south, middle} : CornerTile{middle, t.south, star, t.west};
}

CornerTile tile_at(const WangWindow& tiles, const WangList& wang, CornerConstruction construction, std::int64_t x,
                   std::int64_t y)
{
    switch (construction) {
    case CornerConstruction::diagonal:
        return {tiles.place(x + 1, y + 1), tiles.place(x + 1, y), tiles.place(x, y), tiles.place(x, y + 1)};
    case CornerConstruction::horizontal: {
        const WangTile &west = tiles.tile(x, y), &east = tiles.tile(x + 1, y);
        return {east.north, east.south, west.south, west.north};
    }
    case CornerConstruction::vertical: {
        const WangTile &south = tiles.tile(x, y), &north = tiles.tile(x, y + 1);
        return {north.east, south.east, south.west, north.west};
    }
    case CornerConstruction::rotation:
        return turned_tile(tiles, wang.colors.horizontal, x, y);
    case CornerConstruction::subdivision:
        return divided_tile(tiles, wang, x, y);
    }
    return {};
}

std::array<Color, 4> key_of(const CornerTile& t) { return {t.north_east, t.south_east, t.south_west, t.north_west}; }

}

std::vector<ListPlace> corner_tiles_of(const WangList& wang, const CornerList& corners, CornerConstruction construction,
                                       const TileWindow& window, const WindowMaker& make_window)
{
    std::map<std::array<Color, 4>, ListPlace> places;
    for (ListPlace place = 0; place < corners.tiles.size(); ++place) places[key_of(corners.tiles[place])] = place;
    const TileWindow covered = covered_window(construction, window);
    const WangWindow below(wang, covered, make_window(covered));
    std::vector<ListPlace> tiles;
    for (std::uint64_t row = window.height; row-- > 0;)
        for (std::uint64_t column = 0; column < window.width; ++column) {
            const auto found =
                places.find(key_of(tile_at(below, wang, construction, window.x + static_cast<std::int64_t>(column),
                                           window.y + static_cast<std::int64_t>(row))));
            if (found == places.end()) throw std::logic_error("a tiling has corner tiles that the set does not have");
            tiles.push_back(found->second);
        }
    return tiles;
}

}
