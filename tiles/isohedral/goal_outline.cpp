#include "tiles/isohedral/goal_outline.hpp"

#include "base/errors/errors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace poissonlab {
namespace {

double gap(const PlanePoint& a, const PlanePoint& b) { return std::hypot(b[0] - a[0], b[1] - a[1]); }

/// The direction of an outline along its length, twice around: constant between steps, and a turn more after each
/// round.
struct TurningFunction
{
    std::size_t sides = 0;
    std::vector<double> ends;       ///< of each side, in parts of the perimeter
    std::vector<double> directions; ///< of each side, without jumps of a turn

    explicit TurningFunction(const std::vector<PlanePoint>& corners)
    {
        double length = 0;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const PlanePoint &a = corners[i], &b = corners[(i + 1) % corners.size()];
            if (gap(a, b) == 0) continue;
            const double direction = std::atan2(b[1] - a[1], b[0] - a[0]);
            const double before = directions.empty() ? direction : directions.back();
            directions.push_back(before + std::remainder(direction - before, 2 * std::numbers::pi));
            ends.push_back(length += gap(a, b));
        }
        for (double& end : ends) end /= length;
        sides = ends.size();
        for (std::size_t i = 0; i < sides; ++i) {
            ends.push_back(ends[i] + 1);
            directions.push_back(directions[i] + 2 * std::numbers::pi);
        }
    }
};

/// The variance of the difference of directions where the end of side `i` of `a` lies at that of side `j` of `b`.
double variance_of(const TurningFunction& a, std::size_t i, const TurningFunction& b, std::size_t j)
{
    const double a_start = a.ends[i++], b_start = b.ends[j++];
    const std::size_t a_last = i + a.sides - 1, b_last = j + b.sides - 1;
    double at = 0, sum = 0, squares = 0;
    while (at < 1) {
        const double a_end = i < a_last ? a.ends[i] - a_start : 1, b_end = j < b_last ? b.ends[j] - b_start : 1;
        const double next = std::min(a_end, b_end), difference = a.directions[i] - b.directions[j];
        sum += (next - at) * difference;
        squares += (next - at) * difference * difference;
        at = next;
        i += a_end <= at;
        j += b_end <= at;
    }
    return squares - sum * sum;
}

}

GoalOutline::GoalOutline(std::vector<PlanePoint> corners) : corners_(std::move(corners))
{
    const double area = corners_.size() < 3 ? 0 : area_of(corners_);
    if (!(std::abs(area) > 0)) throw InputError("has no area");
    if (area < 0) std::ranges::reverse(corners_);
    corners_.push_back(corners_.front());
    lengths_.push_back(0);
    for (std::size_t i = 1; i < corners_.size(); ++i)
        lengths_.push_back(lengths_.back() + gap(corners_[i - 1], corners_[i]));
    perimeter_ = lengths_.back();
    for (double& length : lengths_) length /= perimeter_;
    for (PlanePoint& p : corners_)
        for (double& x : p) x /= perimeter_;
}

void GoalOutline::append_places(double from, double to, std::size_t count, std::vector<PlanePoint>& places) const
{
    for (std::size_t i = 0; i < count; ++i) {
        double length = std::lerp(from, to, static_cast<double>(i) / static_cast<double>(count));
        length -= std::floor(length);
        const auto after = std::ranges::upper_bound(lengths_, length);
        const auto end = static_cast<std::size_t>(std::min(after, lengths_.end() - 1) - lengths_.begin());
        const double side = lengths_[end] - lengths_[end - 1];
        const double share = side > 0 ? (length - lengths_[end - 1]) / side : 0;
        places.push_back({std::lerp(corners_[end - 1][0], corners_[end][0], share),
                          std::lerp(corners_[end - 1][1], corners_[end][1], share)});
    }
}

std::vector<PlanePoint> GoalOutline::places(std::size_t count) const
{
    std::vector<PlanePoint> places;
    append_places(0, 1, count, places);
    return places;
}

double turning_distance(const std::vector<PlanePoint>& a, const std::vector<PlanePoint>& b)
{
    // For each rotation, the integral is linear in the start between starts at which corners coincide, so that it is
    // least at one of these; there the best rotation leaves the variance.
    const TurningFunction of_a(a), of_b(b);
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < of_a.sides; ++i)
        for (std::size_t j = 0; j < of_b.sides; ++j) least = std::min(least, variance_of(of_a, i, of_b, j));
    return std::sqrt(std::max(0.0, least));
}

}
