// Runs kernels/dart_throwing.cl: one batch of darts after the other, until there are points enough or no open
// cells.
#include "host/sampling/dart_throwing.hpp"

#include "base/geometry/torus.hpp"
#include "host/sampling/cells/cell_hierarchy.hpp"
#include "host/sampling/darts/dart_memory.hpp"
#include "host/sampling/darts/darts_in_blocks.hpp"
#include "kernels/common/darts/dart_throwing.h"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <array>
#include <span>
#include <tuple>

namespace poissonlab {
namespace {

/// An accepted dart, as the kernels write it.
template <int D>
struct Point
{
    TorusPoint<D> position;
    std::uint32_t time;

    bool operator<(const Point& other) const { return std::tie(time, position) < std::tie(other.time, other.position); }
};

KernelProgram throwing_program(const DartTorus& torus, bool has_region)
{
    return kernel_program("dart_throwing.cl", {{"DIMENSION", torus.dimension},
                                               {"REACH", torus.hierarchy.reach},
                                               {"LARGE_DISKS", torus.has_large_disks},
                                               {"BRICKS", torus.bricks != nullptr},
                                               {"REGION", has_region}});
}

/// Cells of a block along each axis, halo included: what is known of them stays in a processor's caches.
constexpr std::uint32_t fast_block_side = 1024;

/// Cells along each axis of larger tori do not, and darts come from anywhere: block by block they are faster. (In 3D
/// halos would take more than that saves.)
constexpr std::uint32_t most_side_at_once = 2048;

bool is_thrown_in_blocks(const DartThrowingRequest& request, const DeviceInfo& device)
{
    return request.dimension == 2 && !request.region && !request.block &&
           settling_for(device) == DartSettling::in_order &&
           cell_hierarchy(request.min_distance, 2).size > most_side_at_once;
}

template <int D>
class Throwing
{
public:
    Throwing(Device& device, DartBuffers& buffers, const DartThrowingRequest& request, std::size_t group_size,
             DartSettling settling)
        : device_(device), buffers_(buffers), request_(request), group_size_(group_size),
          torus_(request.min_distance, D, request.block, request.bricks),
          throw_(device.kernel(throwing_program(torus_, has_land(request)), "throw_darts")),
          settler_(make_dart_settler(device, settling, torus_, group_size))
    {
        reserve(device, dart_buffers(buffers, request, settling, device.info().compute_units));
        buffers_.counters.write(std::array<std::uint32_t, COUNTERS>{});
        buffers_.land.write(request);
        if (torus_.bricks) {
            buffers_.brick_corners.write(torus_.bricks->corners);
            buffers_.bricks_around.write(torus_.bricks->around);
        }
    }

    PointSet run()
    {
        throw_all();
        PointSet set{D, {}};
        const std::vector<Point<D>> sorted = points_in_order();
        const std::size_t size = std::min(sorted.size(), request_.points.value_or(SIZE_MAX));
        set.coordinates.reserve(size * D);
        for (const Point<D>& point : std::span(sorted).first(size))
            for (const std::uint32_t c : point.position) set.coordinates.push_back(c * 0x1p-32);
        return set;
    }

    std::vector<OrderedDart<D>> run_ordered()
    {
        throw_all();
        const std::vector<Point<D>> sorted = points_in_order();
        std::vector<OrderedDart<D>> darts(sorted.size());
        std::uint32_t batch = 0;
        for (std::size_t i = 0; i < sorted.size(); ++i) {
            while (i >= batch_ends_[batch]) ++batch;
            darts[i] = {batch, sorted[i].time};
            std::ranges::copy(sorted[i].position, darts[i].begin() + 2);
        }
        return darts;
    }

private:
    using enum contract::dart_throwing::Counter;
    static constexpr std::size_t dart_words = contract::dart_throwing::DART_WORDS(D);

    std::size_t parent_words() const { return contract::dart_throwing::PARENT_WORDS(D, torus_.bricks != nullptr); }

    /// Runs a kernel with the region and the bricks, if there are any.
    template <typename Run>
    void run_with_place(const Run& run) const
    {
        buffers_.land.run_with(request_, [&](const auto&... region) {
            torus_.run_with_bricks(buffers_, [&](const auto&... bricks) { run(region..., bricks...); });
        });
    }

    void throw_all()
    {
        const std::size_t target = request_.points.value_or(SIZE_MAX);
        std::size_t parent_count = torus_.cells();
        int level = 0;
        for (std::uint32_t batch = 0; batch < request_.most_batches && point_count() < target && parent_count > 0;
             ++batch) {
            write_thresholds(batch);
            const bool split = splits_cells(batch) && level < torus_.hierarchy.last_level;
            if (split) ++level;
            const auto [open_count, dart_count] = throw_batch(parent_count, level, split, batch);
            settler_->settle(buffers_, dart_count);
            std::uint32_t total = 0;
            buffers_.counters.read({&total, 1}, POINTS);
            batch_ends_.push_back(total);
            if (total < target) settler_->prepare_batch(buffers_);
            if (batch == 0 && !torus_.bricks) continue; // all cells stay open, and the kernel lists none
            std::swap(buffers_.parents, buffers_.open);
            parent_count = open_count;
        }
    }

    void write_thresholds(std::uint32_t batch)
    {
        if (batch > 0 && darts_per_cell(batch, D) == darts_per_cell(batch - 1, D)) return;
        const auto thresholds = poisson_thresholds(darts_per_cell(batch, D));
        threshold_count_ = u32(thresholds.size());
        buffers_.thresholds.write(thresholds);
    }

    struct Counts
    {
        std::size_t open_cells;
        std::size_t darts;
    };

    /// throw_darts, repeated with larger lists where they did not suffice.
    Counts throw_batch(std::size_t parent_count, int level, bool split, std::uint32_t number)
    {
        DartBuffers& b = buffers_;
        using contract::dart_throwing::THROW_RUN;
        const std::size_t items = (parent_count + THROW_RUN - 1) / THROW_RUN;
        const std::size_t group_size = std::max<std::size_t>(1, group_size_ / THROW_RUN);
        const std::size_t staged = staged_entries();
        for (;;) {
            const contract::dart_throwing::Batch batch{.step = torus_.hierarchy.step,
                                                       .squared_min_distance = torus_.squared_min_distance,
                                                       .part = torus_.part,
                                                       .grid_size = torus_.grid_size,
                                                       .number = number,
                                                       .parents = u32(parent_count),
                                                       .level = level,
                                                       .is_split = split,
                                                       .is_last_level = !split && level == torus_.hierarchy.last_level,
                                                       .key_x = request_.stream[0],
                                                       .key_y = request_.stream[1],
                                                       .thresholds = threshold_count_,
                                                       .open_capacity = u32(b.open.size() / parent_words()),
                                                       .dart_capacity = u32(b.darts.size() / dart_words),
                                                       .staged_capacity = u32(staged)};
            run_with_place([&](const auto&... place) {
                throw_.run(items, group_size, batch, b.parents, b.masks, b.slots, b.positions, b.thresholds, b.open,
                           b.darts, b.counters, local_words(staged * parent_words()), local_words(staged * dart_words),
                           local_words(contract::dart_throwing::GROUP_WORDS), place...);
            });
            std::array<std::uint32_t, 2> counts;
            b.counters.read(counts, OPEN_CELLS);
            if (counts[0] <= batch.open_capacity && counts[1] <= batch.dart_capacity) return {counts[0], counts[1]};
            b.counters.write(std::array<std::uint32_t, 2>{}, OPEN_CELLS);
            reserve(device_, b.open, counts[0] * parent_words());
            reserve(device_, b.darts, counts[1] * dart_words);
        }
    }

    /// The points in dart order: batch after batch, and within a batch by time.
    std::vector<Point<D>> points_in_order() const
    {
        std::vector<Point<D>> sorted(point_count());
        constexpr std::size_t words = contract::dart_throwing::POINT_WORDS(D);
        static_assert(sizeof(Point<D>) == words * sizeof(std::uint32_t));
        buffers_.points.read({reinterpret_cast<std::uint32_t*>(sorted.data()), sorted.size() * words});
        auto begin = sorted.begin();
        for (const std::size_t batch_end : batch_ends_) {
            const auto end = sorted.begin() + static_cast<std::ptrdiff_t>(batch_end);
            tbb::parallel_sort(begin, end);
            begin = end;
        }
        return sorted;
    }

    std::size_t point_count() const { return batch_ends_.empty() ? 0 : batch_ends_.back(); }

    /// Each list in local memory holds all that a work-group can make, or as many as there is room for.
    std::size_t staged_entries() const
    {
        const std::size_t entry_bytes = (parent_words() + dart_words) * sizeof(std::uint32_t);
        constexpr std::size_t group_bytes = contract::dart_throwing::GROUP_WORDS * sizeof(std::uint32_t);
        return std::min(group_size_ * (std::size_t{1} << D),
                        (device_.info().local_memory_bytes - group_bytes) / entry_bytes);
    }

    static LocalMemory local_words(std::size_t count) { return {count * sizeof(std::uint32_t)}; }
    static std::uint32_t u32(std::size_t value) { return static_cast<std::uint32_t>(value); }

    Device& device_;
    DartBuffers& buffers_;
    const DartThrowingRequest& request_;
    std::size_t group_size_;
    DartTorus torus_;
    Kernel throw_;
    std::unique_ptr<DartSettler> settler_;
    std::uint32_t threshold_count_ = 0;
    std::vector<std::size_t> batch_ends_; ///< number of points after each batch
};

}

DartThrower::DartThrower(Device device, std::size_t work_group_size, std::optional<DartSettling> settling)
    : DeviceMethod(std::move(device), work_group_size, std::make_shared<DartBuffers>()),
      settling_(settling.value_or(settling_for(device_.info())))
{}

PointSet DartThrower::throw_darts(const DartThrowingRequest& request)
{
    if (is_thrown_in_blocks(request, device_.info())) {
        const auto throw_block = [this](const DartThrowingRequest& block) { return ordered_darts<2>(block); };
        const std::vector<OrderedDart<2>> darts = throw_in_blocks<2>(throw_block, request, fast_block_side);
        PointSet set{2, {}};
        const std::size_t size = std::min(darts.size(), request.points.value_or(SIZE_MAX));
        set.coordinates.reserve(2 * size);
        for (const OrderedDart<2>& dart : std::span(darts).first(size))
            for (const std::uint32_t c : std::span(dart).subspan(2)) set.coordinates.push_back(c * 0x1p-32);
        return set;
    }
    return request.dimension == 2 ? Throwing<2>(device_, *buffers_, request, work_group_size_, settling_).run()
                                  : Throwing<3>(device_, *buffers_, request, work_group_size_, settling_).run();
}

template <int D>
std::vector<OrderedDart<D>> DartThrower::ordered_darts(const DartThrowingRequest& request)
{
    return Throwing<D>(device_, *buffers_, request, work_group_size_, settling_).run_ordered();
}

template std::vector<OrderedDart<2>> DartThrower::ordered_darts<2>(const DartThrowingRequest& request);
template std::vector<OrderedDart<3>> DartThrower::ordered_darts<3>(const DartThrowingRequest& request);

DeviceMemory DartThrower::memory(const DartThrowingRequest& request, const DeviceInfo& device)
{
    DartBuffers buffers;
    DartThrowingRequest thrown = request;
    if (is_thrown_in_blocks(request, device)) thrown.block = DartBlock{{}, fast_block_side};
    return memory_of(dart_buffers(buffers, thrown, settling_for(device), device.compute_units));
}

}
