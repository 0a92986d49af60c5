// poissonlab tiles points: the points of a window of a Poisson disk tiling as a point file, streamed.
#include "app/commands/command.hpp"
#include "app/commands/point_target.hpp"
#include "app/commands/tiles/window_density.hpp"
#include "base/errors/errors.hpp"
#include "base/points/particle_file.hpp"
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
With --torus, N x N (x N) tiles whose opposite edges fit: a box with periodic borders, as simulations have it.
Points of cubes as particles: .hdf5 is a snapshot as Gadget has it (BoxSize in tiles), which monofonIC takes as a glass;
.h5part has x, y and z in the unit cube, for SPH-EXA.
With --density, points are left out: those of the highest ranks (tiles build --ranked), of sets without ranks any. No
point moves. A number is the part that is left; a picture or a formula in x and y, laid over the window, says it for each
place, in parts of its largest value.
  poissonlab tiles points corner.ptiles --window -8 -8 16 16 --out points.npy
  poissonlab tiles points sphere.ptiles --torus 92 --out glass.hdf5
  poissonlab tiles points ranked.ptiles --window 0 0 30 20 --density photo.jpg --density-from ink --out dots.ply
  poissonlab tiles points ranked.ptiles --window 0 0 20 20 --density "exp(-8*(x^2+y^2))" --out blob.txt)help";

struct TilesPointsOptions
{
    std::filesystem::path file;       ///< the tile set
    std::vector<std::int64_t> window; ///< X Y W H; 3D: X Y Z W H D
    std::uint32_t torus = 0;          ///< tiles along each axis; 0: a window of the plane
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

/// The whole torus.
TileBlock torus_block(std::uint32_t tiles, int dimension)
{
    if (tiles < 1 || tiles > 65'535)
        throw InputError(fmt::format("tiles points: --torus {}: must be 1 to 65,535 tiles", tiles));
    TileBlock block;
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension); ++axis) block.size[axis] = tiles;
    return block;
}

TileBlock checked_block(const TilesPointsOptions& options, int dimension)
{
    if (options.window.empty() == (options.torus == 0))
        throw InputError("tiles points: needs --window or --torus, and not both");
    return options.torus > 0 ? torus_block(options.torus, dimension) : checked_window(options.window, dimension);
}

/// Particles are in cubes.
void check_particles(const TilesPointsOptions& options, const TileBlock& block, int dimension)
{
    if (!is_particle_file(options.out)) return;
    const std::string out = fmt::format("tiles points: --out {}", printable(options.out.string()));
    if (dimension != 3)
        throw InputError(out +
                         ": particles of simulations are in 3D, and these tiles in 2D: must be .npy, .csv, .usda, "
                         ".ply or text");
    if (block.size[0] != block.size[1] || block.size[0] != block.size[2])
        throw InputError(out + ": particles are in a cube: --window must have as many tiles along each axis");
}

/// What the file says of its points.
std::string comment_of(const TilesPointsOptions& options)
{
    const std::string density = options.density == "1" ? "" : fmt::format(" --density {}", printable(options.density));
    const std::string place = options.torus > 0 ? fmt::format("--torus {}", options.torus)
                                                : fmt::format("--window {}", fmt::join(options.window, " "));
    return fmt::format("poissonlab tiles points {} {} --seed {}{}: coordinates in tiles, from the "
                       "lowest corner of the {}",
                       options.file.filename().string(), place, options.seed, density,
                       options.torus > 0 ? "torus" : "window");
}

/// With chains, points lie outside of their tiles' squares: those of a window are looked for one tile farther.
TileBlock searched_block(const TileBlock& window, std::uint32_t period, const PoissonTileParameters& p)
{
    if (p.border == TileBorder::strip || period > 0) return window;
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

/// Hands on the coordinates, in tiles, of the points of a window or of a whole torus, in pieces.
class WindowPoints
{
public:
    /// `tiles` and `density` must outlive this. `period`: of the torus that the block is; 0: the plane.
    WindowPoints(const Device& device, const PoissonTileSet& tiles, const TileBlock& window, std::uint32_t period,
                 const WindowDensity& density)
        : tiles_(tiles), window_(window), period_(period), density_(density),
          block_(searched_block(window, period, tiles.parameters)), generator_(device, tiles)
    {}

    std::size_t count(std::uint32_t seed)
    {
        if ((!has_overhang() || period_ > 0) && density_.is_full())
            return window_.tiles() * tiles_.parameters.points_per_tile;
        std::size_t points = 0;
        stream(seed, [&](std::span<const double> coordinates) { points += coordinates.size() / dimension(); });
        return points;
    }

    void stream(std::uint32_t seed, const PointSink& sink)
    {
        const PoissonTiling tiling{seed, static_cast<std::int32_t>(period_)};
        PointLevels levels(tiles_, tiling, block_);
        generator_.stream(tiling, block_, [&](std::span<const std::uint32_t> units) {
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
        if (period_ > 0) {
            for (const std::uint32_t unit : units)
                coordinates_.push_back(static_cast<double>(torus_place(unit, period_)) / 65536.0);
            return true;
        }
        constexpr std::uint32_t tile = 65536;
        const std::uint32_t margin = has_overhang() ? tile : 0; // of the block around the window
        for (std::size_t axis = 0; has_overhang() && axis < units.size(); ++axis)
            if (units[axis] < margin || units[axis] - margin >= std::uint64_t{tile} * window_.size[axis]) return false;
        for (const std::uint32_t unit : units) coordinates_.push_back((unit - margin) / 65536.0);
        return true;
    }

    const PoissonTileSet& tiles_;
    TileBlock window_;
    std::uint32_t period_;
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
    const TileBlock block = checked_block(options, p.dimension);
    check_particles(options, block, p.dimension);
    const WindowDensity density(options.density, options.density_from, block, p.dimension);
    const Device device = Device::open(options.device);
    check_fits(options.file.string(), TilePointGenerator::memory(p, block.tiles(), device.info()), device.info());
    WindowPoints points(device, tiles, block, options.torus, density);
    const std::size_t count = points.count(options.seed);
    const auto stream = [&](const PointSink& sink) { points.stream(options.seed, sink); };
    const std::uint32_t side = std::ranges::max(block.size); // of the square (cube) that the points are in
    if (is_particle_file(options.out))
        write_particles_in_pieces(options.out, count, side, "tiles", comment_of(options), stream);
    else
        write_points_in_pieces(options.out, p.dimension, count,
                               fmt::format("domain 0:{}\n{}", side, comment_of(options)), stream);
}

}

Command tiles_points_command()
{
    const auto o = std::make_shared<TilesPointsOptions>();
    return {
        "points",
        "Write the points of a window of a tiling, or of a torus, to a file",
        {{"FILE", &o->file, "The tile set (.ptiles, .json)"},
         {"--window", &o->window, "The tiles: lowest one, and how many along each axis", "X Y W H (3D: X Y Z W H D)",
          optional, 6},
         allowing({"--torus", &o->torus, "Instead of a window: so many tiles along each axis, whose opposite edges fit",
                   "N"},
                  integers(1, 65'535)),
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
