#include "host/large_sets/large_darts.hpp"

#include "base/errors/errors.hpp"
#include "base/files/output_place.hpp"
#include "base/files/scratch_folder.hpp"
#include "base/geometry/lattice.hpp"
#include "base/geometry/relative_radius.hpp"
#include "base/programs/interrupt.hpp"
#include "host/sampling/darts/darts_in_blocks.hpp"

#include <fmt/format.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>

namespace poissonlab {
namespace {

/// Cells of a block along each axis, halo included, that are fast: what is known of them stays in caches, and halos are
/// still a small part.
constexpr std::uint32_t fast_block_side(int dimension) { return dimension == 2 ? 1024 : 256; }

/// Bytes that the plain twin takes for a cell, nearly.
constexpr std::uint64_t reference_cell_bytes = 64;

template <int D>
ThrowBlock<D> block_thrower(const DistributionPlace& place)
{
    if (place.engine == Engine::reference) return reference::ordered_darts<D>;
    return [thrower = std::make_shared<DartThrower>(place.device())](const DartThrowingRequest& request) {
        return thrower->template ordered_darts<D>(request);
    };
}

/// The blocks of a set on disk, and what is known of them together.
template <int D>
class LargeThrowing
{
public:
    LargeThrowing(const LargeDarts& set, const DistributionPlace& place, std::filesystem::path folder, Crew& crew)
        : set_(set), place_(place), folder_(std::move(folder)), crew_(crew),
          hierarchy_(cell_hierarchy(set.darts.min_distance, D)), blocks_(blocks_with(usual_halo(D))),
          intervals_(set.expected_points)
    {}

    /// Throws all darts. False where a process failed.
    bool throw_all()
    {
        if (!crew_.together([&] { throw_block_ = block_thrower<D>(place_); })) return false;
        std::uint32_t batches = UINT32_MAX;
        if (!crew_.together([&] {
                if (crew_.leads()) batches = enough_batches<D>(throw_block_, set_.darts, blocks_);
            }))
            return false;
        batches = static_cast<std::uint32_t>(std::stoul(crew_.from_leader(std::to_string(batches))));
        for (std::uint32_t halo = usual_halo(D);;) {
            blocks_ = blocks_with(halo);
            if (!throw_blocks(batches)) return false;
            if (!blocks_.marks_agree(marks_)) {
                halo *= 2;
            } else if (points() < set_.darts.points.value_or(0) && batches < UINT32_MAX) {
                batches = UINT32_MAX;
            } else {
                return true;
            }
        }
    }

    /// The number of points that were found, which may be more than are wanted.
    std::uint64_t points() const { return std::accumulate(counts_.begin(), counts_.end(), std::uint64_t{0}); }

    /// The number of points before each piece, up to the piece that completes `wanted` points.
    std::vector<std::uint64_t> divide(std::uint64_t wanted)
    {
        pieces_ = dart_pieces(counts_);
        before_ = {0};
        for (std::size_t p = 0; p + 1 < pieces_.size() && before_.back() < wanted; ++p) {
            const auto begin = counts_.begin() + static_cast<std::ptrdiff_t>(pieces_[p]);
            const auto end = counts_.begin() + static_cast<std::ptrdiff_t>(pieces_[p + 1]);
            before_.push_back(std::min(wanted, std::accumulate(begin, end, before_.back())));
        }
        return before_;
    }

    /// Makes the points of a piece, after divide().
    void make(std::uint32_t piece, std::vector<double>& coordinates)
    {
        stop_if_interrupted();
        darts_.clear();
        for (std::uint32_t block = 0; block < blocks_.count(); ++block)
            read_run<D>(file_of(block), intervals_, pieces_[piece], pieces_[piece + 1], darts_);
        tbb::parallel_sort(darts_.begin(), darts_.end());
        coordinates.clear();
        coordinates.reserve((before_[piece + 1] - before_[piece]) * D);
        for (const OrderedDart<D>& dart : std::span(darts_).first(before_[piece + 1] - before_[piece]))
            for (std::size_t k = 0; k < D; ++k) coordinates.push_back(dart[k + 2] * 0x1p-32);
    }

private:
    DartBlocks blocks_with(std::uint32_t halo) const { return {hierarchy_, D, set_.block_side, halo}; }

    std::filesystem::path file_of(std::uint32_t block) const { return folder_ / std::to_string(block); }

    DartThrowingRequest request_of(std::uint32_t block) const
    {
        DartThrowingRequest request = set_.darts;
        request.points.reset();
        request.block = blocks_.with_halo(block);
        return request;
    }

    bool throw_blocks(std::uint32_t batches)
    {
        counts_.assign(intervals_.count(), 0);
        marks_.assign(blocks_.count() * blocks_.marks_per_block(), 0);
        std::uint32_t done = 0;
        Schedule schedule = one_job_each(blocks_.count());
        const bool is_done = crew_.work(
            schedule, [&](const Job& job) { throw_one(job.first, batches); },
            [&](const Job& /*job*/, bool /*here*/) {
                if (place_.on_step)
                    place_.on_step(fmt::format("dart throwing: {} of {} blocks", ++done, blocks_.count()));
            },
            {});
        if (!is_done) return false;
        counts_ = crew_.sum(counts_);
        marks_ = crew_.sum(marks_);
        return true;
    }

    void throw_one(std::uint32_t block, std::uint32_t batches)
    {
        DartThrowingRequest request = request_of(block);
        request.most_batches = batches;
        std::vector<OrderedDart<D>> darts = throw_block_(request);
        std::ranges::copy(blocks_.keep_own<D>(block, darts),
                          marks_.begin() + static_cast<std::ptrdiff_t>(block * blocks_.marks_per_block()));
        write_run<D>(file_of(block), darts, intervals_, counts_);
    }

    const LargeDarts& set_;
    const DistributionPlace& place_;
    std::filesystem::path folder_;
    Crew& crew_;
    CellHierarchy hierarchy_;
    ThrowBlock<D> throw_block_;
    DartBlocks blocks_;
    DartIntervals intervals_;
    std::vector<std::uint64_t> counts_; ///< points of each interval
    std::vector<std::uint64_t> marks_;  ///< of each block
    std::vector<std::size_t> pieces_;   ///< the intervals at which they begin
    std::vector<std::uint64_t> before_; ///< points before each piece
    std::vector<OrderedDart<D>> darts_; ///< of a piece
};

/// The set is saturated before it has its points.
InputError too_few_points(const LargeDarts& set, std::uint64_t reached)
{
    const int d = set.darts.dimension;
    const std::uint64_t wanted = set.darts.points.value_or(0);
    const double reachable = relative_radius(set.darts.min_distance, wanted, d) *
                             std::pow(static_cast<double>(reached) / static_cast<double>(wanted), 1.0 / d);
    return InputError(
        fmt::format("points dart-throwing: the set is saturated with {} of {} points: no further one fits; a "
                    "--relative-radius of about {:.4f} can be reached",
                    reached, wanted, reachable));
}

/// Writes the file of a set that was thrown.
template <int D>
void write_thrown(const std::filesystem::path& path, const PointFileHead& head, LargeThrowing<D>& throwing, Crew& crew)
{
    const std::vector<std::uint64_t> before = throwing.divide(head.points);
    const auto make = [&](std::uint32_t piece, std::vector<double>& to) { throwing.make(piece, to); };
    if (has_known_places(path)) return write_placed_pieces(path, head, before, make, crew);
    crew.together([&] {
        if (!crew.leads()) return;
        write_points_in_pieces(path, D, head.points, head.comment, [&](const PointSink& sink) {
            std::vector<double> coordinates;
            for (std::uint32_t piece = 0; piece + 1 < before.size(); ++piece) {
                make(piece, coordinates);
                sink(coordinates);
            }
        });
    });
}

template <int D>
std::uint64_t write_darts_of(const std::filesystem::path& path, PointFileHead head, const LargeDarts& set,
                             const DistributionPlace& place, Crew& crew)
{
    std::optional<ScratchFolder> scratch; // of the process that leads
    const bool has_room = crew.together([&] {
        if (!crew.leads()) return;
        head.points = set.expected_points;
        check_room(path, head, sizeof(OrderedDart<D>));
        scratch.emplace(std::filesystem::absolute(output_place(path).file));
    });
    if (!has_room) return 0;
    LargeThrowing<D> throwing(set, place, crew.from_leader(scratch ? scratch->path().string() : ""), crew);
    if (!throwing.throw_all()) return 0;
    head.points = set.darts.points.value_or(throwing.points());
    const bool fits = crew.together([&] {
        if (throwing.points() < head.points) throw too_few_points(set, throwing.points());
        check_head(path, head);
        check_room(path, head);
    });
    if (fits) write_thrown<D>(path, head, throwing, crew);
    return head.points;
}

}

std::uint32_t block_side_for(const DartThrowingRequest& darts, std::uint64_t most_bytes,
                             const std::optional<DeviceInfo>& device)
{
    const int d = darts.dimension;
    const std::uint32_t least = 4 * usual_halo(d);
    DartThrowingRequest request = darts;
    for (std::uint32_t side = std::min(fast_block_side(d), cell_hierarchy(darts.min_distance, d).size);;
         side = std::max(least, side / 8 * 7)) {
        request.block = DartBlock{{}, side};
        const DeviceMemory memory = device ? DartThrower::memory(request, *device)
                                           : DeviceMemory{}.add(lattice_cells(side, d) * reference_cell_bytes);
        if (memory.total <= most_bytes && (!device || fits(memory, *device))) return side;
        if (side <= least) {
            if (device) check_fits("points dart-throwing", memory, *device);
            throw InputError(fmt::format("points dart-throwing: --memory {:.3g}: must be at least {:.3g} here",
                                         static_cast<double>(most_bytes) * 1e-9,
                                         std::ceil(static_cast<double>(memory.total) * 1e-6) * 1e-3));
        }
    }
}

std::uint64_t write_large_darts(const std::filesystem::path& path, PointFileHead head, const LargeDarts& set,
                                const DistributionPlace& place, Crew& crew)
{
    return set.darts.dimension == 2 ? write_darts_of<2>(path, std::move(head), set, place, crew)
                                    : write_darts_of<3>(path, std::move(head), set, place, crew);
}

}
