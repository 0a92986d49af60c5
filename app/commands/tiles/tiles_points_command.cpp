// poissonlab tiles points: the points of a window of a Poisson disk tiling as a point file, streamed.
#include "app/commands/command.hpp"
#include "app/commands/point_target.hpp"
#include "app/commands/tiles/window_density.hpp"
#include "base/errors/errors.hpp"
#include "base/points/point_file.hpp"
#include "base/programs/interrupt.hpp"
#include "host/tile_points/point_levels.hpp"
#include "tiles/poisson/tile_set_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace poissonlab {
namespace {

constexpr auto tiles_points_notes =
    R"help(Coordinates are in tiles, from the lowest corner of the window. Rows of tiles from south to north (3D: layers
from the bottom), in each from west to east. The seed chooses the tiling: windows of the same seed fit together.
The format follows the extension: .npy, .csv, .usda, .ply (ascii), or text; the latter two say `domain 0:N`, the longest
side of the window, so that poissonlab analyze takes the points of a square one; for .npy and .csv, --domain N. Edges of
the window are not those of a torus: --set analysis.window=true.
With --density, points are left out: those of the highest ranks (tiles build --ranked), of sets without ranks any. No
point moves. A number is the part that is left; a picture or a formula in x and y, laid over the window, says it for each
place, in parts of its largest value.
  poissonlab tiles points corner.ptiles --window -8 -8 16 16 --out points.npy
  poissonlab tiles points ranked.ptiles --window 0 0 30 20 --density photo.jpg --density-from ink --out dots.ply
  poissonlab tiles points ranked.ptiles --window 0 0 20 20 --density "exp(-8*(x^2+y^2))" --out blob.txt)help";

struct TilesPointsOptions
{
    std::filesystem::path file;       ///< the tile set
    std::vector<std::int64_t> window; ///< X Y W H; 3D: X Y Z W H D
    std::uint32_t seed = 1;
    std::string density = "1"; ///< a number, the name of a picture, or a formula
    std::string density_from = "light";
    std::filesystem::path out;
    std::string device;
};

TileBlock checked_window(const std::vector<std::int64_t>& numbers, int dimension)
{
    const std::string option = fmt::format("tiles points: --window {}", fmt::join(numbers, " "));
    const auto axes = static_cast<std::size_t>(dimension);
    if (numbers.size() != 2 * axes)
        throw InputError(fmt::format("{}: must be {}", option, dimension == 3 ? "X Y Z W H D" : "X Y W H"));
    TileBlock block;
    for (std::size_t axis = 0; axis < axes; ++axis) {
        const std::int64_t size = numbers[axes + axis];
        if (numbers[axis] < INT32_MIN || numbers[axis] > INT32_MAX || size < 1 || size > UINT32_MAX)
            throw InputError(option + ": places have 32 bits, and sizes are at least 1");
        block.lowest[axis] = static_cast<std::int32_t>(numbers[axis]);
        block.size[axis] = static_cast<std::uint32_t>(size);
    }
    check(block, dimension);
    return block;
}

/// The comment in the file; its domain is the square (cube) that the window fits into.
std::string comment_of(const TilesPointsOptions& options, const TileBlock& block)
{
    const std::string density = options.density == "1" ? "" : fmt::format(" --density {}", printable(options.density));
    return fmt::format(
        "domain 0:{}\npoissonlab tiles points {} --window {} --seed {}{}: coordinates in tiles, from the "
        "lowest corner of the window",
        std::ranges::max(block.size), options.file.filename().string(), fmt::join(options.window, " "), options.seed,
        density);
}

/// With chains, points lie outside of their tiles' squares: those of a window are looked for one tile farther.
TileBlock searched_block(const TileBlock& window, const PoissonTileParameters& p)
{
    if (p.border == TileBorder::strip) return window;
    TileBlock block = window;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        constexpr std::uint32_t most = 65'534;
        if (window.size[axis] > most)
            throw InputError(fmt::format("tiles points: --window: {} tiles along an axis: must be at most {} for tiles "
                                         "with chains",
                                         window.size[axis], most));
        --block.lowest[axis];
        block.size[axis] += 2;
    }
    check(block, p.dimension);
    return block;
}

/// Hands on the coordinates, in tiles, of the points of a window, in pieces.
class WindowPoints
{
public:
    /// `tiles` and `density` must outlive this.
    WindowPoints(const Device& device, const PoissonTileSet& tiles, const TileBlock& window,
                 const WindowDensity& density)
        : tiles_(tiles), window_(window), density_(density), block_(searched_block(window, tiles.parameters)),
          generator_(device, tiles)
    {}

    std::size_t count(std::uint32_t seed)
    {
        if (!has_overhang() && density_.is_full()) return window_.tiles() * tiles_.parameters.points_per_tile;
        std::size_t points = 0;
        stream(seed, [&](std::span<const double> coordinates) { points += coordinates.size() / dimension(); });
        return points;
    }

    void stream(std::uint32_t seed, const PointSink& sink)
    {
        PointLevels levels(tiles_, {seed, 0}, block_);
        generator_.stream({seed, 0}, block_, [&](std::span<const std::uint32_t> units) {
            stop_if_interrupted();
            coordinates_.clear();
            std::span<const double> level;
            if (!density_.is_full()) level = levels.next(units.size() / generator_.values_per_tile());
            for (std::size_t i = 0; i < units.size() / dimension(); ++i) {
                const std::size_t before = coordinates_.size();
                if (append_if_inside(units.subspan(i * dimension(), dimension())) && !level.empty() &&
                    !density_.keeps(std::span(coordinates_).subspan(before), level[i]))
                    coordinates_.resize(before);
            }
            sink(coordinates_);
        });
    }

private:
    bool has_overhang() const { return tiles_.parameters.border == TileBorder::chain; }
    std::size_t dimension() const { return static_cast<std::size_t>(tiles_.parameters.dimension); }

    /// Appends a point and says so, unless it is outside of the window.
    bool append_if_inside(std::span<const std::uint32_t> units)
    {
        constexpr std::uint32_t tile = 65536;
        const std::uint32_t margin = has_overhang() ? tile : 0; // of the block around the window
        for (std::size_t axis = 0; has_overhang() && axis < units.size(); ++axis)
            if (units[axis] < margin || units[axis] - margin >= std::uint64_t{tile} * window_.size[axis]) return false;
        for (const std::uint32_t unit : units) coordinates_.push_back((unit - margin) / 65536.0);
        return true;
    }

    const PoissonTileSet& tiles_;
    TileBlock window_;
    const WindowDensity& density_;
    TileBlock block_;
    TilePointGenerator generator_;
    std::vector<double> coordinates_;
};

void write_tile_points(const TilesPointsOptions& options)
{
    check_point_target("tiles points", options.out);
    const PoissonTileSet tiles = read_tile_set(options.file);
    const PoissonTileParameters& p = tiles.parameters;
    const TileBlock block = checked_window(options.window, p.dimension);
    const WindowDensity density(options.density, options.density_from, block, p.dimension);
    const Device device = Device::open(options.device);
    check_fits(options.file.string(), TilePointGenerator::memory(p, block.tiles(), device.info()), device.info());
    WindowPoints points(device, tiles, block, density);
    write_points_in_pieces(options.out, p.dimension, points.count(options.seed), comment_of(options, block),
                           [&](const PointSink& sink) { points.stream(options.seed, sink); });
}

}

Command tiles_points_command()
{
    const auto o = std::make_shared<TilesPointsOptions>();
    return {
        "points",
        "Write the points of a window of a tiling to a file",
        {{"FILE", &o->file, "The tile set (.ptiles, .json)"},
         {"--window", &o->window, "The tiles: lowest one, and how many along each axis", "X Y W H (3D: X Y Z W H D)",
          required, 6},
         {"--out", &o->out, "The point file", "FILE", required},
         {"--density", &o->density,
          "The part of the points that is left, everywhere or from place to place; default: 1", "NUMBER|IMAGE|FORMULA"},
         {"--density-from", &o->density_from, "Of a picture: light (the default), ink, or one of its channels", "NAME"},
         {"--seed", &o->seed, "Which tiling; default: 1", "S"},
         {"--device", &o->device, "The OpenCL device: part of its name, or its number", "NAME"}},
        tiles_points_notes,
        action_on(o, write_tile_points)};
}

}
