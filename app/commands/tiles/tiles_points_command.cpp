// poissonlab tiles points: the points of a window of a Poisson disk tiling as a point file, streamed.
#include "app/commands/point_target.hpp"
#include "app/commands/tiles/window_file.hpp"
#include "app/commands/work_options.hpp"
#include "base/errors/errors.hpp"
#include "base/points/hdf5_points.hpp"
#include "base/programs/interrupt.hpp"
#include "experiment/crew/thread_limit.hpp"
#include "tiles/poisson/tile_set_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <optional>

namespace poissonlab {
namespace {

constexpr auto tiles_points_notes =
    R"help(Coordinates are in tiles, from the lowest corner of the window. Rows of tiles from south to north (3D: layers
from the bottom), in each from west to east. The seed chooses the tiling: windows of the same seed fit together.
The format follows the extension: .npy, .h5 (HDF5: /points), .csv, .usda, .ply (ascii), or text; the latter two say
`domain 0:N`, the longest side of the window, so that poissonlab analyze takes the points of a square one; for .npy and
.csv, --domain N. Edges of the window are not those of a torus: --set analysis.window=true.
Files may be larger than memory. Started by mpirun, processes write .npy and HDF5 together, the same bytes as one.
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
    bool as_json = false;
    WorkOptions work;
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
void check_particles(const TilesPointsOptions& options, const TileBlock& block, const PointFileHead& head)
{
    check_head(options.out, head);
    if (is_particle_file(options.out) && (block.size[0] != block.size[1] || block.size[0] != block.size[2]))
        throw InputError(
            fmt::format("tiles points: --out {}: particles are in a cube: --window must have as many tiles "
                        "along each axis",
                        printable(options.out.string())));
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

void write_tile_points(const TilesPointsOptions& options)
{
    options.work.engine("tiles points"); // throws for one that there is not
    const auto crew = make_crew();
    const ThreadLimit limit(threads_of_process(0, *crew));
    if (!crew->leads()) say_nothing_when_interrupted();
    std::optional<PoissonTileSet> tiles;
    std::optional<WindowDensity> density;
    std::optional<WindowPoints> points;
    PointFileHead head{.unit = "tiles", .comment = comment_of(options)};
    const bool is_ready = crew->together([&] {
        check_point_target("tiles points", options.out);
        const PoissonTileParameters& p = tiles.emplace(read_tile_set(options.file)).parameters;
        const TileBlock block = checked_block(options, p.dimension);
        head.dimension = p.dimension;
        head.side = std::ranges::max(block.size); // of the square (cube) that the points are in
        check_particles(options, block, head);
        density.emplace(options.density, options.density_from, block, p.dimension, options.work.is_quiet());
        const DistributionPlace place = options.work.place("tiles points", true);
        if (place.engine == Engine::opencl)
            check_fits(options.file.string(), TilePointGenerator::memory(p, block.tiles(), place.device().info()),
                       place.device().info());
        points.emplace(place.engine == Engine::opencl ? device_stream(place.device(), *tiles)
                                                      : reference_stream(*tiles),
                       *tiles, WindowOfTiling{block, options.torus, options.seed}, *density);
    });
    if (!is_ready) return;
    const std::uint64_t count = write_window(options.out, head, *points, *crew);
    if (options.as_json && crew->leads())
        fmt::print("{}\n", nlohmann::ordered_json{{"file", printable(options.out.string())},
                                                  {"points", count},
                                                  {"dimension", head.dimension},
                                                  {"domain", {0.0, head.side}}}
                               .dump(2));
}

}

Command tiles_points_command()
{
    const auto o = std::make_shared<TilesPointsOptions>();
    return {"points", "Write the points of a window of a tiling, or of a torus, to a file",
            joined({{{"FILE", &o->file, "The tile set (.ptiles, .json)"},
                     {"--window", &o->window, "The tiles: lowest one, and how many along each axis",
                      "X Y W H (3D: X Y Z W H D)", optional, 6},
                     allowing({"--torus", &o->torus,
                               "Instead of a window: so many tiles along each axis, whose opposite edges fit", "N"},
                              integers(1, 65'535)),
                     {"--out", &o->out, "The point file", "FILE", required},
                     {"--density", &o->density,
                      "The part of the points that is left, everywhere or from place to place; default: 1",
                      "NUMBER|IMAGE|FORMULA"},
                     {"--density-from", &o->density_from,
                      "Of a picture: light (the default), ink, or one of its channels", "NAME"},
                     seed_option(o->seed),
                     json_option(o->as_json, "Print how many points there are as JSON")},
                    o->work.options_without_seed()}),
            tiles_points_notes, action_on(o, write_tile_points)};
}

}
