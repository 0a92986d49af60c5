#include "tiles/poisson/proof/empty_ball_bound.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace poissonlab {
namespace {

/// The sum of f(distance along an axis) squared over the axes.
template <unsigned Dimension, class Change>
double squared(const std::array<double, 3>& a, const std::array<double, 3>& b, const Change& change)
{
    double sum = 0;
    for (std::size_t k = 0; k < Dimension; ++k) {
        const double along = change(std::abs(a[k] - b[k]));
        sum += along * along;
    }
    return sum;
}

}

void EmptyBallSearch::take(std::span<const UnitPosition> points, double known)
{
    best_ = known;
    candidates_.clear();
    for (const UnitPosition& p : points)
        candidates_.push_back({static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])});
}

double EmptyBallSearch::radius(std::span<const UnitPosition> points, double known)
{
    take(points, known);
    polygon_ = {};
    constexpr double half = tile_units / 2.0;
    if (dimension_ == 2)
        search<2>({{half, half, 0}, half}, 0, candidates_.size());
    else
        search<3>({{half, half, half}, half}, 0, candidates_.size());
    return best_;
}

double EmptyBallSearch::radius_in(std::span<const UnitPosition> polygon, std::span<const UnitPosition> points,
                                  double known)
{
    take(points, known);
    polygon_ = polygon;
    constexpr double half = tile_units / 2.0;
    search<2>({{half, half, 0}, 2 * half}, 0, candidates_.size());
    return best_;
}

double EmptyBallSearch::depth(const std::array<double, 3>& place) const
{
    double nearest = std::numeric_limits<double>::infinity(); // of the border, squared
    bool is_inside = false;
    for (std::size_t i = 0; i < polygon_.size(); ++i) {
        const UnitPosition& a = polygon_[i];
        const UnitPosition& b = polygon_[(i + 1) % polygon_.size()];
        const double ax = a[0] - place[0], ay = a[1] - place[1], x = b[0] - a[0], y = b[1] - a[1];
        const double along = std::clamp(-(ax * x + ay * y) / (x * x + y * y), 0.0, 1.0);
        nearest = std::min(nearest, (ax + along * x) * (ax + along * x) + (ay + along * y) * (ay + along * y));
        if ((a[1] > place[1]) != (b[1] > place[1]) && (ay * x > ax * y) != (b[1] > a[1])) is_inside = !is_inside;
    }
    return is_inside ? std::sqrt(nearest) : -std::sqrt(nearest);
}

/// The candidates of the square are those from `first` to `last`.
template <unsigned Dimension>
void EmptyBallSearch::search(const Square& square, std::size_t first, std::size_t last)
{
    const double inside = polygon_.empty() ? 0 : depth(square.centre);
    if (inside < -square.half * std::sqrt(2.0)) return;
    double nearest = std::numeric_limits<double>::infinity();  // from the centre, squared
    double farthest = std::numeric_limits<double>::infinity(); // any place of the square from its nearest point
    for (std::size_t i = first; i < last; ++i) {
        const auto& point = candidates_[i];
        nearest = std::min(nearest, squared<Dimension>(point, square.centre, [](double x) { return x; }));
        farthest =
            std::min(farthest, squared<Dimension>(point, square.centre, [&](double x) { return x + square.half; }));
    }
    if (inside >= 0) best_ = std::max(best_, std::sqrt(nearest));
    if (farthest <= (1 + tolerance) * best_ * ((1 + tolerance) * best_)) return;

    // Points that are farther from all of the square than any place in it from its nearest are nowhere
    // nearest.
    for (std::size_t i = first; i < last; ++i) {
        const auto point = candidates_[i];
        const auto outside = [&](double x) { return std::max(x - square.half, 0.0); };
        if (squared<Dimension>(point, square.centre, outside) <= farthest) candidates_.push_back(point);
    }
    const std::size_t end = candidates_.size();
    const double half = square.half / 2;
    for (unsigned child = 0; child < 1u << Dimension; ++child) {
        Square part{square.centre, half};
        for (std::size_t k = 0; k < Dimension; ++k) part.centre[k] += child >> k & 1 ? half : -half;
        search<Dimension>(part, last, end);
        candidates_.resize(end);
    }
    candidates_.resize(last);
}

}
