// Runs kernels/varied_darts.cl: a batch of slots after the other, until there are points enough or no cell has room.
#include "host/sampling/varied/varied_darts.hpp"

#include "host/device/needed_buffers.hpp"
#include "host/sampling/cells/region_buffers.hpp"
#include "host/sampling/varied/varied_cells.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

namespace poissonlab {

using contract::varied_darts::DistanceRule;
using contract::varied_darts::OpenCell;
using contract::varied_darts::VariedBatch;

struct VariedDartBuffers
{
    using Words = Buffer<std::uint32_t>;

    Words nodes, bounds; ///< of the field
    Buffer<OpenCell> cells, looked_at;
    Words candidates; ///< a slot of the batch each
    Words heads, points, counters;
    RegionBuffers region;
};

namespace {

constexpr std::size_t least_varied_slots = 16, first_varied_slots = 64, most_varied_slots = 65'536;

/// Cells for each point, about.
constexpr std::size_t varied_cells_a_point = 4;

std::size_t bucket_count(const VariedDartRequest& request)
{
    return std::bit_ceil(std::max<std::size_t>(1024, 2 * request.expected));
}

NeededBuffers varied_buffers(VariedDartBuffers& b, const VariedDartRequest& request)
{
    const std::size_t cells = varied_cells_a_point * request.expected + 64;
    NeededBuffers needed{{b.nodes, request.field->nodes().size()},
                         {b.bounds, request.field->bounds().size()},
                         {b.cells, cells},
                         {b.looked_at, cells},
                         {b.candidates, most_varied_slots},
                         {b.heads, bucket_count(request)},
                         {b.points, (request.expected + 64) * contract::varied_darts::POINT_WORDS},
                         {b.counters, contract::varied_darts::COUNTERS}};
    const NeededBuffers region = b.region.needed(*request.region);
    needed.insert(needed.end(), region.begin(), region.end());
    return needed;
}

class ThrowingVaried
{
public:
    ThrowingVaried(Device& device, VariedDartBuffers& buffers, const VariedDartRequest& request, std::size_t group_size)
        : device_(device), buffers_(buffers), request_(request), group_size_(group_size), rule_(distance_rule(request))
    {
        const KernelProgram program = kernel_program("varied_darts.cl", {});
        look_ = device.kernel(program, "look_at_cells");
        find_ = device.kernel(program, "find_varied_darts");
        settle_ = device.kernel(program, "settle_varied_darts");
        reserve(device, varied_buffers(buffers, request));
        rule_.buckets = word(bucket_count(request) - 1);
        buffers.nodes.write(request.field->nodes());
        buffers.bounds.write(request.field->bounds());
        buffers.heads.write(std::vector<std::uint32_t>(bucket_count(request)));
        buffers.region.write(*request.region);
        refine();
    }

    VariedDarts run()
    {
        std::uint64_t skipped = 0;
        std::size_t wanted = first_varied_slots;
        while (!cells_.cells().empty() && count_ < request_.points.value_or(SIZE_MAX)) {
            const std::size_t slots = std::min(wanted, request_.points.value_or(SIZE_MAX) - count_);
            const auto [settled, redrawn] = settle(slots, skipped);
            count_ += settled;
            skipped = settled > 0 ? 0 : skipped;
            const bool has_stalled = settled < slots;
            if (has_stalled) {
                go_on();
                skipped += tries_of(request_);
            }
            // How many slots a batch has changes nothing but time: those that meet each other are settled one by one.
            const bool are_too_many = has_stalled || 4 * redrawn > settled;
            wanted = are_too_many ? std::max(least_varied_slots, wanted / 2)
                                  : std::clamp(count_ / 4, least_varied_slots, std::min(2 * wanted, most_varied_slots));
        }
        return result();
    }

private:
    /// Calls a kernel with what all of them are told first, and the region last.
    template <typename Run>
    void with_region(const Run& run) const
    {
        const RegionBuffers& r = buffers_.region;
        run(region_grid(*request_.region), r.cells, r.edges, r.filled);
    }

    /// The number of slots that have a point now, and of those that needed another dart.
    std::pair<std::size_t, std::size_t> settle(std::size_t slots, std::uint64_t skipped)
    {
        VariedDartBuffers& b = buffers_;
        make_room(count_ + slots);
        const VariedBatch batch{.skipped = skipped,
                                .cells = word(cells_.cells().size()),
                                .fineness = cells_.fineness(),
                                .first = word(count_),
                                .slots = word(slots),
                                .tries = tries_of(request_),
                                .key_x = request_.stream[0],
                                .key_y = request_.stream[1],
                                .unused = 0};
        with_region([&](const auto&... region) {
            find_.run(slots, group_size_, rule_, batch, b.nodes, b.bounds, b.heads, b.points, b.cells, b.candidates,
                      region...);
            settle_.run(1, 1, rule_, batch, b.nodes, b.bounds, b.heads, b.points, b.cells, b.candidates, b.counters,
                        region...);
        });
        std::array<std::uint32_t, contract::varied_darts::COUNTERS> counters{};
        b.counters.read(counters);
        return {counters[contract::varied_darts::SETTLED], counters[contract::varied_darts::REDRAWN]};
    }

    /// Larger lists lose what they had.
    void make_room(std::size_t points)
    {
        using contract::varied_darts::POINT_WORDS;
        if (buffers_.points.size() >= points * POINT_WORDS) return;
        const std::vector<std::uint32_t> known = buffers_.points.read(0, count_ * POINT_WORDS);
        reserve(device_, buffers_.points, 2 * points * POINT_WORDS);
        buffers_.points.write(known);
    }

    /// Reduces the scale, or refines the cells, after a slot's tries have failed.
    void go_on()
    {
        if (request_.attempts > 0)
            rule_.scale = reduced_scale(rule_.scale, request_.factor);
        else
            refine();
    }

    void refine()
    {
        VariedDartBuffers& b = buffers_;
        cells_.refine([&](std::vector<OpenCell>& cells) {
            reserve(device_, b.looked_at, cells.size());
            b.looked_at.write(cells);
            with_region([&](const auto&... region) {
                look_.run(cells.size(), group_size_, rule_, word(cells.size()), b.nodes, b.bounds, b.heads, b.points,
                          b.looked_at, region...);
            });
            b.looked_at.read(cells);
        });
        reserve(device_, b.cells, cells_.cells().size());
        b.cells.write(cells_.cells());
    }

    VariedDarts result() const
    {
        using contract::varied_darts::POINT_WORDS;
        const std::vector<std::uint32_t> points = buffers_.points.read(0, count_ * POINT_WORDS);
        VariedDarts darts;
        for (std::size_t i = 0; i < count_; ++i)
            darts.points.push_back({points[i * POINT_WORDS], points[i * POINT_WORDS + 1]});
        darts.is_full = cells_.cells().empty();
        darts.scale = rule_.scale * 0x1p-31;
        return darts;
    }

    static std::uint32_t word(std::size_t value) { return static_cast<std::uint32_t>(value); }

    Device& device_;
    VariedDartBuffers& buffers_;
    const VariedDartRequest& request_;
    std::size_t group_size_;
    DistanceRule rule_;
    VariedCells cells_;
    std::size_t count_ = 0; ///< points so far
    Kernel look_, find_, settle_;
};

}

VariedDartThrower::VariedDartThrower(Device device, std::size_t work_group_size)
    : DeviceMethod(std::move(device), work_group_size, std::make_shared<VariedDartBuffers>())
{}

VariedDarts VariedDartThrower::throw_darts(const VariedDartRequest& request)
{
    return ThrowingVaried(device_, *buffers_, request, work_group_size_).run();
}

DeviceMemory VariedDartThrower::memory(const VariedDartRequest& request)
{
    VariedDartBuffers buffers;
    return memory_of(varied_buffers(buffers, request));
}

}
