#include "base/points/flat_points.hpp"

#include <algorithm>
#include <cstddef>

namespace poissonlab {

bool are_flat(const std::vector<PointSet>& sets, double zero)
{
    if (sets.empty() || sets.front().dimension != 3 || sets.front().size() == 0) return false;
    const double third = sets.front().coordinates[2];
    std::size_t points = 0;
    for (const PointSet& set : sets) {
        if (set.dimension != 3) return false;
        points += set.size();
        for (std::size_t i = 2; i < set.coordinates.size(); i += 3)
            if (set.coordinates[i] != third) return false;
    }
    return points > 1 || third == zero;
}

PointSet without_third(PointSet set)
{
    const std::size_t points = set.size();
    for (std::size_t i = 0; i < points; ++i)
        std::copy_n(set.coordinates.begin() + static_cast<std::ptrdiff_t>(3 * i), 2,
                    set.coordinates.begin() + static_cast<std::ptrdiff_t>(2 * i));
    set.coordinates.resize(2 * points);
    set.dimension = 2;
    return set;
}

}
