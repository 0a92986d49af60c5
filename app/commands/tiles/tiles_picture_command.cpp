// poissonlab tiles picture: the points of a toroidal tiling as a picture, a pixel a point, in an order.
#include "analysis/measures/distance_statistics.hpp"
#include "app/commands/command.hpp"
#include "app/commands/output_file.hpp"
#include "app/commands/work_options.hpp"
#include "base/errors/errors.hpp"
#include "base/geometry/relative_radius.hpp"
#include "base/images/png_file.hpp"
#include "base/images/raw_picture.hpp"
#include "tiles/poisson/tile_lookup.hpp"
#include "tiles/poisson/tile_set_file.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <vector>

namespace poissonlab {
namespace {

// The points of a toroidal tiling as a picture: a pixel a point, with its place in the pixel and its place in an order
// whose first parts are good sets.
//
// Barrett, Progressive tiling 2D blue noise point sets encoded as images, nothings.org/gamedev/blue_noise, 2021: pixels
// with alpha have a point, red and green say where in the pixel. The order is by rank, and among the tiles by Roberts'
// R2 sequence, as in runtime/point_distribution.hpp.

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

/// Red, green, blue, alpha, rows from y = 0 on. The point of pixel (i, j) is at (i + red / 255, j + green / 255)
/// pixels, rounded; it is number (alpha - 1) 256 + blue of the order. Pixels without points are 0.
///
/// `pixels`: of a side; 0: the least power of two, from 8 on, whose pixels hold one point each in any tiling, which
/// follows from the set's proven distance. Throws InputError, a line without place, for sets that are not ranked, not
/// in the plane, or without a proven distance where it is needed, for more points than alpha and blue can number
/// (65,280), and where two points are in one pixel.
PngPixels point_picture(const PoissonTileSet& tiles, const PoissonTiling& tiling, int pixels = 0)
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

constexpr auto tiles_picture_notes =
    R"help(A picture that repeats without seams, for programs that place things by a texture: pixels with alpha have a point,
red and green say where in the pixel it is, in parts of 255, rows from the top; (alpha - 1) * 256 + blue is its number in
an order whose first parts are even as well: those below a number, or where a density is above number / points.
The tile set must be ranked (tiles build --ranked). Pixels are so many, if not told, that each has at most one point.
  poissonlab tiles picture corner-c4-n64-r075.ptiles --torus 16 --out points.png)help";

struct TilesPictureOptions
{
    std::filesystem::path file, out;
    std::uint32_t torus = 0, pixels = 0; ///< pixels 0: as many as are needed
    std::uint32_t seed = 1;
    bool as_json = false;
};

/// The points of a picture on the unit torus, as those who read it find them.
PointSet points_of_picture(const PngPixels& picture)
{
    PointSet points{2, {}};
    for (int row = 0; row < picture.height; ++row)
        for (int column = 0; column < picture.width; ++column) {
            const std::uint8_t* const values = &picture.values[picture.at(column, row, 0)];
            if (values[3] == 0) continue;
            for (const double at : {column + values[0] / 255.0, row + values[1] / 255.0})
                points.coordinates.push_back(at >= picture.width ? 0 : at / picture.width);
        }
    return points;
}

void print_picture_json(const TilesPictureOptions& options, const PngPixels& picture)
{
    const PointSet points = points_of_picture(picture);
    const double distance = min_toroidal_distance(points);
    const nlohmann::ordered_json json{{"file", printable(options.out.string())},
                                      {"points", points.size()},
                                      {"pixels", picture.width},
                                      {"min_distance", distance * picture.width},
                                      {"relative_radius", relative_radius(distance, points.size(), 2)}};
    fmt::print("{}\n", json.dump(2));
}

void write_tiles_picture(const TilesPictureOptions& options)
{
    const std::filesystem::path out = checked_output("tiles picture", "--out", options.out, {{".png"}});
    const PoissonTileSet tiles = read_tile_set(options.file);
    PngPixels picture;
    try {
        picture = point_picture(tiles, {options.seed, static_cast<std::int32_t>(options.torus)},
                                static_cast<int>(options.pixels));
    } catch (const InputError& error) {
        throw InputError(fmt::format("tiles picture: {}: {}", printable(options.file.string()), error.what()));
    }
    // Colours that are not multiplied by alpha: write_png() would divide them by it.
    write_raw_picture(out, {picture.width, picture.height, SampleType::byte, {"R", "G", "B", "A"}, picture.values});
    if (options.as_json) print_picture_json(options, picture);
}

}

Command tiles_picture_command()
{
    const auto o = std::make_shared<TilesPictureOptions>();
    return {
        "picture",
        "Write the points of a torus as a picture, with an order whose parts are even",
        {{"FILE", &o->file, "The tile set (.ptiles, .json), ranked, in the plane"},
         allowing({"--torus", &o->torus, "So many tiles along each axis, whose opposite edges fit", "N", required},
                  Integers{1, 255}),
         {"--out", &o->out, "The picture (.png)", "PICTURE", required},
         allowing({"--pixels", &o->pixels, "Pixels along each axis; default: a power of two with a point a pixel", "N"},
                  Integers{8, 8192}),
         seed_option(o->seed),
         json_option(o->as_json, "Print the points, pixels, and least distance as JSON")},
        tiles_picture_notes,
        action_on(o, write_tiles_picture)};
}

}
