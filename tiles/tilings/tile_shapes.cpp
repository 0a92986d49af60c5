#include "tiles/tilings/tile_shapes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace poissonlab {
namespace {

constexpr double corner_disk_radius = 11.0 / 32;
constexpr std::size_t arc_steps = 8; // of a quarter of a disk: it is within 0.002 sides of round

/// One channel of a saturated colour; `turns` around the colour circle.
int channel(double turns)
{
    const double distance = std::abs(turns - std::floor(turns) - 0.5) * 6; // 3 at the channel's own hue
    return static_cast<int>(std::lround(255 * std::min(1.0, std::max(0.0, distance - 1))));
}

/// The place `along` a side from its first corner and `inwards` from it; sides are counted from the southern one
/// counterclockwise.
TilePoint beside_side(std::size_t side, double along, double inwards)
{
    switch (side) {
    case 0:
        return {along, inwards};
    case 1:
        return {1 - inwards, along};
    case 2:
        return {1 - along, 1 - inwards};
    default:
        return {inwards, 1 - along};
    }
}

}

std::string tile_color(Color color)
{
    static const std::array<std::string, 8> known{"#d55e00", "#f0e442", "#009e73", "#56b4e9",
                                                  "#0072b2", "#cc79a7", "#e69f00", "#808080"};
    if (color < known.size()) return known[color];
    const double turns = color * 0.6180339887498949; // golden section: far from those before
    return fmt::format("#{:02x}{:02x}{:02x}", channel(turns), channel(turns - 1.0 / 3), channel(turns - 2.0 / 3));
}

std::vector<TileShape> shapes_of(const WangTile& tile)
{
    std::vector<TileShape> shapes;
    for (const Color color : {tile.south, tile.east, tile.north, tile.west}) {
        const std::size_t side = shapes.size();
        shapes.push_back({color, {beside_side(side, 0, 0), beside_side(side, 1, 0), {0.5, 0.5}}});
    }
    return shapes;
}

std::vector<TileShape> shapes_of(const CornerTile& tile)
{
    std::vector<TileShape> shapes;
    for (const Color color : {tile.south_west, tile.south_east, tile.north_east, tile.north_west}) {
        const std::size_t corner = shapes.size();
        TileShape quarter{color, {beside_side(corner, 0, 0)}};
        for (std::size_t step = 0; step <= arc_steps; ++step) {
            const double angle = std::numbers::pi / 2 * static_cast<double>(step) / arc_steps;
            quarter.corners.push_back(
                beside_side(corner, corner_disk_radius * std::cos(angle), corner_disk_radius * std::sin(angle)));
        }
        shapes.push_back(std::move(quarter));
    }
    return shapes;
}

std::vector<TileShape> shapes_of(const Domino& tile)
{
    return {{tile.west, {{0, 0}, {0.5, 0}, {0.5, 1}, {0, 1}}}, {tile.east, {{0.5, 0}, {1, 0}, {1, 1}, {0.5, 1}}}};
}

}
