// Runs kernels/sample_elimination.cl, and the order of points from one elimination after the other.
#include "host/sampling/optimized/sample_elimination.hpp"

#include "base/geometry/lattice.hpp"
#include "base/geometry/relative_radius.hpp"
#include "base/geometry/torus.hpp"
#include "host/device/needed_buffers.hpp"
#include "host/sampling/cells/point_grid.hpp"
#include "kernels/common/optimized/sample_elimination.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

namespace poissonlab {

namespace {

/// Rounds that are enqueued before the host looks whether points are left.
constexpr int elimination_rounds = 4;

/// Work-groups for each compute unit of a device, so that none waits long for the last one.
constexpr std::size_t groups_per_unit = 16;

/// Each time that all points of a weight or more are gone, and more have to go, half of it is the next.
constexpr std::int64_t weight_ratio = 2;

/// Cells are as wide as the reach, so that all within it lie in the cells around; more than two a point are no use.
std::uint32_t elimination_grid(const EliminationReach& reach, std::size_t points, int dimension)
{
    const double dense = std::pow(2 * static_cast<double>(points), 1.0 / dimension);
    return std::max(1u, static_cast<std::uint32_t>(std::min(std::floor(1 / reach.most), dense)));
}

/// The most tiles along each axis: an even number, so that they are coloured like a chessboard, or one.
std::uint32_t most_tiles(std::uint32_t grid_size) { return std::max(1u, grid_size / 4 * 2); }

/// Not more tiles than keep a device busy: points that wait for those of another tile have to be visited again.
std::uint32_t tiles_for(std::uint32_t grid_size, int dimension, unsigned compute_units, std::size_t group_size)
{
    const auto wanted = static_cast<double>(std::max(1u, compute_units) * groups_per_unit * group_size);
    const auto of_colour = static_cast<std::uint32_t>(std::ceil(std::pow(wanted, 1.0 / dimension)));
    return std::min(most_tiles(grid_size), 2 * of_colour);
}

/// The numbers of points that are not among the removed ones, ascending.
std::vector<std::uint32_t> without(std::span<const std::uint32_t> removed, std::size_t points)
{
    std::vector<bool> is_removed(points);
    for (const std::uint32_t number : removed) is_removed[number] = true;
    std::vector<std::uint32_t> left;
    left.reserve(points - removed.size());
    for (std::uint32_t i = 0; i < points; ++i)
        if (!is_removed[i]) left.push_back(i);
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

/// Returns the side of a square or cube of that area or volume.
double side_of(double area, int dimension) { return dimension == 2 ? std::sqrt(area) : std::cbrt(area); }

}

EliminationReach elimination_reach(std::size_t kept, std::size_t points, int dimension)
{
    const double most = max_min_distance(kept, dimension);
    const double share = static_cast<double>(kept) / static_cast<double>(points);
    return {most, most * (1 - share * std::sqrt(share)) * 0.65};
}

PointSet eliminate(const PointSet& points, std::size_t kept, const RemovalOrder& removal_order, double area)
{
    const double side = side_of(area, points.dimension);
    std::vector<std::uint32_t> numbers(points.size());
    std::iota(numbers.begin(), numbers.end(), 0u);
    PointSet left = points;
    if (kept < points.size()) {
        const EliminationReach reach = elimination_reach(kept, points.size(), points.dimension);
        const auto removed = removal_order(points, {reach.most * side, reach.least * side}, points.size() - kept);
        numbers = without(removed, points.size());
        left = chosen_points(points, numbers);
    }
    std::vector<std::uint32_t> ordered = numbers;
    while (numbers.size() >= 3) {
        const std::size_t half = numbers.size() / 2;
        const auto removed =
            removal_order(left, {max_min_distance(half, points.dimension) * side, 0}, numbers.size() - half);
        for (std::size_t i = 0; i < removed.size(); ++i) ordered[numbers.size() - 1 - i] = numbers[removed[i]];
        std::vector<std::uint32_t> rest = without(removed, numbers.size());
        left = chosen_points(left, rest);
        for (std::uint32_t& number : rest) number = numbers[number];
        numbers = std::move(rest);
        std::ranges::copy(numbers, ordered.begin());
    }
    return chosen_points(points, ordered);
}

struct EliminationBuffers
{
    Buffer<std::int64_t> weights; ///< of removed points: one's complement of what they were
    Buffer<std::uint32_t> heavier;
    Buffer<std::uint32_t> factors; ///< in sorted order, if there are any
    Buffer<std::uint8_t> marks;    ///< of tiles around which something has changed
    Buffer<contract::sample_elimination::EliminationCounts> counts;

    NeededBuffers needed(std::size_t points, int dimension, std::uint32_t grid_size)
    {
        return {{weights, points},
                {heavier, points},
                {marks, lattice_cells(most_tiles(grid_size), dimension)},
                {counts, 1}};
    }
};

/// The elimination of one set.
class EliminationRun
{
public:
    EliminationRun(Device& device, EliminationBuffers& buffers, const PointSet& points, const EliminationReach& reach,
                   std::span<const std::uint32_t> factors, std::size_t work_group_size)
        : buffers_(buffers), dimension_(points.dimension), work_group_size_(work_group_size),
          tile_group_size_(device.info().type == "CPU" ? 1 : work_group_size),
          grid_(device, points.dimension, points.size(), elimination_grid(reach, points.size(), points.dimension),
                work_group_size)
    {
        PointSet snapped = points; // so that the kernels' coordinates and their cells are of the same place
        for (double& c : snapped.coordinates) c = std::floor(c * 0x1p32) * 0x1p-32;
        grid_.load(snapped);
        grid_.sort();
        elimination_ = {
            .squared_reach = squared_threshold(std::min(reach.most, 1.0)),
            .reach = reach.most * 0x1p32,
            .least = reach.least * 0x1p32,
            .points = static_cast<std::uint32_t>(points.size()),
            .grid_size = grid_.cells_per_axis(),
            .tiles = tiles_for(grid_.cells_per_axis(), dimension_, device.info().compute_units, tile_group_size_),
            .stride = grid_.stride()};
        const KernelProgram program =
            kernel_program("sample_elimination.cl", {{"DIMENSION", dimension_}, {"FACTORS", !factors.empty()}});
        weigh_ = device.kernel(program, "weigh_points");
        eliminate_ = device.kernel(program, "eliminate_tiles");
        reserve(device, buffers_.needed(points.size(), dimension_, elimination_.grid_size));
        if (!factors.empty()) write_factors(device, factors);
    }

    /// The first `count` in the order of removal.
    std::vector<std::uint32_t> first(std::size_t count)
    {
        with_factors([&](const auto&... factors) {
            weigh_.run(grid_.size(), work_group_size_, elimination_, grid_.fixed_point(), grid_.starts(),
                       buffers_.weights, buffers_.heavier, factors...);
        });
        buffers_.counts.write({{{0, 0}}});
        std::int64_t least = count < grid_.size() ? first_least(count) : 0;
        while (remove_down_to(least) < count) least /= weight_ratio;
        return heaviest_removed(count);
    }

private:
    void write_factors(Device& device, std::span<const std::uint32_t> factors)
    {
        const std::vector<std::uint32_t> ids = grid_.ids().read(0, grid_.size());
        std::vector<std::uint32_t> sorted;
        sorted.reserve(ids.size());
        for (const std::uint32_t id : ids) sorted.push_back(factors[id]);
        reserve(device, buffers_.factors, sorted.size());
        buffers_.factors.write(sorted);
        has_factors_ = true;
    }

    /// Runs a kernel with the factors, if there are any.
    template <typename Run>
    void with_factors(const Run& run) const
    {
        if (has_factors_)
            run(buffers_.factors);
        else
            run();
    }

    /// Points that are removed while the heaviest ones go have at most the weight that so many points have at first.
    std::int64_t first_least(std::size_t count) const
    {
        std::vector<std::int64_t> weights = buffers_.weights.read(0, grid_.size());
        const auto least = weights.begin() + static_cast<std::ptrdiff_t>(count);
        std::ranges::nth_element(weights, least, std::greater{});
        return *least;
    }

    /// Removes points until all are lighter; the number of those removed so far.
    std::size_t remove_down_to(std::int64_t least)
    {
        contract::sample_elimination::EliminationCounts counts{};
        for (bool is_first = true; is_first || counts.of_round > 0; is_first = false) {
            for (int round = 0; round < elimination_rounds; ++round) {
                if (round + 1 == elimination_rounds) {
                    buffers_.counts.read({&counts, 1});
                    counts.of_round = 0;
                    buffers_.counts.write({&counts, 1});
                }
                remove_round(least, is_first && round == 0);
            }
            buffers_.counts.read({&counts, 1});
        }
        return counts.removed;
    }

    void remove_round(std::int64_t least, bool is_first)
    {
        const std::uint32_t colours = elimination_.tiles == 1 ? 1 : 1u << dimension_;
        const std::size_t tiles = lattice_cells(std::max(1u, elimination_.tiles / 2), dimension_);
        for (std::uint32_t colour = 0; colour < colours; ++colour)
            with_factors([&](const auto&... factors) {
                eliminate_.run(tiles, tile_group_size_, elimination_, colour, least, std::uint32_t{is_first},
                               grid_.fixed_point(), grid_.starts(), grid_.ids(), buffers_.weights, buffers_.heavier,
                               buffers_.marks, buffers_.counts, factors...);
            });
    }

    std::vector<std::uint32_t> heaviest_removed(std::size_t count) const
    {
        const std::vector<std::int64_t> weights = buffers_.weights.read(0, grid_.size());
        const std::vector<std::uint32_t> ids = grid_.ids().read(0, grid_.size());
        using Removed = std::pair<std::int64_t, std::uint32_t>; // one's complement: the heaviest is the least
        std::vector<Removed> removed;
        for (std::size_t i = 0; i < weights.size(); ++i)
            if (weights[i] < 0) removed.emplace_back(weights[i], ids[i]);
        std::ranges::sort(removed);
        std::vector<std::uint32_t> order;
        order.reserve(count);
        for (std::size_t i = 0; i < count; ++i) order.push_back(removed[i].second);
        return order;
    }

    EliminationBuffers& buffers_;
    bool has_factors_ = false;
    int dimension_;
    std::size_t work_group_size_;
    std::size_t tile_group_size_; ///< tiles take long, and the cores of a processor work on one at a time
    PointGrid grid_;
    contract::sample_elimination::Elimination elimination_{};
    Kernel weigh_, eliminate_;
};

SampleElimination::SampleElimination(Device device, std::size_t work_group_size)
    : DeviceMethod(std::move(device), work_group_size, std::make_shared<EliminationBuffers>())
{}

std::vector<std::uint32_t> SampleElimination::removal_order(const PointSet& points, const EliminationReach& reach,
                                                            std::size_t count, std::span<const std::uint32_t> factors)
{
    return EliminationRun(device_, *buffers_, points, reach, factors, work_group_size_).first(count);
}

DeviceMemory SampleElimination::memory(int dimension, std::size_t points, std::size_t kept, double area,
                                       bool has_factors)
{
    const EliminationReach reach = elimination_reach(kept, points, dimension);
    const double side = side_of(area, dimension);
    const std::uint32_t grid_size = elimination_grid({reach.most * side, reach.least * side}, points, dimension);
    EliminationBuffers buffers;
    NeededBuffers needed = buffers.needed(points, dimension, grid_size);
    if (has_factors) needed.push_back({buffers.factors, points});
    return PointGrid::memory(dimension, points, grid_size) + memory_of(needed);
}

}
