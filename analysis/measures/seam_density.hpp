// The density of points over the distance from the borders of their tiles: seams are where it is not 1.
#pragma once

#include "base/geometry/point_set.hpp"
#include "base/images/square_image.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace poissonlab {

/// A quarter of the radius that disks have at a relative radius of 0.75, in tiles, of tilings of `tiles` tiles along
/// each axis with so many points.
double seam_bin_width(int dimension, int tiles, std::size_t points);

/// Counts the points of toroidal tilings by their distance from the nearest edge (face) of their tile's square (cube),
/// in bins of seam_bin_width().
class SeamDensity
{
public:
    /// Chooses bins for tilings of `tiles` tiles along each axis with about `points` points.
    SeamDensity(int dimension, int tiles, std::size_t points);

    /// Counts all points of a tiling.
    void add(const PointSet& points);

    /// Adds the counts of other tilings of the same kind.
    void append(const SeamDensity& other);

    struct Bin
    {
        double begin = 0, end = 0; ///< distances, in tiles
        double density = 0;        ///< over the mean one
    };
    std::vector<Bin> bins() const;

    /// The largest deviation of a bin's density from 1, of bins that should have at least 400 points. Empty without
    /// any.
    std::optional<double> largest_deviation() const;

    /// The density over the mean one within the radius that disks have at a relative radius of 0.75 of the borders.
    /// Empty where there should be fewer than 400 points.
    std::optional<double> border_density() const;

    template <class Archive>
    void serialize(Archive& archive)
    {
        archive(counts_);
    }

private:
    double volume(std::size_t bin) const;

    int dimension_;
    double tiles_;
    double width_; ///< of bins, in tiles
    std::vector<std::uint64_t> counts_;
};

// The density of points folded over the tile: the points of all tiles in one, to be looked at. It is even where tiles
// leave no trace; strips show as lines along the borders.

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
