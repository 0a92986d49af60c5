#include "app/commands/tiles/window_file.hpp"

#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"

#include <fmt/format.h>

#include <array>
#include <future>
#include <numeric>
#include <optional>

namespace poissonlab {
namespace {

/// Writes one piece while the next one is made.
class PieceWriter
{
public:
    explicit PieceWriter(const PlacedFile& file) : file_(file) {}

    /// The coordinates of the piece to be made: those of the piece before are being written.
    std::vector<double>& next()
    {
        turn_ = 1 - turn_;
        return coordinates_[turn_];
    }

    /// Writes what was made, once the piece before is written. Throws what went wrong with that.
    void write(std::uint64_t first)
    {
        finish();
        running_ =
            std::async(std::launch::async, [this, first, &piece = coordinates_[turn_]] { file_.put(first, piece); });
    }

    void finish()
    {
        if (running_.valid()) running_.get();
    }

private:
    const PlacedFile& file_;
    std::array<std::vector<double>, 2> coordinates_;
    std::size_t turn_ = 0;
    std::future<void> running_; ///< ends before what it writes from is gone
};

Schedule one_job_a_piece(const WindowPoints& points)
{
    Schedule schedule;
    for (std::uint32_t piece = 0; piece < points.pieces(); ++piece)
        schedule.add({.kind = Job::Kind::points, .first = piece});
    return schedule;
}

void nothing_more(const Job& /*job*/, bool /*here*/) {}

/// The number of points before each piece, and of all. Nothing where a process failed.
std::optional<std::vector<std::uint64_t>> count_pieces(WindowPoints& points, Crew& crew)
{
    std::vector<std::uint64_t> counts(points.pieces());
    const auto count = [&](const Job& job) { counts[job.first] = points.count(job.first); };
    if (points.has_known_counts()) {
        for (std::uint32_t piece = 0; piece < points.pieces(); ++piece) counts[piece] = points.count(piece);
    } else {
        Schedule schedule = one_job_a_piece(points);
        if (!crew.work(schedule, count, nothing_more)) return std::nullopt;
        counts = crew.sum(counts);
    }
    std::vector<std::uint64_t> before{0};
    for (const std::uint64_t one : counts) before.push_back(before.back() + one);
    return before;
}

/// The work of each process. `temporary` is what the one that leads says.
void fill_file(const std::filesystem::path& temporary, const std::filesystem::path& path, const PointFileHead& head,
               const std::vector<std::uint64_t>& before, WindowPoints& points, Crew& crew)
{
    const bool is_made = crew.together([&] {
        if (crew.leads()) create_placed_file(temporary, path, head);
    });
    if (!is_made) return;
    const std::filesystem::path shared = crew.from_leader(temporary.string());
    std::optional<PlacedFile> file;
    if (!crew.together([&] { file.emplace(shared, path, head); })) return;
    PieceWriter writer(*file);
    const auto make = [&](const Job& job) {
        points.make(job.first, writer.next());
        writer.write(before[job.first]);
    };
    Schedule schedule = one_job_a_piece(points);
    if (!crew.work(schedule, make, nothing_more)) return;
    crew.together([&] {
        writer.finish();
        file->close();
    });
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
    if (crew.leads())
        write_whole_file(path, [&](const std::filesystem::path& temporary) {
            fill_file(temporary, path, head, *before, points, crew);
        });
    else
        fill_file({}, path, head, *before, points, crew);
    return head.points;
}

}

std::uint64_t write_window(const std::filesystem::path& path, PointFileHead head, WindowPoints& points, Crew& crew)
{
    if (has_known_places(path)) return write_placed_window(path, head, points, crew);
    std::uint64_t all = 0;
    crew.together([&] {
        if (!crew.leads()) return;
        for (std::uint32_t piece = 0; piece < points.pieces(); ++piece) all += points.count(piece);
        const std::string comment = fmt::format("domain 0:{}\n{}", head.side, head.comment);
        write_points_in_pieces(path, head.dimension, all, comment, [&](const PointSink& sink) {
            std::vector<double> coordinates;
            for (std::uint32_t piece = 0; piece < points.pieces(); ++piece) {
                points.make(piece, coordinates);
                sink(coordinates);
            }
        });
    });
    return all;
}

}
