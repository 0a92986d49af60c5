// The density of points folded over the tile: the points of all tiles in one, to be looked at. It is even where tiles
// leave no trace; strips show as lines along the borders.
#pragma once

#include "base/geometry/point_set.hpp"
#include "base/images/square_image.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace poissonlab {

/// Counts the points of toroidal tilings of the plane by their place in their tile's square, in bins of about a quarter
/// of the radius that disks have at a relative radius of 0.75.
class FoldedDensity
{
public:
    /// Chooses bins for tilings of `tiles` tiles along each axis with about `points` points.
    FoldedDensity(int tiles, std::size_t points);

    /// Counts all points of a tiling.
    void add(const PointSet& points);

    /// Adds the counts of other tilings of the same kind.
    void append(const FoldedDensity& other);

    /// The bins along each axis.
    int size() const { return size_; }

    /// The density in each bin over the mean one. At least one point must have been counted.
    SquareImage densities() const;

    template <class Archive>
    void serialize(Archive& archive)
    {
        archive(counts_);
    }

private:
    double tiles_;
    int size_;
    std::vector<std::uint64_t> counts_;
};

}
