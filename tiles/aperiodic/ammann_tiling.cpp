#include "tiles/aperiodic/ammann_tiling.hpp"

#include "base/errors/errors.hpp"
#include "base/programs/interrupt.hpp"
#include "base/random/random.hpp"

#include <fmt/format.h>

#include <array>
#include <cstddef>

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

}
