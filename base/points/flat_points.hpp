// Points of the plane that are stored as x, y and a third coordinate that is always the same, or in a plane across
// another axis.
#pragma once

#include "base/geometry/point_set.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace poissonlab {

/// Which coordinates of points in space are all the same? Points come in pieces.
class FlatAxes
{
public:
    void add(int dimension, std::span<const double> coordinates);

    /// The axis that is left out: the third, or else another one, of two points or more. A single point has it where
    /// its third coordinate is `zero`, what 0 has become.
    std::optional<std::size_t> axis(double zero = 0) const;

private:
    std::array<bool, 3> is_constant_{true, true, true};
    std::array<double, 3> first_{};
    std::size_t points_ = 0;
    bool is_in_space_ = true;
};

/// The flat axis of all points of all sets.
std::optional<std::size_t> flat_axis(const std::vector<PointSet>& sets, double zero = 0);

/// Points in space without one of their coordinates.
PointSet without_axis(PointSet set, std::size_t axis);

/// The words for readers whose points lost it.
std::string flat_sentence(std::size_t axis);

}
