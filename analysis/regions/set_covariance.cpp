#include "analysis/regions/set_covariance.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace poissonlab {
namespace {

/// Pairs of edges that may be looked at before a table is worth its error: seconds.
constexpr double most_exact_work = 2e8;

/// A table may take so many of them.
constexpr double most_table_work = 5e8;

constexpr int finest_table = 128, coarsest_table = 16;
constexpr int checked_along = 64;

/// The integral of |l(x)| over a width, of a line from l = p to l = q.
double absolute_integral(double p, double q, double width)
{
    const double sum = std::abs(p) + std::abs(q);
    if ((p < 0) == (q < 0) || sum == 0) return width * sum / 2;
    return width * (p * p + q * q) / (2 * sum);
}

}

SetCovariance::SetCovariance(std::span<const RegionEdge> edges)
{
    for (const RegionEdge& e : edges) {
        if (e.from[0] == e.to[0]) continue;
        const bool goes_right = e.from[0] < e.to[0];
        const auto& left = goes_right ? e.from : e.to;
        const auto& right = goes_right ? e.to : e.from;
        spans_.push_back({left[0], right[0], left[1], (right[1] - left[1]) / (right[0] - left[0]),
                          goes_right ? -1.0 : 1.0}); // the region is on the left of edges
    }
    std::ranges::stable_sort(spans_, {}, &Span::left);
    area_ = exact(0, 0);
}

/// Sweeps from left to right: an edge that begins meets those of the other region that have begun and not yet ended.
double SetCovariance::exact(double x, double y) const
{
    std::vector<std::uint32_t> still, moved; // open edges of either
    double sum = 0;
    std::uint32_t i = 0, j = 0;
    const auto n = static_cast<std::uint32_t>(spans_.size());
    const auto meet = [&](const Span& e, const Span& f) { // f is moved
        const double left = std::max(e.left, f.left + x), right = std::min(e.right, f.right + x);
        if (!(left < right)) return;
        const auto above = [&](double at) {
            return e.bottom + e.slope * (at - e.left) - (f.bottom + y + f.slope * (at - x - f.left));
        };
        sum += e.sign * f.sign * absolute_integral(above(left), above(right), right - left);
    };
    while (i < n || j < n) {
        if (j == n || (i < n && spans_[i].left <= spans_[j].left + x)) {
            std::erase_if(moved, [&](std::uint32_t f) { return spans_[f].right + x <= spans_[i].left; });
            for (const std::uint32_t f : moved) meet(spans_[i], spans_[f]);
            if (j == n && moved.empty()) break;
            still.push_back(i++);
        } else {
            std::erase_if(still, [&](std::uint32_t e) { return spans_[e].right <= spans_[j].left + x; });
            for (const std::uint32_t e : still) meet(spans_[e], spans_[j]);
            if (i == n && still.empty()) break;
            moved.push_back(j++);
        }
    }
    return -sum / 2;
}

void SetCovariance::expect(double calls, double reach)
{
    cells_ = 0;
    table_error_ = 0;
    // Pairs that are looked at, about: those of the region with itself.
    double work = 2 * static_cast<double>(spans_.size());
    std::vector<double> ends;
    for (const Span& span : spans_) {
        std::erase_if(ends, [&](double end) { return end <= span.left; });
        work += 2 * static_cast<double>(ends.size());
        ends.push_back(span.right);
    }
    if (calls * work <= most_exact_work) return;
    const int wanted = static_cast<int>(std::sqrt(most_table_work / work / 2));
    cells_ = std::clamp(wanted, coarsest_table, finest_table);
    step_ = reach / cells_;
    const std::size_t columns = 2 * static_cast<std::size_t>(cells_) + 1;
    table_.resize(columns * (static_cast<std::size_t>(cells_) + 1));
    tbb::parallel_for(0, cells_ + 1, [&](int row) {
        for (int column = -cells_; column <= cells_; ++column)
            table_[static_cast<std::size_t>(row) * columns + static_cast<std::size_t>(column + cells_)] =
                exact(column * step_, row * step_);
    });
    measure_table();
}

void SetCovariance::measure_table()
{
    const int stride = std::max(1, cells_ / checked_along);
    std::vector<double> errors(static_cast<std::size_t>(cells_));
    tbb::parallel_for(0, (cells_ + stride - 1) / stride, [&](int k) {
        const int row = k * stride;
        for (int column = -cells_; column < cells_; column += stride) {
            const double x = (column + 0.5) * step_, y = (row + 0.5) * step_;
            double& error = errors[static_cast<std::size_t>(k)];
            error = std::max(error, std::abs(in_table(x, y) - exact(x, y)) / area_);
        }
    });
    table_error_ = std::ranges::max(errors);
}

double SetCovariance::in_table(double x, double y) const
{
    const double column = x / step_ + cells_, row = y / step_;
    const auto c = static_cast<std::size_t>(std::min(column, 2.0 * cells_ - 1));
    const auto r = static_cast<std::size_t>(std::min(row, cells_ - 1.0));
    const double across = column - static_cast<double>(c), up = row - static_cast<double>(r);
    const double* const at = table_.data() + r * (2 * static_cast<std::size_t>(cells_) + 1) + c;
    const double* const above = at + 2 * static_cast<std::size_t>(cells_) + 1;
    return (1 - up) * ((1 - across) * at[0] + across * at[1]) + up * ((1 - across) * above[0] + across * above[1]);
}

double SetCovariance::at(double x, double y) const
{
    if (y < 0) x = -x, y = -y; // C(-h) = C(h)
    const double most = cells_ * step_;
    return cells_ == 0 || y > most || std::abs(x) > most ? exact(x, y) : in_table(x, y);
}

/// Step by step, as what is left need not fall all the way; the last step is halved. Where the first step leaves too
/// little, it is halved until it leaves enough before these halvings count, so that narrow regions have a reach above
/// 0.
double SetCovariance::reach(double share, double most) const
{
    constexpr int directions = 16, steps = 16, halvings = 8;
    constexpr double shortest = 1e-12;
    std::array<double, directions> reaches{};
    tbb::parallel_for(0, directions, [&](int d) {
        const double angle = std::numbers::pi * d / directions;
        const auto leaves_enough = [&](double length) {
            return exact(length * std::cos(angle), length * std::sin(angle)) >= share * area_;
        };
        double low = 0, high = most;
        for (int k = 1; k <= steps; ++k) {
            high = k * most / steps;
            if (!leaves_enough(high)) break;
            low = high;
        }
        for (int k = 0; k < halvings && low < high && high > shortest; k += low > 0) {
            const double middle = (low + high) / 2;
            (leaves_enough(middle) ? low : high) = middle;
        }
        reaches[static_cast<std::size_t>(d)] = low;
    });
    return std::ranges::min(reaches);
}

}
