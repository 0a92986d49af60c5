// The number variance: how much the number of points in a disk (3D: ball) varies from place to place, over its radius.
//
// Torquato and Stillinger, Local density fluctuations, hyperuniformity, and order metrics, Phys. Rev. E 68, 041113
// (2003). For independent uniform points on the unit torus it is N V (1 - V), V the ball's volume; sets are
// hyperuniform where it grows slower than the volume, as the surface R^(d - 1) at best.
//
// Balls have centres drawn at random, the same for all sets, and the variance is the mean square deviation from N V,
// which is the exact mean on the torus; in windows, where balls lie inside, from the observed mean.
#pragma once

#include "base/geometry/periodic_box.hpp"
#include "base/geometry/point_set.hpp"
#include "base/points/point_strips.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace poissonlab {

/// One radius, averaged over K sets.
struct NumberVarianceBin
{
    double radius = 0;         ///< in unit lengths
    double points = 0;         ///< N V: the mean number of points in the ball
    double variance = 0;       ///< of that number
    double standard_error = 0; ///< of the variance: from its spread between the sets; 0 for one
};

/// Averages the number variance over sets, in the order given. Radii go from half a mean spacing N^(-1/d) to a quarter,
/// 24 of them in equal ratios; in a box, to a quarter of its shortest side.
///
/// A ball takes the time of its surface, and small ones on the torus together that of their points: see BallCounter.
/// Any number of threads gives the same bytes.
class NumberVarianceEstimate
{
public:
    /// Sets of `points` points, which decide the radii; `is_window`: sets are windows, not tori. Throws InputError
    /// unless the dimension is 2 or 3.
    NumberVarianceEstimate(int dimension, std::size_t points, bool is_window = false, const PeriodicBox& box = {});

    /// The least number of points for which there are radii: a mean spacing of at most a quarter.
    static std::size_t least_points(int dimension) { return dimension == 2 ? 16 : 64; }

    /// Adds one set. Throws InputError for another dimension. Coordinates must lie in [0, 1).
    void add(const PointSet& points);

    /// Adds a set on disk, whose strips are counted one after another. Numbers are equal to those of the set in memory.
    void add(const PointStrips& points);

    /// Appends the sets of `other`, which was constructed alike; equal to adding them here.
    void append(const NumberVarianceEstimate& other);

    /// The mean of what was added; empty where nothing was, below least_points(), and in boxes that are too narrow.
    /// Errors are between the `groups` of sets, see errors_of_mean().
    std::vector<NumberVarianceBin> mean(const std::vector<std::size_t>& groups = {}) const;

    /// The curves of the sets as bytes, which are read into an estimate that was constructed alike.
    template <class Archive>
    void serialize(Archive& archive)
    {
        archive(means_, variances_);
    }

private:
    using Counts = std::vector<std::vector<std::int64_t>>; ///< of each radius, in the balls

    void count(const PointSet& points, Counts& counts) const;
    void add_counts(const Counts& counts, std::uint64_t points);

    int dimension_;
    bool is_window_;
    PeriodicBox box_;
    std::size_t centres_ = 0;
    std::vector<double> radii_;
    std::vector<std::vector<double>> means_, variances_; ///< one list a set
};

}
