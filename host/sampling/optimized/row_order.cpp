#include "host/sampling/optimized/row_order.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace poissonlab {

RowOrder::RowOrder(const PointSet& points)
{
    const double rows = std::ceil(std::sqrt(static_cast<double>(points.size())));
    std::vector<std::pair<double, std::uint32_t>> places;
    for (std::uint32_t i = 0; i < points.size(); ++i)
        places.emplace_back(std::floor(points[i][1] * rows) * rows + std::floor(points[i][0] * rows), i);
    std::ranges::sort(places);
    for (const auto& [place, number] : places) numbers_.push_back(number);
}

PointSet RowOrder::sorted(const PointSet& points) const
{
    PointSet sorted{points.dimension, {}};
    sorted.coordinates.reserve(points.coordinates.size());
    for (const std::uint32_t number : numbers_)
        sorted.coordinates.insert(sorted.coordinates.end(), points[number].begin(), points[number].end());
    return sorted;
}

PointSet RowOrder::restored(const PointSet& sorted) const
{
    PointSet points = sorted;
    for (std::size_t i = 0; i < numbers_.size(); ++i)
        std::ranges::copy(sorted[i], points.coordinates.begin() + 2 * static_cast<std::ptrdiff_t>(numbers_[i]));
    return points;
}

std::vector<double> RowOrder::restored(const std::vector<double>& sorted) const
{
    std::vector<double> values(sorted.size());
    for (std::size_t i = 0; i < numbers_.size(); ++i) values[numbers_[i]] = sorted[i];
    return values;
}

}
