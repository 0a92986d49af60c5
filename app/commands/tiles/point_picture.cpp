#include "app/commands/tiles/point_picture.hpp"

#include "base/errors/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <tuple>
#include <vector>

namespace poissonlab {
namespace {

constexpr std::size_t most_numbers = 255 * 256; // alpha is at least 1

/// A point on the torus, in pixels, with what decides its place in the order: the rank, then the turn of its tile.
struct PicturePoint
{
    std::uint32_t rank = 0, turn = 0;
    std::array<double, 2> place{};

    auto operator<=>(const PicturePoint&) const = default;
};

/// Points one after the other, as a set that grows.
std::vector<PicturePoint> points_in_order(const PoissonTileSet& tiles, const PoissonTiling& tiling, int pixels)
{
    const ptiles_tiling runtime = runtime_tiling(tiles, tiling);
    const std::uint32_t n = tiles.parameters.points_per_tile;
    std::vector<PicturePoint> points;
    for (std::int32_t j = 0; j < tiling.period; ++j)
        for (std::int32_t i = 0; i < tiling.period; ++i) {
            const std::uint32_t tile = ptiles_tile(&runtime, i, j, 0);
            const std::uint16_t* numbers = ptiles_points(&runtime.set, tile);
            for (std::uint32_t index = 0; index < n; ++index) {
                PicturePoint point{tiles.ranks[std::size_t{tile} * n + index],
                                   static_cast<std::uint32_t>(i) * 3242174889U +
                                       static_cast<std::uint32_t>(j) * 2447445414U,
                                   {}};
                for (std::size_t axis = 0; axis < 2; ++axis) {
                    const double at = (axis == 0 ? i : j) + ptiles_coordinate(&runtime.set, numbers[2 * index + axis]);
                    point.place[axis] = (at - tiling.period * std::floor(at / tiling.period)) / tiling.period * pixels;
                }
                points.push_back(point);
            }
        }
    std::ranges::sort(points);
    return points;
}

void check_picture(const PoissonTileSet& tiles, std::int32_t tiles_along_axis)
{
    const PoissonTileParameters& p = tiles.parameters;
    if (p.dimension != 2) throw InputError("tiles of space: must be a tile set in the plane");
    if (!p.ranked) throw InputError("the set is not ranked: tiles build --ranked makes one that is");
    const std::uint64_t side = static_cast<std::uint64_t>(tiles_along_axis), count = side * side * p.points_per_tile;
    if (count > most_numbers)
        throw InputError(
            fmt::format("{0} x {0} tiles have {1} points: must be at most {2}", side, count, most_numbers));
}

/// Two points of a pixel are less than its diagonal apart.
int side_of_picture(const PoissonTileSet& tiles, std::int32_t tiles_along_axis)
{
    if (tiles.squared_min_distance == 0) throw InputError("the set has no proven distance: the pixels must be told");
    const double least = std::sqrt(static_cast<double>(tiles.squared_min_distance)) / tile_units;
    int side = 8;
    while (side * least < std::numbers::sqrt2 * tiles_along_axis) side *= 2;
    return side;
}

}

PngPixels point_picture(const PoissonTileSet& tiles, const PoissonTiling& tiling, int pixels)
{
    check_picture(tiles, tiling.period);
    if (pixels == 0) pixels = side_of_picture(tiles, tiling.period);
    PngPixels picture{pixels, pixels, 4, {}};
    picture.values.resize(picture.at(0, pixels, 0));
    const std::vector<PicturePoint> points = points_in_order(tiles, tiling, pixels);
    for (std::size_t number = 0; number < points.size(); ++number) {
        std::array<int, 2> pixel{};
        for (std::size_t axis = 0; axis < 2; ++axis) // the last bit of a quotient may reach the border
            pixel[axis] = std::min(static_cast<int>(points[number].place[axis]), pixels - 1);
        std::uint8_t* const values = &picture.values[picture.at(pixel[0], pixel[1], 0)];
        if (values[3] != 0)
            throw InputError(fmt::format("two points are in the pixel {}, {} of {} x {}: more pixels keep them apart",
                                         pixel[0], pixel[1], pixels, pixels));
        for (std::size_t axis = 0; axis < 2; ++axis)
            values[axis] = static_cast<std::uint8_t>(std::lround(255 * (points[number].place[axis] - pixel[axis])));
        values[2] = static_cast<std::uint8_t>(number % 256);
        values[3] = static_cast<std::uint8_t>(number / 256 + 1);
    }
    return picture;
}

}
