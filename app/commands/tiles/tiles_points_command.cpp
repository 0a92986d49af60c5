// poissonlab tiles points: the points of a window of a Poisson disk tiling as a point file, streamed.
#include "app/commands/tiles/monotile_work.hpp"
#include "app/commands/tiles/tile_points_work.hpp"
#include "app/commands/tiles/window_points.hpp"
#include "base/crew/crew.hpp"
#include "base/crew/placed_pieces.hpp"
#include "base/crew/thread_limit.hpp"
#include "base/errors/errors.hpp"
#include "base/points/placed_file.hpp"
#include "base/points/point_file_formats.hpp"
#include "base/programs/interrupt.hpp"
#include "base/regions/plane_region.hpp"
#include "base/regions/region_source.hpp"
#include "base/text/noun.hpp"
#include "host/distribution/classes/class_files.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <memory>
#include <optional>

namespace poissonlab {
namespace {

// A file of a window's points that is larger than memory, written by one process or by several together.

void nothing_more(const Job& /*job*/, bool /*here*/) {}

/// The number of points before each piece, and of all. Nothing where a process failed.
std::optional<std::vector<std::uint64_t>> count_pieces(PiecedPoints& points, Crew& crew)
{
    std::vector<std::uint64_t> counts(points.pieces());
    const auto count = [&](const Job& job) { counts[job.first] = points.count(job.first); };
    if (points.has_known_counts()) {
        for (std::uint32_t piece = 0; piece < points.pieces(); ++piece) counts[piece] = points.count(piece);
    } else {
        Schedule schedule = one_job_each(points.pieces());
        if (!crew.work(schedule, count, nothing_more, {})) return std::nullopt;
        counts = crew.sum(counts);
    }
    std::vector<std::uint64_t> before{0};
    for (const std::uint64_t one : counts) before.push_back(before.back() + one);
    return before;
}

std::uint64_t write_placed_window(const std::filesystem::path& path, PointFileHead head, PiecedPoints& points,
                                  Crew& crew)
{
    head.points = points.least_points();
    if (!crew.together([&] { check_room(path, head); })) return 0;
    const auto before = count_pieces(points, crew);
    if (!before) return 0;
    head.points = before->back();
    const bool fits = crew.together([&] {
        check_head(path, head);
        check_room(path, head);
    });
    if (!fits) return 0;
    write_placed_pieces(
        path, head, *before, [&](std::uint32_t piece, std::vector<double>& to) { points.make(piece, to); }, crew);
    return head.points;
}

/// Writes a file whose points have no known places, with the names and the system of the region's coordinates.
void write_streamed(const std::filesystem::path& path, int dimension, std::uint64_t count, const std::string& comment,
                    const PlaneRegion* region, const std::function<void(const PointSink& sink)>& write)
{
    const std::string ending = path.extension();
    if (region && is_mapped(*region) && ending == ".csv")
        return write_csv_points(path, dimension, csv_header_globe, write);
    if (region && ending == ".geojson")
        return write_geojson_points(path, dimension, crs_in_files(*region), comment, write);
    write_points_in_pieces(path, dimension, count, comment, write);
}

/// Writes all points. Files with known places are written by all processes of the crew, one piece while the next one is
/// made, and have the same bytes for any number of them; others by the process that leads. `head` lacks the number of
/// points. To be called by all processes, on a file system that they share. Whole or not at all. Throws InputError
/// before any point is made where the disk has no room for them, StorageError. Returns their number, in the process
/// that leads.
/// Names of columns and the system of coordinates are those of the region, if there is one.
std::uint64_t write_window(const std::filesystem::path& path, PointFileHead head, PiecedPoints& points, Crew& crew,
                           const PlaneRegion* region)
{
    if (has_known_places(path)) return write_placed_window(path, head, points, crew);
    std::uint64_t all = 0;
    crew.together([&] {
        if (!crew.leads()) return;
        all = points.count_all();
        const std::string comment =
            head.side > 0 && head.fills_square ? fmt::format("domain 0:{}\n{}", head.side, head.comment) : head.comment;
        write_streamed(path, head.dimension, all, comment, region, [&](const PointSink& sink) {
            std::vector<double> coordinates;
            for (std::uint32_t piece = 0; piece < points.pieces(); ++piece) {
                points.make(piece, coordinates);
                sink(coordinates);
            }
        });
    });
    return all;
}

/// Writes all points, which have classes, in one of the formats of class files. The process that leads writes the file.
std::uint64_t write_class_window(const std::filesystem::path& path, const PointFileHead& head, PiecedPoints& points,
                                 Crew& crew, const PlaneRegion* region)
{
    std::uint64_t all = 0;
    crew.together([&] {
        if (!crew.leads()) return;
        all = points.count_all();
        const auto write = [&](const ClassedPointSink& sink) {
            std::vector<double> coordinates;
            std::vector<std::uint32_t> classes;
            for (std::uint32_t piece = 0; piece < points.pieces(); ++piece) {
                points.make(piece, coordinates, &classes);
                sink(coordinates, classes);
            }
        };
        write_class_pieces(path, head.dimension, all, head.comment, write, region);
    });
    return all;
}

constexpr auto tiles_points_notes =
    R"help(Coordinates are in tiles, from the lowest corner of the window. Rows of tiles from south to north (3D: layers
from the bottom), in each from west to east. The seed chooses the tiling: windows of the same seed fit together.
The format follows the extension: .npy, .h5 (HDF5: /points), .csv, .usda, .ply (ascii), or text; the latter two say
`domain 0:N` for a square window, whose points poissonlab analyze takes so; for .npy and .csv, --domain N. Edges of the
window are not those of a torus: --set analysis.window=true. Of other windows: --region "rectangle 0 0 WIDTH HEIGHT".
Files may be larger than memory. Started by mpirun, processes write .npy and HDF5 together, the same bytes as one.
With --torus, N x N (x N) tiles whose opposite edges fit: a box with periodic borders, as simulations have it.
Points of cubes as particles: .hdf5 is a snapshot as Gadget has it (BoxSize in tiles), which monofonIC takes as a glass;
.h5part has x, y and z in the unit cube, for SPH-EXA.
With --density, points are left out: those of the highest ranks (tiles build --ranked), of sets without ranks any. No
point moves. A number is the part that is left; a picture or a formula in x and y, laid over the window or the region, says it for each
place, in parts of its largest value.
With --region, the points in a polygon with holes (see distribute darts), in its own units. Tiles are as wide as makes
their proven minimum distance --min-distance, or leaves --points of them. Tile (0, 0) begins at 0, 0 of the region's
coordinates: regions beside each other, of one seed and distance, fit together.
Of tiles whose points have classes (tiles build --class-points) each point's class is written as well, as distribute
classes does: .csv (columns x, y, class), .ply (vertices with a class), .npy (records x, y, class) or .geojson
(features with the property class).
Of sets of one tile that never repeats (tiles build hat, spectre) --window is in edges: X and Y are integers up to 2^40,
Y in steps of sqrt 3 for hats, and W and H are up to 2^20. The seed chooses which points --density leaves. Regions are
filled as by square tiles, at the place of the tiling where their coordinates are: move them for other points.
  poissonlab tiles points corner.ptiles --region park.geojson --min-distance 4 --out trees.csv
  poissonlab tiles points corner.ptiles --window -8 -8 16 16 --out points.npy
  poissonlab tiles points sphere.ptiles --torus 92 --out glass.hdf5
  poissonlab tiles points ranked.ptiles --window 0 0 30 20 --density photo.jpg --density-from ink --out dots.ply
  poissonlab tiles points ranked.ptiles --window 0 0 20 20 --density "exp(-8*(x^2+y^2))" --out blob.txt)help";

void print_json(const TilesPointsOptions& options, const TilePointsWork& work, std::uint64_t count)
{
    nlohmann::ordered_json json{
        {"file", printable(options.out.string())}, {"points", count}, {"dimension", work.head.dimension}};
    if (work.region()) {
        json["tile_width"] = work.region()->tile_width();
        json["min_distance"] = work.min_distance();
    } else {
        json["domain"] = {0.0, work.head.side};
    }
    fmt::print("{}\n", json.dump(2));
}

void print_json(const TilesPointsOptions& options, const MonotileWindow& window, std::uint64_t count)
{
    nlohmann::ordered_json json{{"file", printable(options.out.string())}, {"points", count}, {"dimension", 2}};
    if (window.edge())
        json["edge"] = *window.edge();
    else
        json["domain"] = {0.0, window.head.side};
    json["min_distance"] = window.min_distance();
    fmt::print("{}\n", json.dump(2));
}

/// Says what was made of the region's file.
void print_notes(const TilesPointsOptions& options, const Crew& crew, const std::vector<std::string>& notes)
{
    if (!crew.leads() || options.work.is_quiet()) return;
    for (const std::string& note : notes) fmt::print(stderr, "poissonlab: note: {}\n", note);
}

/// Says how many points were made, where others were asked for, and what --json asks for. `scale` is in words.
template <class Work>
void print_result(const TilesPointsOptions& options, const Crew& crew, const Work& work, std::uint64_t count,
                  const char* scale)
{
    if (!crew.leads()) return;
    if (options.points > 0 && count != options.points && !options.work.is_quiet())
        fmt::print(stderr, "poissonlab: note: {} {}: no {} has exactly {}\n", count, noun(count, "point"), scale,
                   options.points);
    if (options.as_json) print_json(options, work, count);
}

/// Writes the window or region of a tiling with an aperiodic monotile. To be called by all processes.
void write_monotile_points(const TilesPointsOptions& options, Crew& crew)
{
    std::optional<MonotileWindow> window;
    if (!crew.together([&] { window.emplace(options); })) return;
    print_notes(options, crew, window->notes());
    const std::uint64_t count = write_window(window->out, window->head, *window, crew, window->plane());
    print_result(options, crew, *window, count, "length of edges");
}

void write_tile_points(const TilesPointsOptions& options)
{
    options.work.engine("tiles points"); // throws for one that there is not
    const auto crew = make_crew();
    const ThreadLimit limit(threads_of_process(0, *crew));
    if (!crew->leads()) say_nothing_when_interrupted();
    if (is_monotile_points_file(options.file)) return write_monotile_points(options, *crew);
    std::optional<TilePointsWork> work;
    if (!crew->together([&] { work.emplace(options); })) return;
    print_notes(options, *crew, work->notes());
    const std::uint64_t count = work->has_classes()
                                    ? write_class_window(work->out, work->head, *work->points, *crew, work->plane())
                                    : write_window(work->out, work->head, *work->points, *crew, work->plane());
    print_result(options, *crew, *work, count, "width of tiles");
}

}

Command tiles_points_command()
{
    const auto o = std::make_shared<TilesPointsOptions>();
    return {
        "points", "Write the points of a window of a tiling, or of a torus, to a file",
        joined({{{"FILE", &o->file, "The tile set (.ptiles, .json)"},
                 {"--window", &o->window, "The tiles: lowest one, and how many along each axis",
                  "X Y W H (3D: X Y Z W H D)", optional, 6},
                 allowing({"--torus", &o->torus,
                           "Instead of a window: so many tiles along each axis, whose opposite edges fit", "N"},
                          Integers{1, 65'535}),
                 {"--region", &o->region, "Instead of both: a region of the plane, in whose units the points are",
                  "REGION"},
                 {"--planar", &o->reading.is_planar,
                  "Coordinates of the region that look like longitude and latitude are lengths"},
                 {"--crs", &o->reading.crs,
                  "The system of the region's coordinates, such as EPSG:4326; default: what its file says", "NAME"},
                 {"--overlap", &o->overlap,
                  "How polygons of the region that overlap or share edges are treated; default: union", "union|refuse"},
                 {"--buffer", &o->reading.buffer,
                  "The region is what lies within this distance of its lines, points and polygons", "NUMBER"},
                 {"--min-distance", &o->min_distance, "With a region: the proven minimum distance, in its units",
                  "NUMBER"},
                 {"--points", &o->points, "With a region, instead: the number of points", "N"},
                 {"--out", &o->out, "The point file", "FILE", required},
                 {"--density", &o->density,
                  "The part of the points that is left, everywhere or from place to place; default: 1",
                  "NUMBER|IMAGE|FORMULA"},
                 {"--density-from", &o->density_from,
                  "The value of a picture to use: light (the default), ink, or one of its channels", "NAME"},
                 seed_option(o->seed),
                 json_option(o->as_json, "Print how many points there are as JSON")},
                o->work.options_without_seed()}),
        tiles_points_notes, action_on(o, write_tile_points)};
}

}
