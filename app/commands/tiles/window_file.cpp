#include "app/commands/tiles/window_file.hpp"

#include "base/crew/placed_pieces.hpp"
#include "base/points/point_file_formats.hpp"
#include "base/regions/region_source.hpp"
#include "host/distribution/classes/class_files.hpp"

#include <fmt/format.h>

#include <optional>

namespace poissonlab {
namespace {

void nothing_more(const Job& /*job*/, bool /*here*/) {}

/// The number of points before each piece, and of all. Nothing where a process failed.
std::optional<std::vector<std::uint64_t>> count_pieces(WindowPoints& points, Crew& crew)
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

std::uint64_t write_placed_window(const std::filesystem::path& path, PointFileHead head, WindowPoints& points,
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
    if (region && ending == ".geojson") return write_geojson_points(path, dimension, region->crs, comment, write);
    write_points_in_pieces(path, dimension, count, comment, write);
}

}

std::uint64_t write_window(const std::filesystem::path& path, PointFileHead head, WindowPoints& points, Crew& crew,
                           const PlaneRegion* region)
{
    if (has_known_places(path)) return write_placed_window(path, head, points, crew);
    std::uint64_t all = 0;
    crew.together([&] {
        if (!crew.leads()) return;
        all = points.count_all();
        const std::string comment =
            head.side > 0 ? fmt::format("domain 0:{}\n{}", head.side, head.comment) : head.comment;
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

std::uint64_t write_class_window(const std::filesystem::path& path, const PointFileHead& head, WindowPoints& points,
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

}
