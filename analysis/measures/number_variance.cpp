#include "analysis/measures/number_variance.hpp"

#include "analysis/measures/cell_grid.hpp"
#include "analysis/measures/torus_ball.hpp"
#include "base/errors/errors.hpp"
#include "base/programs/interrupt.hpp"
#include "base/random/random.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace poissonlab {
namespace {

constexpr int number_of_radii = 24;
constexpr double least_spacings = 0.5, largest_radius = 0.25;
constexpr std::size_t most_centres = 10'000, centres_per_point = 4;

/// Counts the points in balls on the torus.
template <int D>
class BallCounter
{
public:
    explicit BallCounter(const PointSet& points) : grid_(points, CellGrid<D>::cells_of(points.size())) {}

    /// Radii of at most a quarter meet no cell twice.
    std::int64_t count(const std::array<double, D>& centre, double radius) const
    {
        std::int64_t points = 0;
        Ball ball{centre, radius * radius, {}};
        const int m = grid_.cells;
        const auto low = [&](int k) { return static_cast<int>(std::floor((centre[k] - radius) * m)); };
        const auto high = [&](int k) { return static_cast<int>(std::floor((centre[k] + radius) * m)); };
        if constexpr (D == 2) {
            for (int y = low(1); y <= high(1); ++y) points += count_row(ball, {0, y});
        } else {
            for (int z = low(2); z <= high(2); ++z)
                for (int y = low(1); y <= high(1); ++y) points += count_row(ball, {0, y, z});
        }
        return points;
    }

private:
    struct Ball
    {
        std::array<double, D> centre;
        double squared_radius;
        std::array<int, D> turns; ///< of the torus that lie between a row of cells and its image near the ball
    };

    /// The points of a row of cells along x, which may lie outside of the unit square (cube).
    std::int64_t count_row(Ball& ball, const std::array<int, D>& row) const
    {
        const int m = grid_.cells;
        double nearest = 0, farthest = 0; // squared distances of the row's points across it
        std::size_t line = 0;
        for (int k = D - 1; k > 0; --k) {
            const double below = static_cast<double>(row[k]) / m - ball.centre[k];
            const double above = static_cast<double>(row[k] + 1) / m - ball.centre[k];
            const double near = std::max({0.0, below, -above}), far = std::max(-below, above);
            nearest += near * near, farthest += far * far;
            ball.turns[k] = turns_of(row[k]);
            line = line * static_cast<std::size_t>(m) + static_cast<std::size_t>(row[k] - ball.turns[k] * m);
        }
        if (nearest >= ball.squared_radius || is_empty(line)) return 0;
        const double outer = std::sqrt(ball.squared_radius - nearest);
        const int begin = static_cast<int>(std::floor((ball.centre[0] - outer) * m));
        const int end = static_cast<int>(std::floor((ball.centre[0] + outer) * m)) + 1;
        int inner_begin = end, inner_end = end;
        if (farthest < ball.squared_radius) {
            const double inner = std::sqrt(ball.squared_radius - farthest);
            inner_begin = std::min(end, static_cast<int>(std::ceil((ball.centre[0] - inner) * m)));
            inner_end = std::max(inner_begin, static_cast<int>(std::floor((ball.centre[0] + inner) * m)));
        }
        std::int64_t points = all_of(line, inner_begin, inner_end);
        for (int x = begin; x < inner_begin; ++x) points += inside(ball, line, x);
        for (int x = inner_end; x < end; ++x) points += inside(ball, line, x);
        return points;
    }

    /// True for a row of cells without points, as most are where they lie in a strip.
    bool is_empty(std::size_t line) const
    {
        const std::size_t first = line * static_cast<std::size_t>(grid_.cells);
        return grid_.starts[first] == grid_.starts[first + static_cast<std::size_t>(grid_.cells)];
    }

    int turns_of(int cell) const { return cell < 0 ? -1 : cell / grid_.cells; }

    /// The points of cells begin .. end - 1 of a row.
    std::int64_t all_of(std::size_t line, int begin, int end) const
    {
        std::int64_t points = 0;
        for (int from = begin; from < end;) {
            const int turn = turns_of(from) * grid_.cells;
            const int to = std::min(end, turn + grid_.cells);
            const std::size_t first = line * static_cast<std::size_t>(grid_.cells);
            points += static_cast<std::int64_t>(grid_.starts[first + static_cast<std::size_t>(to - turn)] -
                                                grid_.starts[first + static_cast<std::size_t>(from - turn)]);
            from = to;
        }
        return points;
    }

    /// The points of a cell that are inside of the ball.
    std::int64_t inside(Ball& ball, std::size_t line, int x) const
    {
        ball.turns[0] = turns_of(x);
        const std::size_t cell =
            line * static_cast<std::size_t>(grid_.cells) + static_cast<std::size_t>(x - ball.turns[0] * grid_.cells);
        std::int64_t points = 0;
        for (std::size_t i = grid_.starts[cell]; i < grid_.starts[cell + 1]; ++i) {
            double squared = 0;
            for (int k = 0; k < D; ++k) {
                const double along = grid_.position[k][i] + ball.turns[k] - ball.centre[k];
                squared += along * along;
            }
            if (squared < ball.squared_radius) ++points;
        }
        return points;
    }

    CellGrid<D> grid_;
};

/// Centre number i; in windows, at least a radius from the border.
template <int D>
std::array<double, D> centre_of(std::uint32_t i, double margin)
{
    static const StreamKey key = stream_key(0, Purpose::variance_windows, 0);
    const auto words = philox({i, 0, 0, 0}, key);
    std::array<double, D> centre;
    for (int k = 0; k < D; ++k)
        centre[k] = margin + (1 - 2 * margin) * static_cast<double>(words[static_cast<std::size_t>(k)]) * 0x1p-32;
    return centre;
}

/// Adds the numbers of points in balls of one radius.
template <int D>
void add_points_in_balls(const BallCounter<D>& counter, double radius, double margin, std::vector<std::int64_t>& counts)
{
    tbb::parallel_for(std::size_t{0}, counts.size(), [&](std::size_t i) {
        counts[i] += counter.count(centre_of<D>(static_cast<std::uint32_t>(i), margin), radius);
    });
}

struct Moments
{
    double mean = 0, variance = 0;
};

Moments moments_of(const std::vector<std::int64_t>& counts, double expected, bool is_window)
{
    const auto n = static_cast<double>(counts.size());
    double sum = 0, squares = 0; // of deviations: small numbers
    for (const std::int64_t count : counts) {
        const double deviation = static_cast<double>(count) - expected;
        sum += deviation, squares += deviation * deviation;
    }
    if (!is_window) return {expected, squares / n};
    return {expected + sum / n, (squares - sum * sum / n) / (n - 1)};
}

}

NumberVarianceEstimate::NumberVarianceEstimate(int dimension, std::size_t points, bool is_window)
    : dimension_(dimension), is_window_(is_window), centres_(std::min(most_centres, centres_per_point * points))
{
    if (dimension != 2 && dimension != 3) throw InputError("number variance: the dimension must be 2 or 3");
    if (points < least_points(dimension)) return;
    const double least = least_spacings * std::pow(static_cast<double>(points), -1.0 / dimension);
    for (int i = 0; i < number_of_radii; ++i)
        radii_.push_back(least * std::pow(largest_radius / least, i / (number_of_radii - 1.0)));
    radii_.back() = largest_radius;
}

/// Adds the points of a set, or of a part of it, to those in the balls.
void NumberVarianceEstimate::count(const PointSet& points, Counts& counts) const
{
    const auto add = [&](const auto& counter) {
        for (std::size_t r = 0; r < radii_.size(); ++r)
            add_points_in_balls(counter, radii_[r], is_window_ ? radii_[r] : 0, counts[r]);
    };
    counts.resize(radii_.size(), std::vector<std::int64_t>(centres_));
    if (dimension_ == 2) add(BallCounter<2>(points));
    if (dimension_ == 3) add(BallCounter<3>(points));
}

void NumberVarianceEstimate::add_counts(const Counts& counts, std::uint64_t points)
{
    std::vector<double> means, variances;
    for (std::size_t r = 0; r < radii_.size(); ++r) {
        const double expected = static_cast<double>(points) * torus_ball_volume(radii_[r], dimension_);
        const Moments moments = moments_of(counts[r], expected, is_window_);
        means.push_back(moments.mean);
        variances.push_back(moments.variance);
    }
    means_.push_back(std::move(means));
    variances_.push_back(std::move(variances));
}

void NumberVarianceEstimate::add(const PointSet& points)
{
    if (points.dimension != dimension_) throw InputError("number variance: sets differ in dimension");
    if (radii_.empty()) return;
    Counts counts;
    count(points, counts);
    add_counts(counts, points.size());
}

void NumberVarianceEstimate::add(const PointStrips& points)
{
    if (points.dimension() != dimension_) throw InputError("number variance: sets differ in dimension");
    if (radii_.empty()) return;
    Counts counts;
    for (std::size_t strip = 0; strip < points.count(); ++strip) {
        stop_if_interrupted();
        count(points.strip(strip), counts);
    }
    add_counts(counts, points.size());
}

void NumberVarianceEstimate::append(const NumberVarianceEstimate& other)
{
    means_.insert(means_.end(), other.means_.begin(), other.means_.end());
    variances_.insert(variances_.end(), other.variances_.begin(), other.variances_.end());
}

std::vector<NumberVarianceBin> NumberVarianceEstimate::mean() const
{
    if (variances_.empty()) return {};
    const auto sets = static_cast<double>(variances_.size());
    std::vector<NumberVarianceBin> bins(radii_.size());
    for (std::size_t i = 0; i < bins.size(); ++i) {
        NumberVarianceBin& bin = bins[i];
        bin.radius = radii_[i];
        for (const auto& means : means_) bin.points += means[i] / sets;
        for (const auto& variances : variances_) bin.variance += variances[i] / sets;
        double squares = 0;
        for (const auto& variances : variances_)
            squares += (variances[i] - bin.variance) * (variances[i] - bin.variance);
        bin.standard_error = sets > 1 ? std::sqrt(squares / (sets - 1) / sets) : 0;
    }
    return bins;
}

}
