// Runs kernels/voronoi_darts.cl: one batch of darts after the other, until there are points enough or no room for more.
#include "host/sampling/classics/voronoi_darts.hpp"

#include "base/geometry/lattice.hpp"
#include "base/geometry/torus.hpp"
#include "host/device/needed_buffers.hpp"
#include "host/sampling/cells/cell_hierarchy.hpp"
#include "host/sampling/classics/open_darts.hpp"
#include "host/sampling/dart_sampler.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <span>
#include <tuple>

namespace poissonlab {

namespace {

using contract::voronoi_darts::Offset;

/// Batches are no smaller: at the end there is room for a few points, and a batch that finds none is taken to prove it.
constexpr std::uint32_t least_batch = 256;

/// Rounds of resolve_darts before the host looks whether all darts are decided.
constexpr int voronoi_rounds = 4;

/// Fewer sites or darts are worked on as they come: what they look into fits in caches.
constexpr std::size_t least_ordered = 4096;

std::uint32_t at_least_some(double darts) { return std::max(least_batch, static_cast<std::uint32_t>(darts)); }

}

contract::voronoi_darts::Torus voronoi_dart_torus(double min_distance)
{
    contract::voronoi_darts::Torus torus{};
    torus.squared_min_distance = squared_threshold(min_distance);
    torus.grid_size = cell_hierarchy(min_distance, 2).size;
    const double cell = 0x1p32 / torus.grid_size;
    torus.squared_cell = cell * cell;
    const auto offsets = offsets_by_gap();
    const auto is_near = [&](const Offset& offset) {
        return offset.squared_gap * torus.squared_cell <= static_cast<double>(torus.squared_min_distance);
    };
    torus.offsets = static_cast<std::uint32_t>(offsets.size());
    torus.near_offsets = static_cast<std::uint32_t>(std::ranges::partition_point(offsets, is_near) - offsets.begin());
    return torus;
}

std::vector<Offset> offsets_by_gap()
{
    using namespace contract::voronoi_darts;
    const auto gap = [](int cells) { return std::max(std::abs(cells) - 1, 0); };
    std::vector<Offset> offsets;
    for (int y = -MAX_GAP - 1; y <= MAX_GAP + 1; ++y)
        for (int x = -MAX_GAP - 1; x <= MAX_GAP + 1; ++x) {
            const int squared_gap = gap(x) * gap(x) + gap(y) * gap(y);
            if (squared_gap <= MAX_GAP * MAX_GAP) offsets.push_back({x, y, squared_gap});
        }
    std::ranges::sort(offsets, {}, [](const Offset& offset) {
        return std::tuple(offset.squared_gap, offset.x * offset.x + offset.y * offset.y, offset.y, offset.x);
    });
    return offsets;
}

std::uint32_t VoronoiDartBatches::darts_anywhere() const
{
    return at_least_some(0.35 * static_cast<double>(lattice_cells(grid_size_, 2)));
}

std::uint32_t VoronoiDartBatches::darts_for(std::size_t sites) { return at_least_some(static_cast<double>(sites)); }

bool VoronoiDartBatches::goes_on(std::uint32_t darts, std::size_t accepted, bool fell_anywhere)
{
    measures_ = !fell_anywhere || accepted * 4 < darts;
    return fell_anywhere || accepted > 0;
}

struct VoronoiDartBuffers
{
    using Words = Buffer<std::uint32_t>;

    Buffer<Offset> offsets;
    Words points, sites;
    Buffer<std::uint64_t> areas, ends;
    Words slots, places, heads;                              ///< a cell of the grid each, of two coordinates
    Words darts, chosen, states, next_states, next, numbers; ///< a dart of the batch each
    Words rows, order;                                       ///< a site or a dart each
    Words counts;                                            ///< a row of the grid each
    Words waiting;

    NeededBuffers needed(const DartThrowingRequest& request)
    {
        const contract::voronoi_darts::Torus torus = voronoi_dart_torus(request.min_distance);
        const std::size_t cells = lattice_cells(torus.grid_size, 2);
        const std::size_t most_points = packing_bound(request.min_distance, 2);
        const VoronoiDartBatches batches(torus);
        const std::size_t most_darts = std::max<std::size_t>(batches.darts_anywhere(), least_batch + most_points);
        return {{offsets, torus.offsets},  {points, 2 * most_points},
                {sites, most_points},      {areas, most_points},
                {ends, most_points},       {slots, cells},
                {places, 2 * cells},       {heads, cells},
                {darts, 2 * most_darts},   {chosen, most_darts},
                {states, most_darts},      {next_states, most_darts},
                {next, most_darts},        {numbers, most_darts},
                {rows, most_darts},        {order, most_darts},
                {counts, torus.grid_size}, {waiting, 1}};
    }
};

namespace {

/// The parts of the torus that are free, before a batch.
struct FreeArea
{
    std::vector<std::uint32_t> sites; ///< that have free area
    std::vector<std::uint64_t> ends;  ///< sums of their areas, each with those before
    bool is_known = true;
};

class VoronoiThrowing
{
public:
    VoronoiThrowing(Device& device, VoronoiDartBuffers& buffers, const DartThrowingRequest& request,
                    std::size_t group_size)
        : buffers_(buffers), request_(request), group_size_(group_size),
          torus_(voronoi_dart_torus(request.min_distance))
    {
        const KernelProgram program = kernel_program("voronoi_darts.cl", {});
        measure_ = device.kernel(program, "measure_cells");
        count_sites_ = device.kernel(program, "count_sites");
        choose_ = device.kernel(program, "choose_sites");
        order_ = device.kernel(program, "order_items");
        throw_ = device.kernel(program, "throw_darts");
        resolve_ = device.kernel(program, "resolve_darts");
        insert_ = device.kernel(program, "insert_darts");
        reserve(device, buffers.needed(request));
        buffers_.offsets.write(offsets_by_gap());
        const std::vector<std::uint32_t> nothing(lattice_cells(torus_.grid_size, 2));
        buffers_.slots.write(nothing);
        buffers_.heads.write(nothing);
    }

    PointSet run()
    {
        const std::size_t target = request_.points.value_or(SIZE_MAX);
        VoronoiDartBatches batches(torus_);
        FreeArea free;
        for (std::uint32_t batch = 0; points_ < target; ++batch) {
            if (batches.measures()) free = measure(free);
            const bool anywhere = !batches.measures() || !free.is_known;
            if (!anywhere && free.sites.empty()) break;
            const std::uint32_t darts =
                anywhere ? batches.darts_anywhere() : VoronoiDartBatches::darts_for(free.sites.size());
            throw_batch(free, darts, batch, anywhere);
            const std::size_t accepted = insert(darts);
            if (!batches.goes_on(darts, accepted, anywhere)) break;
        }
        std::vector<TorusPoint<2>> points(points_);
        buffers_.points.read({points.data()->data(), 2 * points_});
        return to_point_set<2>(std::span<const TorusPoint<2>>(points).first(std::min(points_, target)));
    }

private:
    /// Free areas of the sites that had some, and of new ones: areas only become smaller.
    FreeArea measure(const FreeArea& before)
    {
        VoronoiDartBuffers& b = buffers_;
        std::vector<std::uint32_t> sites = before.sites;
        const std::size_t old = sites.size();
        sites.resize(old + points_ - measured_);
        std::iota(sites.begin() + static_cast<std::ptrdiff_t>(old), sites.end(), static_cast<std::uint32_t>(measured_));
        measured_ = points_;
        b.sites.write(sites);
        b.counts.write(std::vector<std::uint32_t>(torus_.grid_size));
        count_sites_.run(sites.size(), group_size_, torus_.grid_size, b.points, b.sites, u32(sites.size()), b.rows,
                         b.counts);
        const std::uint32_t is_ordered = order(sites.size());
        measure_.run(sites.size(), group_size_, torus_, b.offsets, b.points, b.slots, b.places, b.sites,
                     u32(sites.size()), is_ordered, b.order, b.areas);
        const std::vector<std::uint64_t> areas = b.areas.read(0, sites.size());
        FreeArea free;
        std::uint64_t sum = 0;
        for (std::size_t i = 0; i < sites.size(); ++i) {
            if (areas[i] == 0) continue;
            free.is_known = free.is_known && areas[i] != UNKNOWN_AREA;
            free.sites.push_back(sites[i]);
            free.ends.push_back(sum += areas[i]);
        }
        b.sites.write(free.sites);
        b.ends.write(free.ends);
        return free;
    }

    void throw_batch(const FreeArea& free, std::uint32_t darts, std::uint32_t number, bool anywhere)
    {
        VoronoiDartBuffers& b = buffers_;
        const contract::voronoi_darts::Batch batch{.free_area = anywhere ? 0 : free.ends.back(),
                                                   .sites = anywhere ? 0 : u32(free.sites.size()),
                                                   .darts = darts,
                                                   .number = number,
                                                   .key_x = request_.stream[0],
                                                   .key_y = request_.stream[1],
                                                   .unused = 0};
        b.counts.write(std::vector<std::uint32_t>(torus_.grid_size));
        choose_.run(darts, group_size_, torus_, batch, b.points, b.sites, b.ends, b.chosen, b.rows, b.counts);
        const std::uint32_t is_ordered = order(darts);
        throw_.run(darts, group_size_, torus_, batch, b.offsets, b.points, b.slots, b.places, b.sites, b.ends, b.chosen,
                   is_ordered, b.order, b.darts, b.states, b.next, b.heads);
        std::uint32_t waiting = 1;
        while (waiting != 0) {
            for (int round = 0; round < voronoi_rounds; ++round) {
                if (round + 1 == voronoi_rounds) b.waiting.write({{0u}});
                resolve_.run(darts, group_size_, torus_, darts, b.offsets, is_ordered, b.order, b.darts, b.next,
                             b.heads, b.states, b.next_states, b.waiting);
                std::swap(b.states, b.next_states);
            }
            b.waiting.read({&waiting, 1});
        }
    }

    /// Lists sites or darts by the rows of the grid that they are in, as the last kernel has counted them, unless there
    /// are few. Returns 1 if the list is there, else 0.
    std::uint32_t order(std::size_t items)
    {
        if (items < least_ordered) return 0;
        VoronoiDartBuffers& b = buffers_;
        std::vector<std::uint32_t> next = b.counts.read(0, torus_.grid_size);
        std::exclusive_scan(next.begin(), next.end(), next.begin(), 0u);
        b.counts.write(next);
        order_.run(items, group_size_, u32(items), b.rows, b.counts, b.order);
        return 1;
    }

    /// Makes points of the accepted darts, in their order. Returns how many there are.
    std::size_t insert(std::uint32_t darts)
    {
        std::vector<std::uint32_t> states = buffers_.states.read(0, darts);
        const std::size_t before = points_;
        for (std::uint32_t& state : states) state = state == contract::voronoi_darts::ACCEPTED ? u32(++points_) : 0;
        buffers_.numbers.write(states);
        insert_.run(darts, group_size_, torus_.grid_size, darts, buffers_.darts, buffers_.numbers, buffers_.points,
                    buffers_.slots, buffers_.places, buffers_.heads);
        return points_ - before;
    }

    static std::uint32_t u32(std::size_t value) { return static_cast<std::uint32_t>(value); }

    VoronoiDartBuffers& buffers_;
    const DartThrowingRequest& request_;
    std::size_t group_size_;
    contract::voronoi_darts::Torus torus_;
    Kernel measure_, count_sites_, choose_, order_, throw_, resolve_, insert_;
    std::size_t points_ = 0;
    std::size_t measured_ = 0; ///< points that were there when the free area was measured last
};

}

VoronoiDarts::VoronoiDarts(Device device, std::size_t work_group_size)
    : DeviceMethod(std::move(device), work_group_size, std::make_shared<VoronoiDartBuffers>())
{}

PointSet VoronoiDarts::throw_darts(const DartThrowingRequest& request)
{
    return VoronoiThrowing(device_, *buffers_, request, work_group_size_).run();
}

DeviceMemory VoronoiDarts::memory(const DartThrowingRequest& request, const DeviceInfo&)
{
    return memory_of(VoronoiDartBuffers{}.needed(request));
}

SamplerSpec voronoi_dart_sampler()
{
    return with_open_border(
        dart_sampler({.name = "voronoi-darts",
                      .title = "Voronoi darts",
                      .summary = "dart throwing into what disks leave of Voronoi cells, by area (Jones)",
                      .dimensions = {2},
                      .purpose = Purpose::voronoi_darts,
                      .kernels = {"voronoi_darts.cl"},
                      .memory = VoronoiDarts::memory,
                      .thrower = thrower_by<VoronoiDarts, reference::throw_voronoi_darts>}),
        Purpose::voronoi_darts);
}

}
