// Runs kernels/class_darts.cl: a batch of slots after the other, until all classes are at their ends or full.
#include "host/sampling/classes/class_darts.hpp"

#include "base/geometry/torus.hpp"
#include "host/sampling/classes/class_buffers.hpp"
#include "host/sampling/classes/class_cells.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace poissonlab {

using contract::class_darts::ClassCells;
using contract::class_darts::ClassSlot;
using contract::class_darts::SlotBatch;

namespace {

constexpr std::size_t least_slots = 16, first_slots = 64;

class ThrowingClasses
{
public:
    ThrowingClasses(Device& device, ClassDartBuffers& buffers, const ClassDartRequest& request, std::size_t group_size)
        : device_(device), buffers_(buffers), request_(request), group_size_(group_size), order_({}, {}),
          distances_(request.distances), open_(request.distances.classes()), lists_(open_.size()),
          is_full_(open_.size())
    {
        const KernelProgram program =
            kernel_program("class_darts.cl", {{"DIMENSION", request.dimension}, {"REGION", request.region != nullptr}});
        find_ = device.kernel(program, "find_darts");
        settle_ = device.kernel(program, "settle_class_darts");
        mark_ = device.kernel(program, "mark_cells");
        cover_ = device.kernel(program, "cover_cells");
        reserve(device, class_buffers(buffers, request));
        for (const ClassDartBuffers::Words* words : {&buffers.heads, &buffers.points, &buffers.cells, &buffers.covered})
            ask_for_large_pages(words->impl());
        const ClassGrids grids = class_grids(request);
        buffers.pairs.write(class_pairs(distances_, request.shares));
        buffers.grids.write(grids.grids);
        buffers.heads.write(std::vector<std::uint32_t>(grids.cells));
        buffers.covered_cells.write(covered_grids(request).grids);
        mark_all();
    }

    ClassedPoints run()
    {
        std::vector<std::size_t> ends;
        for (std::size_t i = 0; i < part_count(request_); ++i) {
            const ClassPart part = part_of(request_, i);
            const std::size_t first = classes_.size();
            fill(part);
            ends.push_back(classes_.size());
            if (request_.on_filled && !part.densities.empty()) request_.on_filled(i, part, points_since(first));
        }
        ClassedPoints result = points_since(0);
        result.part_ends = std::move(ends);
        return result;
    }

private:
    void fill(const ClassPart& part)
    {
        part_ = &part;
        order_ = FillOrder(part.shares, part.points);
        if (part.region) buffers_.region.write(*part.region);
        start_anywhere();
        write_lists();
        std::uint32_t skipped = 0;
        std::size_t wanted = first_slots;
        while (order_.next()) {
            const std::vector<ClassSlot> slots = next_slots(wanted);
            const auto [settled, redrawn] = settle(slots, skipped);
            for (std::size_t i = 0; i < settled; ++i) {
                order_.add(slots[i].own);
                classes_.push_back(slots[i].own);
            }
            if (settled > 0) mark_points(settled);
            skipped = settled > 0 ? 0 : skipped;
            const bool has_stalled = settled < slots.size();
            if (has_stalled) skipped = refine(slots[settled].own, skipped) ? skipped + contract::class_darts::TRIES : 0;
            // How many slots a batch has changes nothing but time: those that meet each other are settled one by one.
            const bool are_too_many = has_stalled || 4 * redrawn > settled;
            wanted = are_too_many ? std::max(least_slots, wanted / 2)
                                  : std::clamp(classes_.size() / 4, least_slots, std::min(2 * wanted, most_slots));
        }
        for (std::uint32_t i = 0; i < open_.size(); ++i)
            if (order_.is_closed(i) && order_.counts()[i] < part.most_of(i)) is_full_[i] = true;
    }

    void start_anywhere()
    {
        for (std::uint32_t i = 0; i < open_.size(); ++i) {
            open_[i] = start_cells(*part_, request_.dimension, distances_, i);
            if (open_[i].cells.empty()) order_.close(i);
        }
    }

    /// Calls run() with the arguments that kernels take for the region.
    template <typename Run>
    void with_region(const Run& run) const
    {
        const RegionBuffers& r = buffers_.region;
        if (part_->region)
            run(region_grid(*part_->region), r.cells, r.edges, r.filled);
        else
            run();
    }

    SlotBatch batch_of(std::size_t slots, std::uint32_t skipped) const
    {
        return {.classes = words(open_.size()),
                .first = words(classes_.size()),
                .slots = words(slots),
                .skipped = skipped,
                .key_x = request_.stream[0],
                .key_y = request_.stream[1]};
    }

    std::vector<ClassSlot> next_slots(std::size_t wanted) const
    {
        FillOrder order = order_;
        std::vector<ClassSlot> slots;
        for (auto next = order.next(); next && slots.size() < wanted; next = order.next()) {
            slots.push_back({*next, target_of(*next, order.counts()[*next], request_.stream)});
            order.add(*next);
        }
        return slots;
    }

    /// The number of slots that have a point now, and of those that needed another dart.
    std::pair<std::size_t, std::size_t> settle(const std::vector<ClassSlot>& slots, std::uint32_t skipped)
    {
        ClassDartBuffers& b = buffers_;
        const SlotBatch batch = batch_of(slots.size(), skipped);
        b.slots.write(slots);
        with_region([&](const auto&... region) {
            find_.run(slots.size(), group_size_, batch, b.slots, b.pairs, b.grids, b.lists, b.cells, b.starts, b.heads,
                      b.points, b.covered_cells, b.covered, b.candidates, region...);
            settle_.run(1, 1, batch, b.slots, b.pairs, b.grids, b.lists, b.cells, b.starts, b.heads, b.points,
                        b.covered_cells, b.covered, b.candidates, b.counters, region...);
        });
        std::array<std::uint32_t, contract::class_darts::COUNTERS> counters{};
        b.counters.read(counters);
        return {counters[contract::class_darts::SETTLED], counters[contract::class_darts::REDRAWN]};
    }

    /// Returns whether there may still be room for the class.
    bool refine(std::uint32_t own, std::uint32_t skipped)
    {
        if (open_[own].level == 0) {
            open_[own] = all_cells(first_level(distances_, own) - 1, request_.dimension);
            write_lists();
        }
        const std::size_t points = order_.counts()[own];
        const auto level = level_after(open_[own], distances_, own, skipped / contract::class_darts::TRIES, points,
                                       part_->points.empty() ? 0 : part_->points[own]);
        if (!level) return true;
        ClassDartBuffers& b = buffers_;
        const std::size_t count = open_[own].count(request_.dimension);
        reserve(device_, b.kept, count);
        with_region([&](const auto&... region) {
            cover_.run(count, group_size_, batch_of(0, 0), own, lists_[own], *level, b.pairs, b.grids, b.cells, b.heads,
                       b.points, b.covered_cells, b.covered, b.kept, region...);
        });
        open_[own] = refined(open_[own], b.kept.read(0, count), request_.dimension, *level);
        open_[own].covered_at = points;
        const bool goes_on = !open_[own].cells.empty() || shrink();
        if (!goes_on) order_.close(own);
        write_lists();
        return goes_on;
    }

    /// Makes all distances smaller. Returns whether they may be.
    bool shrink()
    {
        if (part_->points.empty() || request_.factor >= 1) return false;
        scale_ *= request_.factor;
        distances_ = request_.distances.scaled(scale_);
        buffers_.pairs.write(class_pairs(distances_, request_.shares));
        mark_all();
        start_anywhere();
        return true;
    }

    /// Marks the cells that the last points cover.
    void mark_points(std::size_t count)
    {
        SlotBatch batch = batch_of(count, 0);
        batch.first -= batch.slots;
        mark_.run(count, group_size_, batch, buffers_.pairs, buffers_.points, buffers_.covered_cells, buffers_.covered);
    }

    /// Marks the cells that all points cover at the present distances.
    void mark_all()
    {
        buffers_.covered.write(std::vector<std::uint32_t>(buffers_.covered.size()));
        if (!classes_.empty()) mark_points(classes_.size());
    }

    void write_lists()
    {
        std::size_t all = 0;
        for (std::size_t i = 0; i < open_.size(); ++i) {
            const std::size_t count = open_[i].count(request_.dimension);
            lists_[i] = {.level = open_[i].level,
                         .first = words(all),
                         .count = words(count),
                         .spread = spread_of(open_[i], part_->points.empty() ? 1 : part_->points[i])};
            all += count;
        }
        reserve(device_, buffers_.cells, all * static_cast<std::size_t>(request_.dimension));
        reserve(device_, buffers_.starts, std::max<std::size_t>(1, all));
        for (std::size_t i = 0; i < open_.size(); ++i) {
            buffers_.cells.write(open_[i].cells, lists_[i].first * static_cast<std::size_t>(request_.dimension));
            if (lists_[i].spread > 0) buffers_.starts.write(open_[i].starts, lists_[i].first);
        }
        buffers_.lists.write(lists_);
    }

    ClassedPoints points_since(std::size_t first) const
    {
        const auto axes = static_cast<std::size_t>(request_.dimension);
        const std::size_t all = contract::class_darts::POINT_WORDS(axes);
        const std::vector<std::uint32_t> points = buffers_.points.read(first * all, (classes_.size() - first) * all);
        ClassedPoints result{
            {request_.dimension, {}}, {classes_.begin() + static_cast<std::ptrdiff_t>(first), classes_.end()}, {}};
        result.points.coordinates.reserve(result.classes.size() * axes);
        for (std::size_t i = 0; i < result.classes.size(); ++i)
            for (std::size_t k = 0; k < axes; ++k) result.points.coordinates.push_back(points[i * all + k] * 0x1p-32);
        result.is_full = is_full_;
        result.scale = scale_;
        return result;
    }

    static std::uint32_t words(std::size_t value) { return static_cast<std::uint32_t>(value); }

    Device& device_;
    ClassDartBuffers& buffers_;
    const ClassDartRequest& request_;
    std::size_t group_size_;
    const ClassPart* part_ = nullptr; ///< the one that is filled
    FillOrder order_;
    double scale_ = 1;
    ClassDistances distances_; ///< those of the request, scaled
    std::vector<OpenCells> open_;
    std::vector<ClassCells> lists_;      ///< where those are on the device
    std::vector<std::uint32_t> classes_; ///< of the points so far
    std::vector<bool> is_full_;          ///< of each class, in a part
    Kernel find_, settle_, mark_, cover_;
};

}

std::vector<std::size_t> ClassedPoints::counts() const
{
    std::vector<std::size_t> counts(is_full.size());
    for (const std::uint32_t own : classes) ++counts[own];
    return counts;
}

PointSet ClassedPoints::of_class(std::uint32_t wanted) const
{
    PointSet set{points.dimension, {}};
    for (std::size_t i = 0; i < classes.size(); ++i)
        if (classes[i] == wanted) set.coordinates.insert(set.coordinates.end(), points[i].begin(), points[i].end());
    return set;
}

ClassDartThrower::ClassDartThrower(Device device, std::size_t work_group_size)
    : DeviceMethod(std::move(device), work_group_size, std::make_shared<ClassDartBuffers>())
{}

ClassedPoints ClassDartThrower::throw_darts(const ClassDartRequest& request)
{
    return ThrowingClasses(device_, *buffers_, request, work_group_size_).run();
}

DeviceMemory ClassDartThrower::memory(const ClassDartRequest& request)
{
    ClassDartBuffers buffers;
    return memory_of(class_buffers(buffers, request));
}

}
