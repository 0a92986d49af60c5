// poissonlab tiles picture: the points of a toroidal tiling as a picture, a pixel a point, in an order.
#include "analysis/measures/distance_statistics.hpp"
#include "app/commands/command.hpp"
#include "app/commands/output_file.hpp"
#include "app/commands/tiles/point_picture.hpp"
#include "app/commands/work_options.hpp"
#include "base/errors/errors.hpp"
#include "base/geometry/relative_radius.hpp"
#include "base/images/raw_picture.hpp"
#include "tiles/poisson/tile_set_file.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <memory>

namespace poissonlab {
namespace {

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
