// Runs kernels/sample_elimination.cl, and the order of points from one elimination after the other.
#include "host/sampling/optimized/sample_elimination.hpp"

#include "base/geometry/lattice.hpp"
#include "base/geometry/relative_radius.hpp"
#include "base/geometry/torus.hpp"
#include "host/device/needed_buffers.hpp"
#include "host/sampling/cells/point_grid.hpp"
#include "host/sampling/optimized/listed_cells.hpp"
#include "kernels/common/optimized/sample_elimination.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

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

/// The number of tiles along each axis that keeps a device busy. More tiles would cost time: points that wait for
/// points of another tile have to be visited again.
std::uint32_t busy_tiles(int dimension, unsigned compute_units, std::size_t group_size)
{
    const auto wanted = static_cast<double>(std::max(1u, compute_units) * groups_per_unit * group_size);
    return 2 * static_cast<std::uint32_t>(std::ceil(std::pow(wanted, 1.0 / dimension)));
}

/// The grid of all cells has at most this many cells for each point. Where points lie in so small a part of the torus
/// that cells as wide as the reach would be more, only the cells that have points are listed.
constexpr double most_cells_a_point = 8;

bool has_listed_cells(std::size_t points, double reach, int dimension)
{
    return std::pow(reach, -dimension) > most_cells_a_point * static_cast<double>(points);
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
    Buffer<std::uint32_t> coordinates, ids, cells, runs, tile_starts, tiles_around; ///< see ListedCells

    NeededBuffers needed(std::size_t points, std::size_t tiles)
    {
        return {{weights, points}, {heavier, points}, {marks, tiles}, {counts, 1}};
    }

    NeededBuffers listed(std::size_t points, std::size_t cell_count, std::size_t tiles, int dimension)
    {
        using namespace contract::sample_elimination;
        const auto axes = static_cast<std::size_t>(dimension);
        return {{coordinates, points * axes},
                {ids, points},
                {cells, points},
                {runs, cell_count * 2 * RUNS(axes)},
                {tile_starts, tiles + 1},
                {tiles_around, tiles * TILES_AROUND(axes)}};
    }
};

/// The elimination of one set.
class EliminationRun
{
public:
    EliminationRun(Device& device, EliminationBuffers& buffers, const PointSet& points, const EliminationReach& reach,
                   std::span<const std::uint32_t> factors, std::size_t work_group_size)
        : device_(device), buffers_(buffers), dimension_(points.dimension), size_(points.size()),
          work_group_size_(work_group_size), tile_group_size_(device.info().type == "CPU" ? 1 : work_group_size)
    {
        elimination_ = {.squared_reach = squared_threshold(std::min(reach.most, 1.0)),
                        .reach = reach.most * 0x1p32,
                        .least = reach.least * 0x1p32,
                        .points = static_cast<std::uint32_t>(points.size()),
                        .grid_size = 0,
                        .tiles = 0,
                        .stride = 0};
        if (has_listed_cells(points.size(), reach.most, points.dimension))
            list(points, reach.most);
        else
            sort(points, reach);
        const KernelProgram program = kernel_program(
            "sample_elimination.cl", {{"DIMENSION", dimension_}, {"FACTORS", !factors.empty()}, {"LISTED", !grid_}});
        weigh_ = device.kernel(program, "weigh_points");
        eliminate_ = device.kernel(program, "eliminate_tiles");
        if (!factors.empty()) write_factors(factors);
    }

    /// The first `count` in the order of removal.
    std::vector<std::uint32_t> first(std::size_t count)
    {
        with_grid([&](const auto&... grid) {
            with_factors([&](const auto&... factors) {
                weigh_.run(size_, work_group_size_, elimination_, grid..., buffers_.weights, buffers_.heavier,
                           factors...);
            });
        });
        buffers_.counts.write({{{0, 0}}});
        std::int64_t least = count < size_ ? first_least(count) : 0;
        while (remove_down_to(least) < count) least /= weight_ratio;
        return heaviest_removed(buffers_.weights.read(0, size_), ids().read(0, size_), count);
    }

private:
    /// Sorts points by all cells of the torus.
    void sort(const PointSet& points, const EliminationReach& reach)
    {
        grid_.emplace(device_, dimension_, size_, elimination_grid(reach, size_, dimension_), work_group_size_);
        PointSet snapped = points; // so that the kernels' coordinates and their cells are of the same place
        for (double& c : snapped.coordinates) c = std::floor(c * 0x1p32) * 0x1p-32;
        grid_->load(snapped);
        grid_->sort();
        elimination_.grid_size = grid_->cells_per_axis();
        elimination_.tiles = std::min(most_tiles(elimination_.grid_size), tiles_along());
        elimination_.stride = grid_->stride();
        reserve(device_, buffers_.needed(size_, lattice_cells(most_tiles(elimination_.grid_size), dimension_)));
    }

    void list(const PointSet& points, double reach)
    {
        const ListedCells listed = listed_cells(points, reach, lattice_cells(tiles_along(), dimension_));
        const std::size_t tiles = listed.tile_starts.size() - 1;
        reserve(device_, buffers_.needed(size_, tiles));
        reserve(device_, buffers_.listed(size_, listed.cells.back() + std::size_t{1}, tiles, dimension_));
        std::vector<std::uint32_t> coordinates;
        coordinates.reserve(points.coordinates.size());
        for (std::size_t k = 0; k < static_cast<std::size_t>(dimension_); ++k)
            for (const std::uint32_t id : listed.ids)
                coordinates.push_back(static_cast<std::uint32_t>(points[id][k] * 0x1p32));
        buffers_.coordinates.write(coordinates);
        buffers_.ids.write(listed.ids);
        buffers_.cells.write(listed.cells);
        buffers_.runs.write(listed.runs);
        buffers_.tile_starts.write(listed.tile_starts);
        buffers_.tiles_around.write(listed.tiles_around);
        colour_starts_ = listed.colour_starts;
        elimination_.stride = elimination_.points;
    }

    std::uint32_t tiles_along() const { return busy_tiles(dimension_, device_.info().compute_units, tile_group_size_); }

    const Buffer<std::uint32_t>& ids() const { return grid_ ? grid_->ids() : buffers_.ids; }

    /// Runs a kernel with coordinates and the cells of the grid.
    template <typename Run>
    void with_grid(const Run& run) const
    {
        if (grid_)
            run(grid_->fixed_point(), grid_->starts());
        else
            run(buffers_.coordinates, buffers_.cells, buffers_.runs);
    }

    void write_factors(std::span<const std::uint32_t> factors)
    {
        std::vector<std::uint32_t> sorted;
        sorted.reserve(size_);
        for (const std::uint32_t id : ids().read(0, size_)) sorted.push_back(factors[id]);
        reserve(device_, buffers_.factors, sorted.size());
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
        std::vector<std::int64_t> weights = buffers_.weights.read(0, size_);
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
        const auto remove = [&](std::size_t tiles, std::uint32_t colour, const auto&... rest) {
            with_grid([&](const auto&... grid) {
                eliminate_.run(tiles, tile_group_size_, elimination_, colour, least, std::uint32_t{is_first}, grid...,
                               ids(), buffers_.weights, buffers_.heavier, buffers_.marks, buffers_.counts, rest...);
            });
        };
        with_factors([&](const auto&... factors) {
            if (grid_) {
                const std::uint32_t colours = elimination_.tiles == 1 ? 1 : 1u << dimension_;
                const std::size_t tiles = lattice_cells(std::max(1u, elimination_.tiles / 2), dimension_);
                for (std::uint32_t colour = 0; colour < colours; ++colour) remove(tiles, colour, factors...);
                return;
            }
            for (std::size_t colour = 0; colour + 1 < colour_starts_.size(); ++colour) {
                elimination_.tiles = colour_starts_[colour + 1];
                const std::uint32_t first = colour_starts_[colour];
                if (first < elimination_.tiles)
                    remove(elimination_.tiles - first, first, buffers_.tile_starts, buffers_.tiles_around, factors...);
            }
        });
    }

    Device& device_;
    EliminationBuffers& buffers_;
    bool has_factors_ = false;
    int dimension_;
    std::size_t size_;
    std::size_t work_group_size_;
    std::size_t tile_group_size_;              ///< tiles take long, and the cores of a processor work on one at a time
    std::optional<PointGrid> grid_;            ///< of all cells; none: cells are listed
    std::vector<std::uint32_t> colour_starts_; ///< of listed tiles
    contract::sample_elimination::Elimination elimination_{};
    Kernel weigh_, eliminate_;
};

std::vector<std::uint32_t> heaviest_removed(const std::vector<std::int64_t>& weights,
                                            const std::vector<std::uint32_t>& ids, std::size_t count)
{
    std::vector<std::pair<std::int64_t, std::uint32_t>> removed; // one's complement: the heaviest is the least
    for (std::size_t i = 0; i < weights.size(); ++i)
        if (weights[i] < 0) removed.emplace_back(weights[i], ids[i]);
    std::ranges::sort(removed);
    std::vector<std::uint32_t> order;
    order.reserve(count);
    for (std::size_t i = 0; i < count; ++i) order.push_back(removed[i].second);
    return order;
}

SampleElimination::SampleElimination(Device device, std::size_t work_group_size)
    : DeviceMethod(std::move(device), work_group_size, std::make_shared<EliminationBuffers>())
{}

std::vector<std::uint32_t> SampleElimination::removal_order(const PointSet& points, const EliminationReach& reach,
                                                            std::size_t count, std::span<const std::uint32_t> factors)
{
    return EliminationRun(device_, *buffers_, points, reach, factors, work_group_size_).first(count);
}

namespace {

/// The memory of one elimination.
DeviceMemory memory_of_one(int dimension, std::size_t points, std::size_t kept, double area, bool has_factors)
{
    const EliminationReach reach = elimination_reach(kept, points, dimension);
    const double side = side_of(area, dimension);
    const std::uint32_t grid_size = elimination_grid({reach.most * side, reach.least * side}, points, dimension);
    EliminationBuffers buffers;
    const bool is_listed = has_listed_cells(points, reach.most * side, dimension);
    NeededBuffers needed = buffers.needed(points, is_listed ? points : lattice_cells(most_tiles(grid_size), dimension));
    if (is_listed)
        for (const NeededBuffer& buffer : buffers.listed(points, points, points, dimension)) needed.push_back(buffer);
    if (has_factors) needed.push_back({buffers.factors, points});
    return is_listed ? memory_of(needed) : PointGrid::memory(dimension, points, grid_size) + memory_of(needed);
}

}

DeviceMemory SampleElimination::memory(int dimension, std::size_t points, std::size_t kept, double area,
                                       bool has_factors)
{
    const DeviceMemory first = memory_of_one(dimension, points, kept, area, has_factors);
    if (kept < 2) return first;
    // Orders halve the set again and again. The first half can be the first to have listed cells, beside the grid.
    const auto lists_cells = [&](std::size_t of, std::size_t left) {
        return has_listed_cells(of, elimination_reach(left, of, dimension).most * side_of(area, dimension), dimension);
    };
    const DeviceMemory halving = memory_of_one(dimension, kept, kept / 2, area, has_factors);
    return lists_cells(points, kept) == lists_cells(kept, kept / 2) ? either(first, halving) : first + halving;
}

}
