// poissonlab points dart-throwing: one set of any size, thrown block by block, as a point file.
#include "app/commands/large_sets/relaxed_points.hpp"
#include "base/crew/thread_limit.hpp"
#include "base/errors/errors.hpp"
#include "base/geometry/relative_radius.hpp"
#include "host/large_sets/large_darts.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
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
--min-distance. A last line says how many there are. What is interrupted keeps nothing. The format follows the extension: .npy, .h5, .csv, .usda, .ply or text; in 3D .hdf5 and .h5part, too.
  poissonlab points dart-throwing --points 100000000 --relative-radius 0.75 --out points.npy
  mpirun -n 4 poissonlab points dart-throwing --points 1000000000 --out saturated.h5
  poissonlab points dart-throwing --dimension 3 --min-distance 0.004 --out spheres.npy)help";

/// Coordinates have 32 bits: at smaller distances their grid would show.
constexpr double least_distance = 0x1p-20;

/// A set as it is asked for: points or a distance.
struct AskedDarts
{
    std::optional<std::uint64_t> points;
    std::optional<double> relative_radius, min_distance;
    int dimension = 2;
    double memory = 1; ///< GB
};

LargeDarts set_of(const AskedDarts& asked, std::uint64_t seed)
{
    const double saturated = saturation_relative_radius(asked.dimension);
    LargeDarts set;
    set.darts.dimension = asked.dimension;
    set.darts.stream = stream_key(seed, Purpose::dart_throwing, 0);
    if (asked.min_distance) {
        set.darts.min_distance = *asked.min_distance;
        set.expected_points = static_cast<std::uint64_t>(
            std::pow(saturated / relative_radius(*asked.min_distance, 1, asked.dimension), asked.dimension));
    } else {
        set.darts.min_distance =
            min_distance_for(asked.relative_radius.value_or(saturated), *asked.points, asked.dimension);
        set.expected_points = *asked.points;
        if (asked.relative_radius) set.darts.points = asked.points;
    }
    return set;
}

void check_distance(const Keys& keys, const AskedDarts& asked)
{
    const double saturated = saturation_relative_radius(asked.dimension);
    if (asked.relative_radius && *asked.relative_radius >= saturated)
        throw keys.invalid(
            "relative_radius",
            fmt::format("dart throwing saturates at about {:.4f} in {}D; ask for less", saturated, asked.dimension));
    const double min_distance = set_of(asked, 1).darts.min_distance;
    if (min_distance >= least_distance) return;
    const double most = std::pow(relative_radius(min_distance, *asked.points, asked.dimension) /
                                     relative_radius(least_distance, 1, asked.dimension),
                                 asked.dimension);
    throw keys.invalid("points",
                       fmt::format("at most {:.3g} fit: coordinates have 32 bits, and the minimum distance must "
                                   "be at least {:.3g}",
                                   most, least_distance));
}

void large_dart_keys(Keys& keys, AskedDarts& asked)
{
    keys.integer("points", asked.points, 1, any_integer, "how many points").otherwise("as the distance has it");
    keys.number("relative_radius", asked.relative_radius, {0.001, 1},
                "minimum distance over that of the densest packing of as many points")
        .otherwise("darts until no further one fits");
    keys.number("min_distance", asked.min_distance, {least_distance, 1}, "the minimum distance")
        .unit("sides of the torus")
        .otherwise("as the points have it")
        .excludes("points");
    keys.integer("dimension", asked.dimension, 2, 3, "of the torus");
    keys.number("memory", asked.memory, {0.001, 1e6}, "what a block may take at most").unit("GB");
    if (!keys.is_read()) return;
    if (!asked.points && !asked.min_distance)
        throw keys.problem(fmt::format("needs {} or {}", keys.name_of("points"), keys.name_of("min_distance")));
    if (asked.relative_radius && asked.min_distance)
        throw keys.invalid("relative_radius", "needs --points; --min-distance sets the distance");
    check_distance(keys, asked);
}

std::string comment_of(const KindOptions& o, const LargeDarts& set)
{
    return o.command_comment(fmt::format("minimum distance {}, in the order of darts{}", set.darts.min_distance,
                                         set.darts.points ? "" : ", between which no further one fits"));
}

/// Returns a line with the number of points and, if it is not the requested one, the reason.
std::string words_of(const LargeDarts& set, std::uint64_t count, const std::optional<std::uint64_t>& asked)
{
    std::string what = fmt::format("{} points at least {:.6g} apart", count, set.darts.min_distance);
    if (!set.darts.points) what += ", between which no further one fits";
    if (asked && *asked != count)
        what += fmt::format(" ({} were asked for; without --relative-radius, chance decides how many fit)", *asked);
    return what;
}

void throw_large_darts(const KindOptions& o)
{
    const auto crew = make_crew();
    const ThreadLimit limit(threads_of_process(0, *crew));
    say_what_interruption_keeps(*crew);
    LargeDarts set;
    AskedDarts asked;
    std::optional<DistributionPlace> place;
    PointFileHead head;
    const bool is_ready = crew->together([&] {
        asked = o.read<AskedDarts>();
        checked_output(o.command(), "--out", o.out, point_formats());
        set = set_of(asked, o.seed());
        head.dimension = set.darts.dimension;
        head.points = set.expected_points;
        head.comment = comment_of(o, set);
        check_head(o.out, head);
        place.emplace(o.place(!crew->leads()));
        std::optional<DeviceInfo> device;
        if (place->engine == Engine::opencl) device = place->device().info();
        set.block_side = block_side_for(set.darts, static_cast<std::uint64_t>(asked.memory * 1e9), device);
    });
    if (!is_ready) return;
    const std::uint64_t count = write_large_darts(o.out, head, set, *place, *crew);
    if (!crew->leads()) return;
    o.say_written(words_of(set, count, asked.points));
    if (o.prints_json())
        fmt::print("{}\n", nlohmann::ordered_json{{"file", printable(o.out.string())},
                                                  {"points", count},
                                                  {"dimension", head.dimension},
                                                  {"min_distance", set.darts.min_distance}}
                               .dump(2));
}

}

Command points_dart_throwing_command()
{
    static const Kind darts =
        described_command("points dart-throwing", "Throw the darts of one set of any size", large_dart_keys);
    const auto o = std::make_shared<KindOptions>(darts);
    return kind_command(o, {{"--out", &o->out, "The point file", "FILE", required}}, points_dart_throwing_notes,
                        throw_large_darts);
}

}
