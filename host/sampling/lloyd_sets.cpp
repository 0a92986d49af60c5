// Runs kernels/lloyd_sets.cl.
#include "host/sampling/lloyd_sets.hpp"

#include "base/programs/interrupt.hpp"
#include "host/device/needed_buffers.hpp"
#include "host/sampling/cells/voronoi_cells.hpp"
#include "host/sampling/lloyd_iteration.hpp"
#include "kernels/common/lloyd_sets.h"
#include "kernels/common/vectors.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace poissonlab {
namespace {

using contract::lloyd_sets::Sets;

auto grid_of(std::size_t points) { return whole_grid(VoronoiKernels::cells_per_axis(2, points), 2); }

/// Each buffer has its values of all sets, one set after the other.
struct SetBuffers
{
    Buffer<double> positions, sorted, areas, displacements, energies, squared_near, sums, smallest;
    Buffer<std::uint32_t> ids, sorted_ids, counts, cells, starts, order, fixed_point, slow;

    NeededBuffers needed(std::size_t sets, std::size_t points)
    {
        const std::size_t all = sets * points;
        const std::size_t grid_cells = grid_of(points).cells;
        const std::size_t measures = sets * iterations_of_batch(all, 2);
        return {{positions, 2 * all},
                {sorted, 2 * all},
                {areas, all},
                {displacements, 2 * all},
                {energies, all},
                {squared_near, all},
                {sums, measures},
                {smallest, measures},
                {ids, all},
                {sorted_ids, all},
                {counts, sets * grid_cells},
                {cells, all},
                {starts, sets * (grid_cells + 1)},
                {order, all},
                {fixed_point, 2 * sets * (points + contract::vectors::PADDING)},
                {slow, sets * (points + 1)}};
    }
};

void load(SetBuffers& buffers, const std::vector<PointSet>& sets)
{
    std::vector<double> coordinates;
    std::vector<std::uint32_t> ids(buffers.ids.size());
    for (std::size_t k = 0; k < sets.size(); ++k) {
        coordinates.insert(coordinates.end(), sets[k].coordinates.begin(), sets[k].coordinates.end());
        const auto own = ids.begin() + static_cast<std::ptrdiff_t>(k * sets[k].size());
        std::iota(own, own + static_cast<std::ptrdiff_t>(sets[k].size()), 0u);
    }
    buffers.positions.write(coordinates);
    buffers.ids.write(ids);
    buffers.counts.write(std::vector<std::uint32_t>(buffers.counts.size()));
    buffers.fixed_point.write(std::vector<std::uint32_t>(buffers.fixed_point.size()));
}

PointSet set_of(const std::vector<double>& positions, const std::vector<std::uint32_t>& ids, std::size_t set,
                std::size_t points)
{
    PointSet result{2, std::vector<double>(2 * points)};
    for (std::size_t i = set * points; i < (set + 1) * points; ++i)
        std::copy_n(&positions[2 * i], 2, &result.coordinates[2 * std::size_t{ids[i]}]);
    return result;
}

}

LloydSets::LloydSets(Device device) : device_(std::move(device)) {}

std::size_t LloydSets::most_sets(std::size_t points)
{
    constexpr std::size_t most = 32, most_points = 4096, points_of_all = 16'384;
    return points <= most_points ? std::min(most, points_of_all / points) : 0;
}

bool LloydSets::are_faster(const DeviceInfo& device, std::size_t sets, std::size_t points)
{
    if (device.type != "CPU" || sets > most_sets(points)) return false;
    constexpr std::size_t points_of_launches = 256; // take as long as the launches of an iteration
    const std::size_t threads = device.compute_units;
    return (sets + threads - 1) / threads * points <= sets * (points / threads + points_of_launches);
}

std::vector<LloydResult> LloydSets::relax(const std::vector<PointSet>& sets, std::size_t iterations)
{
    const std::size_t count = sets.size();
    const std::size_t points = sets.at(0).size();
    SetBuffers b;
    reserve(device_, b.needed(count, points));
    load(b, sets);
    const auto grid = grid_of(points);
    const float width = std::nextafter(static_cast<float>(0x1p32 / grid.grid_size), 0.0f);
    Kernel relax = device_.kernel(kernel_program("lloyd_sets.cl", {doubles_of(device_)}), "relax_sets");

    std::vector<IterationCourse> courses(count, IterationCourse(points, 2, {.iterations = iterations}));
    for (std::size_t made = 0; made <= iterations;) {
        stop_if_interrupted();
        const std::size_t measures = next_batch(count * points, 2, made, iterations);
        made += measures;
        const std::size_t moves = made <= iterations ? measures : measures - 1;
        const auto words = [](std::size_t value) { return static_cast<std::uint32_t>(value); };
        relax.run(count, 1, Sets{words(count), words(points), words(measures), words(moves)}, grid, width, b.positions,
                  b.ids, b.sorted, b.sorted_ids, b.counts, b.cells, b.starts, b.order, b.fixed_point, b.areas,
                  b.displacements, b.energies, b.squared_near, b.slow, b.sums, b.smallest);
        const std::vector<double> sums = b.sums.read(0, count * measures);
        const std::vector<double> smallest = b.smallest.read(0, count * measures);
        for (std::size_t i = 0; i < count * measures; ++i)
            courses[i / measures].add({lloyd_energy(sums[i], points, 2), smallest[i]});
    }

    const std::vector<double> positions = b.positions.read(0, 2 * count * points);
    const std::vector<std::uint32_t> ids = b.ids.read(0, count * points);
    std::vector<LloydResult> results;
    for (std::size_t k = 0; k < count; ++k)
        results.push_back({set_of(positions, ids, k, points), std::move(courses[k].iterations()), courses[k].kept()});
    return results;
}

DeviceMemory LloydSets::memory(std::size_t sets, std::size_t points)
{
    return memory_of(SetBuffers{}.needed(sets, points));
}

}
