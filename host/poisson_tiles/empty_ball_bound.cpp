#include "poisson_tiles/empty_ball_bound.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace poissonlab {
namespace {

struct Bounds
{
    double centre;   ///< squared distance from the centre to the nearest point
    double farthest; ///< squared: no place in the square is farther from its nearest point
};

double square_of(double value) { return value * value; }

}

double EmptyBallSearch::radius(std::span<const UnitPosition> points, double known)
{
    best_ = known;
    candidates_.clear();
    for (const UnitPosition& p : points)
        candidates_.push_back(
            {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])});
    constexpr double half = tile_units / 2.0;
    search({{half, half, dimension_ == 3 ? half : 0}, half}, 0, candidates_.size());
    return best_;
}

/// The candidates of the square are those from `first` to `last`.
void EmptyBallSearch::search(const Square& square, std::size_t first, std::size_t last)
{
    const double half_z = dimension_ == 3 ? square.half : 0;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Bounds bounds{infinity, infinity};
    for (std::size_t i = first; i < last; ++i) {
        const double x = std::abs(candidates_[i][0] - square.centre[0]);
        const double y = std::abs(candidates_[i][1] - square.centre[1]);
        const double z = std::abs(candidates_[i][2] - square.centre[2]);
        bounds.centre = std::min(bounds.centre, x * x + y * y + z * z);
        bounds.farthest = std::min(bounds.farthest, square_of(x + square.half) + square_of(y + square.half) +
                                                        square_of(z + half_z));
    }
    best_ = std::max(best_, std::sqrt(bounds.centre));
    if (bounds.farthest <= square_of((1 + tolerance) * best_)) return;

    // Points that are farther from all of the square than the farthest place from its nearest are nowhere
    // nearest.
    for (std::size_t i = first; i < last; ++i) {
        const std::array<double, 3> point = candidates_[i];
        const double x = std::max(std::abs(point[0] - square.centre[0]) - square.half, 0.0);
        const double y = std::max(std::abs(point[1] - square.centre[1]) - square.half, 0.0);
        const double z = std::max(std::abs(point[2] - square.centre[2]) - half_z, 0.0);
        if (x * x + y * y + z * z <= bounds.farthest) candidates_.push_back(point);
    }
    const std::size_t end = candidates_.size();
    const double half = square.half / 2;
    for (unsigned child = 0; child < 1u << dimension_; ++child) {
        Square part{square.centre, half};
        for (unsigned k = 0; k < static_cast<unsigned>(dimension_); ++k)
            part.centre[k] += child >> k & 1 ? half : -half;
        search(part, last, end);
        candidates_.resize(end);
    }
    candidates_.resize(last);
}

}
