#include "base/crew/placed_pieces.hpp"

#include "base/files/whole_file.hpp"

#include <array>
#include <future>
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

/// The work of each process. `temporary` is what the one that leads says.
void fill_file(const std::filesystem::path& temporary, const std::filesystem::path& path, const PointFileHead& head,
               const std::vector<std::uint64_t>& before, const MakePiece& make, Crew& crew)
{
    const bool is_made = crew.together([&] {
        if (crew.leads()) create_placed_file(temporary, path, head);
    });
    if (!is_made) return;
    const std::filesystem::path shared = crew.from_leader(temporary.string());
    std::optional<PlacedFile> file;
    if (!crew.together([&] { file.emplace(shared, path, head); })) return;
    PieceWriter writer(*file);
    const auto make_and_write = [&](const Job& job) {
        make(job.first, writer.next());
        writer.write(before[job.first]);
    };
    Schedule schedule = one_job_each(static_cast<std::uint32_t>(before.size() - 1));
    if (!crew.work(schedule, make_and_write, [](const Job& /*job*/, bool /*here*/) {}, {})) return;
    crew.together([&] {
        writer.finish();
        file->close();
    });
}

}

Schedule one_job_each(std::uint32_t count)
{
    Schedule schedule;
    for (std::uint32_t number = 0; number < count; ++number) schedule.add({.kind = Job::Kind::points, .first = number});
    return schedule;
}

void write_placed_pieces(const std::filesystem::path& path, const PointFileHead& head,
                         const std::vector<std::uint64_t>& before, const MakePiece& make, Crew& crew)
{
    if (crew.leads())
        write_whole_file(path, [&](const std::filesystem::path& temporary) {
            fill_file(temporary, path, head, before, make, crew);
        });
    else
        fill_file({}, path, head, before, make, crew);
}

}
