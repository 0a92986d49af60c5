// Columns of points and regions as they are called, which both kinds of tile sets of the Python module have in common.
#pragma once

#include "base/regions/plane_region.hpp"

#include <pybind11/pybind11.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace poissonlab {

/// Points of tilings as columns, in the order in which they were found.
struct PointColumns
{
    explicit PointColumns(int dimension_, bool has_tiles_ = true)
        : dimension(static_cast<std::size_t>(dimension_)), has_tiles(has_tiles_)
    {}

    /// Adds a point of runtime/poisson_tiles.h, or one of runtime/monotile_points.h, which has no place of a tile.
    template <class Point>
    void add(const Point& point)
    {
        for (std::size_t axis = 0; axis < dimension; ++axis) {
            positions.push_back(point.position[axis]);
            if constexpr (requires { point.tile; }) tiles.push_back(point.tile[axis]);
        }
        indices.push_back(point.index);
        ids.push_back(point.id);
        levels.push_back(point.level);
    }

    std::size_t dimension;
    bool has_tiles; ///< tiles lie on a grid, whose places are known
    std::vector<double> positions;
    std::vector<std::int32_t> tiles;
    std::vector<std::uint32_t> indices, ids;
    std::vector<double> levels;
};

/// Maps points to the coordinates of a region's file.
PointColumns in_files(const PlaneRegion& region, PointColumns points);

/// Returns arrays by the names of TilePoints.
pybind11::dict columns_of(PointColumns points);

/// Reads a region of in_region(), whose arguments have these names. Throws InputError.
PlaneRegion called_region(const std::string& text, bool is_planar, const std::string& crs, const std::string& overlap,
                          double buffer);

/// Throws InputError where a window would have too many points to be held.
void check_window_points(double points);

}
