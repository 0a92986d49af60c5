#include "python/module/arrays.hpp"

#include "base/errors/errors.hpp"
#include "base/points/fitting_domain.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace poissonlab {

pybind11::array_t<double> array_of(PointSet points)
{
    const auto size = static_cast<pybind11::ssize_t>(points.size());
    return array_of(std::move(points.coordinates), {size, points.dimension});
}

namespace {

/// Returns the domain that would fit all numbers, in words.
std::string fitting_words_of(const PointSet& points, const PointOptions& words)
{
    Extent extent;
    for (std::size_t i = 0; i < points.coordinates.size(); ++i)
        extent.add(i % static_cast<std::size_t>(points.dimension), points.coordinates[i]);
    return fitting_words(extent, {0, 1}, words);
}

}

PointSet point_set_of(const AnyArray& array, const std::string& name, bool has_own_units, const PointOptions& words)
{
    if (array.ndim() != 2 || (array.shape(1) != 2 && array.shape(1) != 3)) {
        std::string shape;
        for (pybind11::ssize_t axis = 0; axis < array.ndim(); ++axis)
            shape += fmt::format("{}{}", axis > 0 ? ", " : "", array.shape(axis));
        throw InputError(fmt::format("{}: shape ({}): must be (points, 2) or (points, 3)", name, shape));
    }
    if (array.size() == 0) throw InputError(name + ": has no points");
    PointSet points{static_cast<int>(array.shape(1)), {array.data(), array.data() + array.size()}};
    const auto& x = points.coordinates;
    const auto outside = std::ranges::find_if(
        x, [&](double value) { return has_own_units ? !std::isfinite(value) : !(value >= 0 && value < 1); });
    if (outside != x.end())
        throw InputError(fmt::format(
            "{}: point {}: {}: must be a number{}{}", name, (outside - x.begin()) / points.dimension, *outside,
            has_own_units ? "" : " in [0, 1)", std::isfinite(*outside) ? fitting_words_of(points, words) : ""));
    return points;
}

}
