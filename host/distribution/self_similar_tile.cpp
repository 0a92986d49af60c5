#include "host/distribution/self_similar_tile.hpp"

#include "base/programs/interrupt.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>

namespace poissonlab {
namespace {

std::uint32_t word_mask(std::uint32_t points) { return (1u << points) - 1; }

}

std::vector<SelfSimilarPoint> self_similar_points(const SelfSimilarStarts& starts, std::uint32_t points)
{
    const std::uint32_t mask = word_mask(points);
    const auto doubled = [&](std::uint32_t word) { return (word << 1 | word >> (points - 1)) & mask; };
    std::vector<SelfSimilarPoint> orbit;
    for (SelfSimilarPoint point{starts.x, starts.y}; orbit.size() < points;
         point = {doubled(point[0]), doubled(point[1])})
        orbit.push_back(point);
    return orbit;
}

std::uint64_t squared_torus_distance(const SelfSimilarPoint& a, const SelfSimilarPoint& b, std::uint32_t points)
{
    std::uint64_t sum = 0;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const std::uint64_t d = a[axis] > b[axis] ? a[axis] - b[axis] : b[axis] - a[axis];
        const std::uint64_t around = std::min(d, word_mask(points) - d);
        sum += around * around;
    }
    return sum;
}

std::uint64_t squared_min_distance(const SelfSimilarStarts& starts, std::uint32_t points)
{
    const auto orbit = self_similar_points(starts, points);
    std::uint64_t least = std::numeric_limits<std::uint64_t>::max();
    for (std::size_t i = 0; i < orbit.size(); ++i)
        for (std::size_t k = 0; k < i; ++k) least = std::min(least, squared_torus_distance(orbit[i], orbit[k], points));
    return least;
}

double self_similar_radius(std::uint64_t squared, std::uint32_t points)
{
    return std::sqrt(static_cast<double>(squared)) / word_mask(points) / std::sqrt(2 / (std::numbers::sqrt3 * points));
}

std::vector<SelfSimilarPoint> ranked_points(const std::vector<SelfSimilarPoint>& points, std::size_t first)
{
    const auto count = static_cast<std::uint32_t>(points.size());
    std::vector<std::uint64_t> nearest(points.size(), std::numeric_limits<std::uint64_t>::max());
    std::vector<SelfSimilarPoint> ranked;
    for (std::size_t next = first; ranked.size() < points.size();) {
        ranked.push_back(points[next]);
        for (std::size_t i = 0; i < points.size(); ++i)
            nearest[i] = std::min(nearest[i], squared_torus_distance(points[i], points[next], count));
        next = static_cast<std::size_t>(std::ranges::max_element(nearest) - nearest.begin());
    }
    return ranked;
}

MaximumPyramid::MaximumPyramid(const Density& density)
{
    levels_.push_back({density.width, density.height, density.weights});
    while (levels_.back().width > 1 || levels_.back().height > 1) {
        const Level& fine = levels_.back();
        Level coarse{(fine.width + 1) / 2, (fine.height + 1) / 2, {}};
        for (int row = 0; row < coarse.height; ++row)
            for (int column = 0; column < coarse.width; ++column) {
                std::uint64_t largest = 0;
                for (int y = 2 * row; y < std::min(2 * row + 2, fine.height); ++y)
                    for (int x = 2 * column; x < std::min(2 * column + 2, fine.width); ++x)
                        largest = std::max(
                            largest, fine.weights[static_cast<std::size_t>(y) * static_cast<std::size_t>(fine.width) +
                                                  static_cast<std::size_t>(x)]);
                coarse.weights.push_back(largest);
            }
        levels_.push_back(std::move(coarse));
    }
}

std::uint64_t MaximumPyramid::largest(const std::array<int, 2>& low, const std::array<int, 2>& high) const
{
    // On this level a rectangle lies in at most 3 x 3 pixels.
    const int size = std::max(high[0] - low[0], high[1] - low[1]) + 1;
    const std::size_t number =
        std::min(levels_.size() - 1, static_cast<std::size_t>(std::bit_width(static_cast<unsigned>(size)) - 1));
    const Level& level = levels_[number];
    std::uint64_t largest = 0;
    for (int y = low[1] >> number; y <= high[1] >> number; ++y)
        for (int x = low[0] >> number; x <= high[0] >> number; ++x)
            largest =
                std::max(largest, level.weights[static_cast<std::size_t>(y) * static_cast<std::size_t>(level.width) +
                                                static_cast<std::size_t>(x)]);
    return largest;
}

namespace {

/// The subdivision of one density.
class Subdivision
{
public:
    Subdivision(const std::vector<SelfSimilarPoint>& ranked, const Density& density, double points)
        : ranked_(ranked), density_(density), pyramid_(density)
    {
        double total = 0;
        for (const std::uint64_t weight : density.weights) total += static_cast<double>(weight);
        points_a_weight_ = points / total;
    }

    std::vector<SubdividedPoint> run()
    {
        visit(0, 0, std::max(density_.width, density_.height));
        return std::move(points_);
    }

private:
    /// Points that a density of this weight puts into a tile of this side, in pixels.
    double asked(std::uint64_t weight, double side) const
    {
        return static_cast<double>(weight) * points_a_weight_ * side * side;
    }

    void visit(double x, double y, double side)
    {
        if (x >= density_.width || y >= density_.height) return;
        const std::array<int, 2> low{static_cast<int>(x), static_cast<int>(y)};
        const std::array<int, 2> high{std::min(density_.width, static_cast<int>(std::ceil(x + side))) - 1,
                                      std::min(density_.height, static_cast<int>(std::ceil(y + side))) - 1};
        const std::uint64_t largest = pyramid_.largest(low, high);
        if (largest == 0) return;
        if (asked(largest, side) <= static_cast<double>(ranked_.size())) return keep(x, y, side);
        stop_if_interrupted();
        for (int quarter = 0; quarter < 4; ++quarter)
            visit(x + (quarter % 2) * side / 2, y + (quarter / 2) * side / 2, side / 2);
    }

    void keep(double x, double y, double side)
    {
        const double units = word_mask(static_cast<std::uint32_t>(ranked_.size()));
        for (std::size_t rank = 0; rank < ranked_.size(); ++rank) {
            const double px = x + side * (ranked_[rank][0] / units), py = y + side * (ranked_[rank][1] / units);
            if (px >= density_.width || py >= density_.height) continue;
            const std::uint64_t weight =
                density_.weights[static_cast<std::size_t>(py) * static_cast<std::size_t>(density_.width) +
                                 static_cast<std::size_t>(px)];
            if (static_cast<double>(rank) + 0.5 < asked(weight, side))
                points_.push_back({px, py, side, static_cast<std::uint32_t>(rank)});
        }
    }

    const std::vector<SelfSimilarPoint>& ranked_;
    const Density& density_;
    MaximumPyramid pyramid_;
    double points_a_weight_ = 0;
    std::vector<SubdividedPoint> points_;
};

}

std::vector<SubdividedPoint> subdivided_points(const std::vector<SelfSimilarPoint>& ranked, const Density& density,
                                               double points)
{
    return Subdivision(ranked, density, points).run();
}

PixelPlaces places_of(const std::vector<SubdividedPoint>& points)
{
    PixelPlaces places;
    for (const SubdividedPoint& point : points)
        for (const double coordinate : {point.x, point.y})
            places.push_back(static_cast<std::uint64_t>(coordinate * 4294967296.0));
    return places;
}

}
