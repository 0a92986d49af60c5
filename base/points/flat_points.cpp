#include "base/points/flat_points.hpp"

#include <algorithm>

namespace poissonlab {

void FlatAxes::add(int dimension, std::span<const double> coordinates)
{
    is_in_space_ = is_in_space_ && dimension == 3;
    if (!is_in_space_ || coordinates.empty()) return;
    if (points_ == 0) std::copy_n(coordinates.begin(), 3, first_.begin());
    points_ += coordinates.size() / 3;
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (std::size_t i = axis; is_constant_[axis] && i < coordinates.size(); i += 3)
            is_constant_[axis] = coordinates[i] == first_[axis];
}

std::optional<std::size_t> FlatAxes::axis(double zero) const
{
    if (!is_in_space_ || points_ == 0) return std::nullopt;
    if (points_ == 1) return first_[2] == zero ? std::optional<std::size_t>(2) : std::nullopt;
    for (const std::size_t axis : {2u, 0u, 1u})
        if (is_constant_[axis]) return axis;
    return std::nullopt;
}

std::optional<std::size_t> flat_axis(const std::vector<PointSet>& sets, double zero)
{
    FlatAxes axes;
    for (const PointSet& set : sets) axes.add(set.dimension, set.coordinates);
    return axes.axis(zero);
}

PointSet without_axis(PointSet set, std::size_t axis)
{
    std::size_t kept = 0;
    for (std::size_t i = 0; i < set.coordinates.size(); ++i)
        if (i % 3 != axis) set.coordinates[kept++] = set.coordinates[i];
    set.coordinates.resize(kept);
    set.dimension = 2;
    return set;
}

std::string flat_sentence(std::size_t axis)
{
    constexpr std::array names{"first", "second", "third"};
    return std::string("all points have the same ") + names[axis] +
           " coordinate: they are taken as points of the plane, without it";
}

}
