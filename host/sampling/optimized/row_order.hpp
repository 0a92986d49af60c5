// Points row by row of a grid, so that what is near on the torus is near in memory.
#pragma once

#include "base/geometry/point_set.hpp"

#include <cstdint>
#include <vector>

namespace poissonlab {

class RowOrder
{
public:
    /// Rows are some mean distance of points wide, in 2D.
    explicit RowOrder(const PointSet& points);

    PointSet sorted(const PointSet& points) const;
    PointSet restored(const PointSet& sorted) const;
    std::vector<double> restored(const std::vector<double>& sorted) const; ///< a value for each point

private:
    std::vector<std::uint32_t> numbers_; ///< that points had
};

}
