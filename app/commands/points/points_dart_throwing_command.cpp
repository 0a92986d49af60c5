// poissonlab points dart-throwing: one set of any size, thrown block by block, as a point file.
#include "app/commands/point_target.hpp"
#include "app/commands/points/large_darts.hpp"
#include "app/commands/work_options.hpp"
#include "base/errors/errors.hpp"
#include "base/geometry/relative_radius.hpp"
#include "base/programs/interrupt.hpp"
#include "experiment/crew/thread_limit.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>
#include <optional>

namespace poissonlab {
namespace {

constexpr auto points_dart_throwing_notes =
    R"help(The set is that of the method dart-throwing with the same seed, its first realization, number for number. It need not
fit in memory: the torus is divided into blocks, which are thrown one after another, and put together on the disk, which
needs as much room again as the file takes while it is made. Started by mpirun, processes share the blocks and write one
file, the same bytes as one process, for .npy and HDF5.
Points come in the order in which darts fall: each begin of the file is a dart throwing of its own.
With --relative-radius, so many points; without, darts are thrown until no further one fits: about --points of them, or at
--min-distance. The format follows the extension: .npy, .h5, .csv, .usda, .ply or text; in 3D .hdf5 and .h5part, too.
  poissonlab points dart-throwing --points 100000000 --relative-radius 0.75 --out points.npy
  mpirun -n 4 poissonlab points dart-throwing --points 1000000000 --out saturated.h5
  poissonlab points dart-throwing --dimension 3 --min-distance 0.004 --out spheres.npy)help";

constexpr double not_given = std::numeric_limits<double>::quiet_NaN();

struct LargeDartOptions
{
    std::uint64_t points = 0;
    double relative_radius = not_given;
    double min_distance = not_given;
    std::uint32_t dimension = 2;
    double memory = 1; ///< GB
    std::filesystem::path out;
    bool as_json = false;
    WorkOptions work;
};

InputError wrong_value(const std::string& option, double value, const std::string& allowed)
{
    return InputError(fmt::format("points dart-throwing: {} {}: {}", option, value, allowed));
}

void check_number(const std::string& option, double value, double most)
{
    if (!std::isnan(value) && !(value > 0 && value <= most))
        throw wrong_value(option, value, fmt::format("must be a number greater than 0 and at most {}", most));
}

/// Checks each option, and which go together.
void check_options(const LargeDartOptions& o)
{
    if (o.dimension != 2 && o.dimension != 3) throw wrong_value("--dimension", o.dimension, "must be 2 or 3");
    check_number("--relative-radius", o.relative_radius, 1);
    check_number("--min-distance", o.min_distance, 1);
    if (!(o.memory > 0 && std::isfinite(o.memory)))
        throw wrong_value("--memory", o.memory, "must be a number greater than 0");
    if ((o.points > 0) != std::isnan(o.min_distance))
        throw InputError("points dart-throwing: needs --points or --min-distance, and not both");
    if (!std::isnan(o.min_distance) && !std::isnan(o.relative_radius))
        throw InputError("points dart-throwing: --relative-radius needs --points; --min-distance sets the distance");
}

/// Coordinates have 32 bits: at smaller distances their grid would show.
void check_distance(const LargeDartOptions& o, double min_distance)
{
    constexpr double least = 0x1p-20;
    const double saturated = saturation_relative_radius(static_cast<int>(o.dimension));
    if (!(o.relative_radius < saturated) && !std::isnan(o.relative_radius))
        throw wrong_value(
            "--relative-radius", o.relative_radius,
            fmt::format("dart throwing saturates at about {:.4f} in {}D; ask for less", saturated, o.dimension));
    if (min_distance >= least) return;
    if (!std::isnan(o.min_distance))
        throw wrong_value("--min-distance", min_distance, fmt::format("must be at least {:.3g}", least));
    const double most = std::pow(relative_radius(min_distance, o.points, static_cast<int>(o.dimension)) /
                                     relative_radius(least, 1, static_cast<int>(o.dimension)),
                                 o.dimension);
    throw InputError(
        fmt::format("points dart-throwing: --points {}: at most {:.3g} fit: coordinates have 32 bits, and the "
                    "minimum distance must be at least {:.3g}",
                    o.points, most, least));
}

LargeDarts set_of(const LargeDartOptions& o)
{
    const auto dimension = static_cast<int>(o.dimension);
    const double saturated = saturation_relative_radius(dimension);
    LargeDarts set;
    set.darts.dimension = dimension;
    set.darts.stream = stream_key(o.work.seed(), Purpose::dart_throwing, 0);
    if (!std::isnan(o.min_distance)) {
        set.darts.min_distance = o.min_distance;
        set.expected_points =
            static_cast<std::uint64_t>(std::pow(saturated / relative_radius(o.min_distance, 1, dimension), dimension));
    } else {
        const bool stops = !std::isnan(o.relative_radius);
        set.darts.min_distance = min_distance_for(stops ? o.relative_radius : saturated, o.points, dimension);
        set.expected_points = o.points;
        if (stops) set.darts.points = o.points;
    }
    check_distance(o, set.darts.min_distance);
    return set;
}

std::string comment_of(const LargeDartOptions& o, const LargeDarts& set)
{
    return fmt::format("poissonlab points dart-throwing --seed {}: minimum distance {:.17g}, in the order of darts{}",
                       o.work.seed(), set.darts.min_distance,
                       set.darts.points ? "" : ", between which no further one fits");
}

void throw_large_darts(const LargeDartOptions& o)
{
    o.work.engine("points dart-throwing"); // throws for one that there is not
    const auto crew = make_crew();
    const ThreadLimit limit(threads_of_process(0, *crew));
    if (!crew->leads()) say_nothing_when_interrupted();
    LargeDarts set;
    std::optional<DistributionPlace> place;
    PointFileHead head;
    const bool is_ready = crew->together([&] {
        check_options(o);
        check_point_target("points dart-throwing", o.out);
        set = set_of(o);
        head.dimension = set.darts.dimension;
        head.points = set.expected_points;
        head.comment = comment_of(o, set);
        check_head(o.out, head);
        place.emplace(o.work.place("points dart-throwing", !crew->leads()));
        std::optional<DeviceInfo> device;
        if (place->engine == Engine::opencl) device = place->device().info();
        set.block_side = block_side_for(set.darts, static_cast<std::uint64_t>(o.memory * 1e9), device);
    });
    if (!is_ready) return;
    const std::uint64_t count = write_large_darts(o.out, head, set, *place, *crew);
    if (o.as_json && crew->leads())
        fmt::print("{}\n", nlohmann::ordered_json{{"file", printable(o.out.string())},
                                                  {"points", count},
                                                  {"dimension", head.dimension},
                                                  {"min_distance", set.darts.min_distance}}
                               .dump(2));
}

}

Command points_dart_throwing_command()
{
    const auto o = std::make_shared<LargeDartOptions>();
    return {
        "dart-throwing", "Throw the darts of one set of any size",
        joined({{{"--points", &o->points, "How many points", "N"},
                 {"--relative-radius", &o->relative_radius,
                  "Minimum distance over that of the densest packing of as many points", "R"},
                 {"--min-distance", &o->min_distance, "Instead of --points: the distance, in sides of the torus", "D"},
                 allowing({"--dimension", &o->dimension, "2 (the default) or 3", "D"}, "2 or 3"),
                 {"--out", &o->out, "The point file", "FILE", required},
                 {"--memory", &o->memory, "What a block may take at most; default: 1", "GB"},
                 json_option(o->as_json, "Print how many points there are as JSON")},
                o->work.options()}),
        points_dart_throwing_notes, action_on(o, throw_large_darts)};
}

}
