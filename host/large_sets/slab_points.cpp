#include "host/large_sets/slab_points.hpp"

#include "base/files/whole_file.hpp"
#include "base/programs/interrupt.hpp"

#include <tbb/parallel_sort.h>

#include <compare>
#include <functional>
#include <optional>

namespace poissonlab {
namespace {

/// Points of a piece.
constexpr std::uint64_t points_a_piece = std::uint64_t{1} << 18;

/// Collects pieces of the set in the order of its points: in each turn one piece for each of some processes.
class PieceCollector
{
public:
    /// `takers` processes take pieces, the first ones.
    PieceCollector(const SlabPoints& points, const PointFileHead& head, std::size_t takers, Crew& crew)
        : points_(points), head_(head), takers_(takers), crew_(crew), axes_(static_cast<std::size_t>(head.dimension))
    {}

    /// Calls take(first, coordinates) with each piece of this process, of which `first` points are before. False where
    /// a process failed.
    bool collect(const std::function<void(std::uint64_t first, const std::vector<double>& coordinates)>& take)
    {
        if (!crew_.together([&] { sort_points(); })) return false;
        for (std::uint64_t turn = 0; turn < head_.points; turn += takers_ * points_a_piece) {
            if (!fetch(turn)) return false;
            const bool is_taken = crew_.together([&] {
                stop_if_interrupted();
                const std::uint64_t first = turn + static_cast<std::uint64_t>(crew_.rank()) * points_a_piece;
                if (!piece_.empty()) take(first, piece_);
            });
            if (!is_taken) return false;
        }
        return true;
    }

private:
    struct Entry
    {
        std::uint32_t id, slab, index;
        auto operator<=>(const Entry& other) const { return id <=> other.id; }
    };
    static_assert(sizeof(Entry) <= scattered_bytes_per_point);

    void sort_points()
    {
        std::size_t count = 0;
        for (std::uint32_t slab = points_.first_slab(); slab < points_.end_slab(); ++slab)
            count += points_.own(slab).size();
        sorted_.reserve(count);
        for (std::uint32_t slab = points_.first_slab(); slab < points_.end_slab(); ++slab)
            for (std::uint32_t i = 0; i < points_.own(slab).size(); ++i)
                sorted_.push_back({points_.own(slab).ids[i], slab, i});
        tbb::parallel_sort(sorted_.begin(), sorted_.end());
    }

    /// Brings the pieces of a turn to the processes that take them.
    bool fetch(std::uint64_t turn)
    {
        Outbox outbox(crew_);
        const bool is_sent = crew_.together([&] {
            const std::uint64_t end = std::min(head_.points, turn + takers_ * points_a_piece);
            for (; next_ < sorted_.size() && sorted_[next_].id < end; ++next_) {
                const Entry& entry = sorted_[next_];
                const std::span place = std::span(points_.own(entry.slab).coordinates);
                outbox.add((entry.id - turn) / points_a_piece, place.subspan(entry.index * axes_, axes_), entry.id, 0);
            }
            const std::uint64_t first = turn + static_cast<std::uint64_t>(crew_.rank()) * points_a_piece;
            const bool takes = static_cast<std::size_t>(crew_.rank()) < takers_ && first < end;
            piece_.resize(takes ? std::min(points_a_piece, end - first) * axes_ : 0);
        });
        return is_sent && outbox.send(crew_, [&](const SentPoint& point) {
            std::copy_n(point.place.begin(), axes_,
                        piece_.begin() + static_cast<std::ptrdiff_t>(point.id % points_a_piece * axes_));
        });
    }

    const SlabPoints& points_;
    const PointFileHead& head_;
    std::size_t takers_;
    Crew& crew_;
    std::size_t axes_;
    std::vector<Entry> sorted_; ///< the points of this process
    std::size_t next_ = 0;      ///< of them to be sent
    std::vector<double> piece_; ///< of this process
};

/// The work of each process on a file with known places. `temporary` is what the one that leads says.
bool fill_placed(const std::filesystem::path& temporary, const std::filesystem::path& path, const PointFileHead& head,
                 const SlabPoints& points, Crew& crew)
{
    const bool is_made = crew.together([&] {
        if (crew.leads()) create_placed_file(temporary, path, head);
    });
    if (!is_made) return false;
    const std::filesystem::path shared = crew.from_leader(temporary.string());
    std::optional<PlacedFile> file;
    if (!crew.together([&] { file.emplace(shared, path, head); })) return false;
    PieceCollector collector(points, head, static_cast<std::size_t>(crew.size()), crew);
    return collector.collect([&](std::uint64_t first, const std::vector<double>& piece) { file->put(first, piece); }) &&
           crew.together([&] { file->close(); });
}

/// Calls write(is_begun) in the process that leads, which sets `is_begun` before it does anything together with the
/// others: these wait for that, and are told of an exception that comes before.
template <class Write>
void lead_writing(Crew& crew, const Write& write)
{
    bool is_begun = false;
    try {
        write(is_begun);
    } catch (...) {
        if (!is_begun) crew.together([] { throw; });
        throw;
    }
}

bool write_placed(const std::filesystem::path& path, const PointFileHead& head, const SlabPoints& points, Crew& crew)
{
    if (!crew.leads()) return fill_placed({}, path, head, points, crew);
    lead_writing(crew, [&](bool& is_begun) {
        write_whole_file(path, [&](const std::filesystem::path& temporary) {
            is_begun = true;
            fill_placed(temporary, path, head, points, crew);
        });
    });
    return true;
}

/// The process that leads writes what the others send.
bool write_in_order(const std::filesystem::path& path, const PointFileHead& head, const SlabPoints& points, Crew& crew)
{
    PieceCollector collector(points, head, 1, crew);
    if (!crew.leads()) return collector.collect([](std::uint64_t, const auto&) {});
    lead_writing(crew, [&](bool& is_begun) {
        write_points_in_pieces(path, head.dimension, head.points, head.comment, [&](const PointSink& sink) {
            is_begun = true;
            collector.collect([&](std::uint64_t, const std::vector<double>& piece) { sink(piece); });
        });
    });
    return true;
}

}

bool write_scattered_points(const std::filesystem::path& path, const PointFileHead& head, const SlabPoints& points,
                            Crew& crew)
{
    return has_known_places(path) ? write_placed(path, head, points, crew) : write_in_order(path, head, points, crew);
}

SlabPoints::SlabPoints(const SlabDivision& division, Crew& crew, std::uint64_t expected)
    : division_(division), crew_(crew),
      first_slab_(division.slabs() / static_cast<std::uint32_t>(crew.size()) * static_cast<std::uint32_t>(crew.rank())),
      own_(division.slabs() / static_cast<std::uint32_t>(crew.size())), around_(own_.size()), outbox_(crew)
{
    for (std::uint32_t slab = first_slab_; slab < end_slab(); ++slab) {
        const std::uint64_t layers = division.first_layer(slab + 1) - division.first_layer(slab);
        const std::uint64_t points = expected * layers / division.layers();
        own_[slab - first_slab_].coordinates.reserve((points + points / 64) *
                                                     static_cast<std::size_t>(division.dimension()));
        own_[slab - first_slab_].ids.reserve(points + points / 64);
    }
}

void SlabPoints::put(std::span<const double> place, std::uint32_t id)
{
    const std::uint32_t slab = division_.slab_of(place.back());
    if (is_here(slab))
        own_[slab - first_slab_].add(place, id);
    else
        outbox_.add(process_of(slab), place, id, slab);
}

bool SlabPoints::settle()
{
    const auto axes = static_cast<std::size_t>(division_.dimension());
    return outbox_.send(crew_, [&](const SentPoint& point) {
        own_[point.slab - first_slab_].add(std::span(point.place).first(axes), point.id);
    });
}

bool SlabPoints::fetch_around(std::uint32_t layers)
{
    const auto axes = static_cast<std::size_t>(division_.dimension());
    const auto slabs_around = division_.slabs_around_layers(layers);
    const bool is_collected = crew_.together([&] {
        for (NumberedPoints& points : around_) points.clear();
        for (const NumberedPoints& points : own_)
            for (std::size_t i = 0; i < points.size(); ++i) {
                const std::span place = std::span(points.coordinates).subspan(i * axes, axes);
                for (const std::uint32_t slab : slabs_around[division_.layer_of(place.back())])
                    if (is_here(slab))
                        around_[slab - first_slab_].add(place, points.ids[i]);
                    else
                        outbox_.add(process_of(slab), place, points.ids[i], slab);
            }
    });
    return is_collected && outbox_.send(crew_, [&](const SentPoint& point) {
        around_[point.slab - first_slab_].add(std::span(point.place).first(axes), point.id);
    });
}

void SlabPoints::clear()
{
    for (NumberedPoints& points : own_) points.clear();
    for (NumberedPoints& points : around_) points.clear();
}

}
