// Runs kernels/dart_throwing.cl: one batch of darts after the other, until there are points enough or no open
// cells.
#include "host/sampling/dart_throwing.hpp"

#include "base/geometry/lattice.hpp"
#include "base/geometry/torus.hpp"
#include "host/sampling/cell_hierarchy.hpp"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace poissonlab {
namespace {

/// Resolution rounds that are enqueued before the host looks whether all darts are decided, and each time
/// after that.
constexpr std::uint32_t first_rounds = 6;
constexpr std::uint32_t further_rounds = 3;

/// Darts that one work-item of insert_points owns.
constexpr std::uint32_t insertion_run = 16;

/// Positions in the counters buffer, as in the kernel file.
enum Counter : std::size_t
{
    open_cells,
    darts,
    points,
    waiting_round,
    counter_count
};

/// An accepted dart, as insert_points writes it.
template <int D>
struct Point
{
    TorusPoint<D> position;
    std::uint32_t time;

    bool operator<(const Point& other) const { return std::tie(time, position) < std::tie(other.time, other.position); }
};

using Words = Buffer<std::uint32_t>;

// Words of device memory, as in the kernel file.

std::size_t dart_words(int dimension) { return static_cast<std::size_t>(dimension) + 2; }
constexpr std::size_t rival_words = 7 + 1;
std::size_t point_words(int dimension) { return static_cast<std::size_t>(dimension) + 1; }

/// A bit for each cell that a point of this cell may reach.
std::size_t mask_words(const CellHierarchy& hierarchy, int dimension)
{
    const std::size_t width = 2 * static_cast<std::size_t>(hierarchy.reach) + 1;
    return (width * width * (dimension == 2 ? 1 : width) + 31) / 32;
}

std::size_t six_deviations_above(double mean) { return static_cast<std::size_t>(mean + 6 * std::sqrt(mean)) + 1; }

/// No batch has more darts than the first, a Poisson number.
std::size_t most_darts(std::size_t cells, int dimension)
{
    return six_deviations_above(static_cast<double>(cells) * darts_per_cell(0, dimension));
}

/// The first subdivision leaves 0.83 open cells for each cell of level 0 in 2D, 1.60 in 3D, whatever the size of the
/// set; later batches fewer. The lists begin with one.
std::size_t most_open_cells(std::size_t cells, int dimension)
{
    return dimension == 2 ? cells : six_deviations_above(1.6 * static_cast<double>(cells));
}

}

struct DartThrower::Buffers
{
    Words thresholds;                               ///< of the batch at hand
    Words slots, masks, positions;                  ///< a level 0 cell each
    Words parents, open;                            ///< open cells before and after a batch
    Words darts, next, states, next_states, rivals; ///< a dart of the batch each
    Words points, counters;
};

namespace {

template <int D, typename Buffers>
class Throwing
{
public:
    Throwing(Device& device, Buffers& buffers, const DartThrowingRequest& request, std::size_t group_size)
        : device_(device), buffers_(buffers), request_(request), group_size_(group_size),
          hierarchy_(cell_hierarchy(request.min_distance, D)),
          squared_min_distance_(squared_threshold(request.min_distance))
    {
        const KernelProgram program = kernel_program(
            "dart_throwing.cl",
            {{"DIMENSION", D}, {"REACH", hierarchy_.reach}, {"LARGE_DISKS", request.min_distance > 0.25 ? 1 : 0}});
        throw_ = device.kernel(program, "throw_darts");
        link_ = device.kernel(program, "link_darts");
        resolve_ = device.kernel(program, "resolve_conflicts");
        insert_ = device.kernel(program, "insert_points");

        Buffers& b = buffers_;
        const std::size_t cells = lattice_cells(hierarchy_.size, D);
        reserve(device, b.slots, cells);
        reserve(device, b.masks, cells * mask_words(hierarchy_, D));
        reserve(device, b.positions, cells * D);
        reserve(device, b.points, packing_bound(request.min_distance, D) * point_words(D));
        reserve(device, b.counters, counter_count);
        b.counters.write(std::array<std::uint32_t, counter_count>{});

        // A guess that is rarely too small: throw_batch() mends it.
        reserve(device, b.parents, cells * D);
        reserve(device, b.open, cells * D);
        reserve(device, b.darts, cells * dart_words(D));
    }

    PointSet run()
    {
        const std::size_t target = request_.points.value_or(SIZE_MAX);
        std::size_t parent_count = lattice_cells(hierarchy_.size, D);
        int level = 0;
        for (std::uint32_t batch = 0; point_count() < target && parent_count > 0; ++batch) {
            write_thresholds(batch);
            const bool split = splits_cells(batch) && level < hierarchy_.last_level;
            if (split) ++level;
            const auto [open_count, dart_count] = throw_batch(parent_count, level, split, batch);
            resolve(dart_count);
            insert(dart_count);
            if (batch == 0) continue; // all cells stay open, and the kernel lists none
            std::swap(buffers_.parents, buffers_.open);
            parent_count = open_count;
        }
        const std::vector<TorusPoint<D>> all = points_in_order();
        return to_point_set<D>(std::span<const TorusPoint<D>>(all).first(std::min(all.size(), target)));
    }

private:
    void write_thresholds(std::uint32_t batch)
    {
        if (batch > 0 && darts_per_cell(batch, D) == darts_per_cell(batch - 1, D)) return;
        const auto thresholds = poisson_thresholds(darts_per_cell(batch, D));
        threshold_count_ = u32(thresholds.size());
        reserve(device_, buffers_.thresholds, thresholds.size());
        buffers_.thresholds.write(thresholds);
    }

    struct Counts
    {
        std::size_t open_cells;
        std::size_t darts;
    };

    /// throw_darts, repeated with larger lists where they did not suffice.
    Counts throw_batch(std::size_t parent_count, int level, bool split, std::uint32_t batch)
    {
        Buffers& b = buffers_;
        const std::size_t staged = group_size_ * (std::size_t{1} << D);
        const bool is_last_level = !split && level == hierarchy_.last_level;
        for (;;) {
            throw_.run(parent_count, group_size_, b.parents, u32(parent_count), b.masks, b.slots, b.positions,
                       hierarchy_.size, hierarchy_.step, level, u32(split), u32(is_last_level), batch,
                       squared_min_distance_, request_.stream[0], request_.stream[1], b.thresholds, threshold_count_,
                       b.open, u32(b.open.size() / D), b.darts, u32(b.darts.size() / dart_words(D)), b.counters,
                       LocalMemory{staged * D * sizeof(std::uint32_t)}, u32(staged),
                       LocalMemory{staged * dart_words(D) * sizeof(std::uint32_t)}, u32(staged),
                       LocalMemory{4 * sizeof(std::uint32_t)});
            std::array<std::uint32_t, 2> counts;
            b.counters.read(counts, open_cells);
            const bool fits = counts[0] <= b.open.size() / D && counts[1] <= b.darts.size() / dart_words(D);
            if (fits) return {counts[0], counts[1]};
            b.counters.write(std::array<std::uint32_t, 2>{}, open_cells);
            reserve(device_, b.open, counts[0] * D);
            reserve(device_, b.darts, counts[1] * dart_words(D));
        }
    }

    /// Decides all darts of the batch.
    void resolve(std::size_t dart_count)
    {
        Buffers& b = buffers_;
        reserve(device_, b.next, dart_count);
        reserve(device_, b.states, dart_count);
        reserve(device_, b.next_states, dart_count);
        reserve(device_, b.rivals, dart_count * rival_words);
        if (first_dart_ + dart_count >= UINT32_MAX) throw DeviceError("dart throwing: more than 2^32 darts");
        // At least one work-item, which clears the counters.
        link_.run(std::max<std::size_t>(dart_count, 1), group_size_, b.darts, u32(dart_count), u32(first_dart_),
                  b.slots, b.next, b.states, b.counters);
        std::uint32_t rounds = 0;
        for (std::uint32_t waiting = dart_count > 0 ? 0 : 1; waiting == rounds;) {
            const std::uint32_t end = rounds + (rounds == 0 ? first_rounds : further_rounds);
            for (; rounds < end; ++rounds) {
                resolve_.run(dart_count, group_size_, b.darts, u32(dart_count), u32(first_dart_), rounds, b.slots,
                             b.next, hierarchy_.size, squared_min_distance_, b.rivals, b.states, b.next_states,
                             b.counters);
                std::swap(b.states, b.next_states);
            }
            b.counters.read({&waiting, 1}, waiting_round);
        }
        first_dart_ += dart_count;
    }

    /// Makes points of the accepted darts of the batch.
    void insert(std::size_t dart_count)
    {
        if (dart_count == 0) return;
        Buffers& b = buffers_;
        insert_.run((dart_count + insertion_run - 1) / insertion_run, group_size_, b.darts, u32(dart_count),
                    insertion_run, b.states, hierarchy_.size, hierarchy_.step, squared_min_distance_, b.masks,
                    b.positions, b.points, b.counters);
        std::uint32_t total = 0;
        b.counters.read({&total, 1}, points);
        batch_ends_.push_back(total);
    }

    /// The points in dart order: batch after batch, and within a batch by time.
    std::vector<TorusPoint<D>> points_in_order() const
    {
        std::vector<Point<D>> sorted(point_count());
        static_assert(sizeof(Point<D>) == (D + 1) * sizeof(std::uint32_t));
        buffers_.points.read({reinterpret_cast<std::uint32_t*>(sorted.data()), sorted.size() * point_words(D)});
        auto begin = sorted.begin();
        for (const std::size_t batch_end : batch_ends_) {
            const auto end = sorted.begin() + static_cast<std::ptrdiff_t>(batch_end);
            tbb::parallel_sort(begin, end);
            begin = end;
        }
        std::vector<TorusPoint<D>> positions;
        positions.reserve(sorted.size());
        for (const Point<D>& point : sorted) positions.push_back(point.position);
        return positions;
    }

    std::size_t point_count() const { return batch_ends_.empty() ? 0 : batch_ends_.back(); }

    static std::uint32_t u32(std::size_t value) { return static_cast<std::uint32_t>(value); }

    Device& device_;
    Buffers& buffers_;
    const DartThrowingRequest& request_;
    std::size_t group_size_;
    CellHierarchy hierarchy_;
    std::uint64_t squared_min_distance_;
    Kernel throw_, link_, resolve_, insert_;
    std::uint32_t threshold_count_ = 0;
    std::size_t first_dart_ = 0;          ///< number of the batch's first dart
    std::vector<std::size_t> batch_ends_; ///< number of points after each batch that had darts
};

}

DartThrower::DartThrower(Device device, std::size_t work_group_size)
    : device_(std::move(device)), work_group_size_(work_group_size > 0 ? work_group_size : default_work_group_size),
      buffers_(std::make_unique<Buffers>())
{}

DartThrower::~DartThrower() = default;

PointSet DartThrower::throw_darts(const DartThrowingRequest& request)
{
    return request.dimension == 2 ? Throwing<2, Buffers>(device_, *buffers_, request, work_group_size_).run()
                                  : Throwing<3, Buffers>(device_, *buffers_, request, work_group_size_).run();
}

DeviceMemory DartThrower::memory(const DartThrowingRequest& request)
{
    const int d = request.dimension;
    const auto axes = static_cast<std::uint64_t>(d);
    const CellHierarchy hierarchy = cell_hierarchy(request.min_distance, d);
    const std::size_t cells = lattice_cells(hierarchy.size, d);
    const std::size_t darts = most_darts(cells, d);
    DeviceMemory memory;
    const auto words = [&memory](std::uint64_t count) { memory.add_buffer<std::uint32_t>(count); };
    words(cells);
    words(cells * mask_words(hierarchy, d));
    words(cells * axes);
    words(packing_bound(request.min_distance, d) * point_words(d));
    words(counter_count);
    for (int i = 0; i < 2; ++i) words(most_open_cells(cells, d) * axes);
    words(std::max(cells, darts) * dart_words(d)); // at first a cell each
    for (int i = 0; i < 3; ++i) words(darts);      // next, and the states
    words(darts * rival_words);
    return memory;
}

}
