// Runs kernels/sample_elimination.cl, and the order of points from one elimination after the other.
#include "host/sampling/optimized/sample_elimination.hpp"

#include "base/geometry/relative_radius.hpp"
#include "base/geometry/torus.hpp"
#include "host/device/needed_buffers.hpp"
#include "host/sampling/cells/point_grid.hpp"
#include "kernels/common/sample_elimination.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

namespace poissonlab {

namespace {

/// Rounds that are enqueued before the host looks whether points are left.
constexpr int elimination_rounds = 8;

/// Cells are as wide as the reach, so that all within it lie in the cells around; more than two a point are no use.
std::uint32_t elimination_grid(const EliminationReach& reach, std::size_t points, int dimension)
{
    const double dense = std::pow(2 * static_cast<double>(points), 1.0 / dimension);
    return std::max(1u, static_cast<std::uint32_t>(std::min(std::floor(1 / reach.most), dense)));
}

/// The numbers of points that are left when the first ones of an order of removal are gone, ascending.
std::vector<std::uint32_t> without_first(std::span<const std::uint32_t> order, std::size_t removed)
{
    std::vector<std::uint32_t> left(order.begin() + static_cast<std::ptrdiff_t>(removed), order.end());
    std::ranges::sort(left);
    return left;
}

PointSet chosen_points(const PointSet& points, std::span<const std::uint32_t> numbers)
{
    PointSet chosen{points.dimension, {}};
    chosen.coordinates.reserve(numbers.size() * static_cast<std::size_t>(points.dimension));
    for (const std::uint32_t number : numbers)
        chosen.coordinates.insert(chosen.coordinates.end(), points[number].begin(), points[number].end());
    return chosen;
}

}

EliminationReach elimination_reach(std::size_t kept, std::size_t points, int dimension)
{
    const double most = max_min_distance(kept, dimension);
    const double share = static_cast<double>(kept) / static_cast<double>(points);
    return {most, most * (1 - share * std::sqrt(share)) * 0.65};
}

PointSet eliminate(const PointSet& points, std::size_t kept, const RemovalOrder& removal_order)
{
    std::vector<std::uint32_t> numbers(points.size());
    std::iota(numbers.begin(), numbers.end(), 0u);
    PointSet left = points;
    if (kept < points.size()) {
        const auto order = removal_order(points, elimination_reach(kept, points.size(), points.dimension));
        numbers = without_first(order, points.size() - kept);
        left = chosen_points(points, numbers);
    }
    std::vector<std::uint32_t> ordered = numbers;
    while (numbers.size() >= 3) {
        const std::size_t half = numbers.size() / 2;
        const auto order = removal_order(left, {max_min_distance(half, points.dimension), 0});
        for (std::size_t i = 0; half + i < numbers.size(); ++i) ordered[numbers.size() - 1 - i] = numbers[order[i]];
        std::vector<std::uint32_t> rest = without_first(order, numbers.size() - half);
        left = chosen_points(left, rest);
        for (std::uint32_t& number : rest) number = numbers[number];
        numbers = std::move(rest);
        std::ranges::copy(numbers, ordered.begin());
    }
    return chosen_points(points, ordered);
}

struct EliminationBuffers
{
    Buffer<std::uint64_t> weights;
    Buffer<std::uint8_t> is_removed, is_heaviest;
    Buffer<std::uint32_t> is_left;

    NeededBuffers needed(std::size_t points)
    {
        return {{weights, points}, {is_removed, points}, {is_heaviest, points}, {is_left, 1}};
    }
};

SampleElimination::SampleElimination(Device device, std::size_t work_group_size)
    : DeviceMethod(std::move(device), work_group_size, std::make_shared<EliminationBuffers>())
{}

std::vector<std::uint32_t> SampleElimination::removal_order(const PointSet& points, const EliminationReach& reach)
{
    const std::size_t n = points.size();
    PointSet snapped = points; // so that the kernels' coordinates and their cells are of the same place
    for (double& c : snapped.coordinates) c = std::floor(c * 0x1p32) * 0x1p-32;
    PointGrid grid(device_, points.dimension, n, elimination_grid(reach, n, points.dimension), work_group_size_);
    grid.load(snapped);
    grid.sort();

    const contract::sample_elimination::Elimination elimination{.squared_reach =
                                                                    squared_threshold(std::min(reach.most, 1.0)),
                                                                .reach = reach.most * 0x1p32,
                                                                .least = reach.least * 0x1p32,
                                                                .points = static_cast<std::uint32_t>(n),
                                                                .grid_size = grid.cells_per_axis(),
                                                                .stride = grid.stride(),
                                                                .unused = 0};
    const KernelProgram program = kernel_program("sample_elimination.cl", {{"DIMENSION", points.dimension}});
    Kernel weigh = device_.kernel(program, "weigh_points");
    Kernel find = device_.kernel(program, "find_heaviest");
    Kernel remove = device_.kernel(program, "remove_points");
    EliminationBuffers& b = *buffers_;
    reserve(device_, b.needed(n));
    weigh.run(n, work_group_size_, elimination, grid.fixed_point(), grid.starts(), b.weights, b.is_removed,
              b.is_heaviest);
    for (std::uint32_t is_left = 1; is_left != 0;) {
        for (int round = 0; round < elimination_rounds; ++round) {
            if (round + 1 == elimination_rounds) b.is_left.write({{0u}});
            find.run(n, work_group_size_, elimination, grid.fixed_point(), grid.starts(), grid.ids(), b.weights,
                     b.is_removed, b.is_heaviest);
            remove.run(n, work_group_size_, elimination, grid.fixed_point(), grid.starts(), b.weights, b.is_removed,
                       b.is_heaviest, b.is_left);
        }
        b.is_left.read({&is_left, 1});
    }

    const std::vector<std::uint64_t> weights = b.weights.read(0, n);
    const std::vector<std::uint32_t> ids = grid.ids().read(0, n);
    std::vector<std::uint64_t> weight_of(n);
    for (std::size_t i = 0; i < n; ++i) weight_of[ids[i]] = weights[i];
    std::vector<std::uint32_t> order(n);
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::stable_sort(order, std::greater{}, [&](std::uint32_t i) { return weight_of[i]; });
    return order;
}

DeviceMemory SampleElimination::memory(int dimension, std::size_t points, std::size_t kept)
{
    const EliminationReach reach = elimination_reach(kept, points, dimension);
    return PointGrid::memory(dimension, points, elimination_grid(reach, points, dimension)) +
           memory_of(EliminationBuffers{}.needed(points));
}

}
