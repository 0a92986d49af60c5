// The settings of [[distribution]] kind = "classes".
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace poissonlab {

/// kind = "classes": see host/distribution/classes/class_points.hpp. Lists have a value for each class.
struct ClassSettings
{
    std::vector<std::size_t> points; ///< empty: to saturation
    std::vector<double> distances;   ///< of points of the same class; empty: of `matrix`, or those of relative_radius
    std::vector<double> matrix;      ///< of all pairs, row after row; empty: Wei's
    double relative_radius = 0.62;   ///< of each class, where there are no distances
    double factor = 1; ///< all distances are multiplied by it where a class with points to come is full; 1: an error
    int dimension = 2;
    std::uint32_t colors = 0;    ///< of corner tiles that are built, whose points and distances these are; 0: none
    std::filesystem::path tiles; ///< a tile set whose points have classes, instead of all of these; empty: darts
    std::uint32_t torus = 12;    ///< tiles along each axis
    std::uint32_t sets = 1;      ///< that spectra are means over; files have the first

    std::size_t classes() const;
    bool has_tiles() const { return colors > 0 || !tiles.empty(); }
};

}
