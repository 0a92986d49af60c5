// Small sets of tiles whose points have classes, and the distances that occur around their tiles, by brute force.
#pragma once

#include "tests/support/small_tile_sets.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace poissonlab {

inline PoissonTileParameters class_parameters(std::uint32_t colors, std::vector<std::uint32_t> points,
                                              double relative_radius)
{
    PoissonTileParameters p = tile_set_parameters(PoissonTileKind::corner, 2, colors, 0, 0);
    set_classes(p, classes_of_radius(std::move(points), relative_radius, 2));
    return p;
}

/// By file format: the digits of a tile's number are the colours of its corners NE, SE, SW, NW.
inline unsigned tile_between(unsigned ne, unsigned se, unsigned sw, unsigned nw)
{
    return ((ne * 2 + se) * 2 + sw) * 2 + nw;
}

/// The least squared distance of two classes between the middle tile of 3 x 3 tiles and all of them, over all colours
/// of their 16 corners; a tile has two colours of corners.
inline std::uint64_t least_in_all_surroundings(const PoissonTileSet& set, std::uint32_t one, std::uint32_t other)
{
    // Each pair of tiles is looked at once for each offset, however many surroundings have it.
    const TileClasses& classes = set.parameters.classes;
    const auto least_of = [&](unsigned middle, unsigned tile, int x, int y) {
        std::uint64_t least = UINT64_MAX;
        for (std::uint32_t i = 0; i < classes.points[one]; ++i)
            for (std::uint32_t j = 0; j < classes.points[other]; ++j) {
                if (x == 0 && y == 0 && one == other && i == j) continue;
                const UnitPosition a = set.position(middle, classes.first_point(one) + i);
                const UnitPosition b = set.position(tile, classes.first_point(other) + j);
                const std::int64_t dx = b[0] + x * 65536 - a[0], dy = b[1] + y * 65536 - a[1];
                least = std::min(least, static_cast<std::uint64_t>(dx * dx + dy * dy));
            }
        return least;
    };
    std::uint64_t least = UINT64_MAX;
    std::array<std::array<bool, 16 * 16>, 9> is_seen{};
    for (unsigned colors = 0; colors < 1U << 16; ++colors) {
        const auto color = [&](unsigned x, unsigned y) { return colors >> (4 * y + x) & 1; };
        const auto tile_at = [&](unsigned x, unsigned y) {
            return tile_between(color(x + 1, y + 1), color(x + 1, y), color(x, y), color(x, y + 1));
        };
        const unsigned middle = tile_at(1, 1);
        for (unsigned y = 0; y < 3; ++y)
            for (unsigned x = 0; x < 3; ++x) {
                if (std::exchange(is_seen[3 * y + x][16 * middle + tile_at(x, y)], true)) continue;
                least =
                    std::min(least, least_of(middle, tile_at(x, y), static_cast<int>(x) - 1, static_cast<int>(y) - 1));
            }
    }
    return least;
}

}
