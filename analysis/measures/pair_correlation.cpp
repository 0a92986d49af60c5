#include "analysis/measures/pair_correlation.hpp"

#include "analysis/measures/cell_grid.hpp"
#include "analysis/measures/torus_ball.hpp"
#include "analysis/statistics/jackknife.hpp"
#include "base/errors/errors.hpp"
#include "base/geometry/window.hpp"
#include "base/programs/interrupt.hpp"

#include <tbb/combinable.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace poissonlab {

namespace {

/// Ten times the rounding of a difference of two volumes: less is no volume to divide by.
constexpr double least_shell = 1e-14;

using Counts = std::vector<std::uint64_t>;

/// Cells that may hold a pair within reach are at most this many apart. Where a cell would be met twice, one cell is
/// all.
int span_of(double reach, int cells, double side)
{
    const int span = static_cast<int>(reach / side * cells * (1 + 0x1p-40)) + 1; // cells between and one on: rounding
    return 2 * span + 1 > cells ? 0 : span;
}

template <int D>
int cells_for_pairs(std::size_t points, double reach, const PeriodicBox& box)
{
    const int cells = CellGrid<D>::cells_of(points);
    return span_of(reach, cells, box.shortest()) == 0 ? 1 : cells;
}

/// Half of the offsets to neighbouring cells, one of each opposite two.
template <int D>
std::vector<std::array<int, 3>> half_of_offsets(double reach, int cells, const PeriodicBox& box)
{
    std::vector<std::array<int, 3>> offsets;
    std::array<int, 3> span{};
    for (std::size_t k = 0; k < D; ++k) span[k] = span_of(reach, cells, box.sides[k]);
    for (int z = -span[2]; z <= span[2]; ++z) {
        for (int y = -span[1]; y <= span[1]; ++y) {
            for (int x = -span[0]; x <= span[0]; ++x) {
                if (std::array{z, y, x} > std::array{0, 0, 0}) offsets.push_back({x, y, z});
            }
        }
    }
    return offsets;
}

template <int D>
class PairCounter
{
public:
    PairCounter(const PointSet& points, double max_distance, std::size_t bins, const PeriodicBox& box)
        : grid_(points, cells_for_pairs<D>(points.size(), max_distance, box)), sides_(box.sides),
          offsets_(half_of_offsets<D>(max_distance, grid_.cells, box)), bins_(bins),
          scale_(static_cast<double>(bins) / max_distance)
    {
        grid_.stretch(box);
    }

    /// The number of unordered pairs in each bin. Counts are integers: their order does not matter.
    Counts count() const
    {
        tbb::combinable<Counts> parts([&] { return Counts(bins_); });
        const std::size_t n = grid_.position[0].size();
        if (grid_.cells == 1) {
            tbb::parallel_for(std::size_t{0}, n, [&](std::size_t i) { visit(i, i + 1, n, parts.local()); });
        } else {
            tbb::parallel_for(std::size_t{0}, grid_.count(),
                              [&](std::size_t cell) { visit_cell(cell, parts.local()); });
        }
        Counts sum(bins_);
        parts.combine_each([&](const Counts& part) {
            for (std::size_t k = 0; k < bins_; ++k) sum[k] += part[k];
        });
        return sum;
    }

private:
    void visit_cell(std::size_t cell, Counts& counts) const
    {
        for (std::size_t i = grid_.starts[cell]; i < grid_.starts[cell + 1]; ++i) {
            visit(i, i + 1, grid_.starts[cell + 1], counts);
        }
        for (const auto& offset : offsets_) {
            const std::size_t other = neighbour(cell, offset);
            for (std::size_t i = grid_.starts[cell]; i < grid_.starts[cell + 1]; ++i) {
                visit(i, grid_.starts[other], grid_.starts[other + 1], counts);
            }
        }
    }

    std::size_t neighbour(std::size_t cell, const std::array<int, 3>& offset) const
    {
        const auto cells = static_cast<std::size_t>(grid_.cells);
        std::size_t result = 0;
        std::size_t stride = 1;
        for (int k = 0; k < D; ++k, stride *= cells, cell /= cells) {
            const int along = (static_cast<int>(cell % cells) + offset[k] + grid_.cells) % grid_.cells;
            result += static_cast<std::size_t>(along) * stride;
        }
        return result;
    }

    /// Counts the pairs of point i with points begin .. end - 1.
    void visit(std::size_t i, std::size_t begin, std::size_t end, Counts& counts) const
    {
        for (std::size_t j = begin; j < end; ++j) {
            double squared = 0;
            for (int k = 0; k < D; ++k) {
                const double direct = std::abs(grid_.position[k][i] - grid_.position[k][j]);
                const double shortest = std::min(direct, sides_[k] - direct);
                squared += shortest * shortest;
            }
            const double bin = std::sqrt(squared) * scale_;
            if (bin < static_cast<double>(bins_)) ++counts[static_cast<std::size_t>(bin)];
        }
    }

    CellGrid<D> grid_;
    std::array<double, 3> sides_; ///< of the torus
    std::vector<std::array<int, 3>> offsets_;
    std::size_t bins_;
    double scale_; ///< bins a unit length
};

Counts count_pairs(const PointSet& points, double max_distance, std::size_t bins, const PeriodicBox& box)
{
    return points.dimension == 2 ? PairCounter<2>(points, max_distance, bins, box).count()
                                 : PairCounter<3>(points, max_distance, bins, box).count();
}

}

PairCorrelationEstimate::PairCorrelationEstimate(int dimension, double max_distance, std::size_t bins, bool is_window,
                                                 const PeriodicBox& box)
    : dimension_(dimension), max_distance_(max_distance), bins_(bins), is_window_(is_window), box_(box), pairs_(bins)
{
    if (dimension != 2 && dimension != 3) throw InputError("pair correlation: the dimension must be 2 or 3");
    if (bins == 0) throw InputError("pair correlation: the number of bins must be at least 1");
    if (!(max_distance > 0 && max_distance <= largest_toroidal_distance(dimension))) {
        throw InputError("pair correlation: max_distance = " + std::to_string(max_distance) +
                         ": must be above 0 and at most sqrt(dimension) / 2, the largest on the torus");
    }
    if (!box.is_unit() && max_distance > box.shortest() / 2)
        throw InputError("pair correlation: max_distance = " + std::to_string(max_distance) +
                         ": must be at most half of the box's shortest side");
}

void PairCorrelationEstimate::add(const PointSet& points)
{
    if (points.dimension != dimension_) throw InputError("pair correlation: sets differ in their dimension");
    if (points.size() < 2) throw InputError("pair correlation: a set must have at least two points");
    add_counts(count(points), points.size());
}

/// Unordered pairs in each bin.
std::vector<std::uint64_t> PairCorrelationEstimate::count(const PointSet& points) const
{
    if (points.size() < 2) return Counts(bins_);
    return is_window_ ? count_pairs(halved(points), max_distance_ / 2, bins_, box_)
                      : count_pairs(points, max_distance_, bins_, box_);
}

/// Each pair is in a strip, or of a strip and the layer above it that is as high as pairs are apart.
void PairCorrelationEstimate::add(const PointStrips& points)
{
    if (points.dimension() != dimension_) throw InputError("pair correlation: sets differ in their dimension");
    if (points.size() < 2) throw InputError("pair correlation: a set must have at least two points");
    const double reach = max_distance_ * (1 + 0x1p-20);
    if (reach * static_cast<double>(points.count()) > 1) { // of a small set, whose pairs may be of any two strips
        PointSet all = points.strip(0);
        points.append_around(0, 1, 1, false, all);
        return add(all);
    }
    Counts sum(bins_);
    for (std::size_t strip = 0; strip < points.count(); ++strip) {
        stop_if_interrupted();
        PointSet above{dimension_, {}};
        points.append_around(strip, 0, reach, is_window_, above);
        const Counts counted_twice = count(above);
        PointSet both = points.strip(strip);
        both.coordinates.insert(both.coordinates.end(), above.coordinates.begin(), above.coordinates.end());
        const Counts counts = count(both);
        for (std::size_t k = 0; k < bins_; ++k) sum[k] += counts[k] - counted_twice[k];
    }
    add_counts(sum, points.size());
}

void PairCorrelationEstimate::add_counts(const Counts& counts, std::uint64_t points)
{
    const auto n = static_cast<double>(points);
    const double width = max_distance_ / static_cast<double>(bins_);

    std::vector<double> values(bins_);
    double inner = 0;
    for (std::size_t k = 0; k < bins_; ++k) {
        const double radius = static_cast<double>(k + 1) * width;
        const double outer =
            is_window_ ? window_pair_volume(radius, dimension_) : torus_ball_volume(radius, dimension_, box_);
        const auto pairs = static_cast<double>(counts[k]);
        const double shell = outer - inner;
        values[k] = shell > least_shell ? 2 * pairs / (n * (n - 1) * shell) : 0;
        pairs_[k] += pairs;
        inner = outer;
    }
    values_.push_back(std::move(values));
}

void PairCorrelationEstimate::append(const PairCorrelationEstimate& other)
{
    values_.insert(values_.end(), other.values_.begin(), other.values_.end());
    for (std::size_t k = 0; k < bins_; ++k) pairs_[k] += other.pairs_[k];
}

std::vector<PairCorrelationBin> PairCorrelationEstimate::mean(const std::vector<std::size_t>& groups) const
{
    if (values_.empty()) return {};
    const auto sets = static_cast<double>(values_.size());
    std::vector<PairCorrelationBin> result(bins_);
    for (std::size_t k = 0; k < bins_; ++k) {
        PairCorrelationBin& bin = result[k];
        bin.distance = (static_cast<double>(k) + 0.5) * max_distance_ / static_cast<double>(bins_);
        bin.pairs = pairs_[k] / sets;
        for (const auto& values : values_) bin.value += values[k] / sets;
    }
    const std::vector<double> errors = errors_of_mean(values_, groups);
    for (std::size_t k = 0; k < errors.size(); ++k) result[k].standard_error = errors[k];
    return result;
}

}
