// A point set on the toroidal unit square or unit cube.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace poissonlab {

/// N points on the unit torus, in generation order.
///
/// Coordinates lie in [0, 1) and are stored point after point: x0 y0 x1 y1 ... (3D: x0 y0 z0 ...).
struct PointSet
{
    int dimension = 2; ///< 2 or 3
    std::vector<double> coordinates;

    std::size_t size() const { return coordinates.size() / static_cast<std::size_t>(dimension); }

    /// The coordinates of point i.
    std::span<const double> operator[](std::size_t i) const
    {
        const auto d = static_cast<std::size_t>(dimension);
        return {coordinates.data() + i * d, d};
    }

    bool operator==(const PointSet&) const = default;
};

}
