// The pair correlation function g(r), also called radial distribution function, on the unit torus.
//
// g(r) is the number of pairs of points at distance r over that of independent uniform points: 1 throughout
// for those, 0 below the minimum distance, and 1 at large distances where there is no order. Illian,
// Penttinen, Stoyan and Stoyan, Statistical Analysis and Modelling of Spatial Point Patterns (2008), chapter
// 4; in computer graphics Heck, Schloemer and Deussen, Blue noise sampling with controlled aliasing, ACM
// Transactions on Graphics 32(3), 2013. Estimated by a histogram:
//
//   g_k = (ordered pairs with k w <= distance < (k + 1) w) / (N (N - 1) (V((k + 1) w) - V(k w)))
//
// V is the exact volume of a ball on the torus (torus_ball.hpp), so there is no edge correction to choose,
// and no largest distance but that of the torus itself, sqrt(2) / 2 and sqrt(3) / 2. With N (N - 1), not N^2,
// the estimate for N independent uniform points is without bias.
//
// For sets that are windows, V is the distribution function of the distance of two independent uniform points
// of the square or cube, up to distance 1 (window_pair_volume): the expected share of pairs, so that the
// estimate has no bias either.
//
// In a periodic box distances go up to half of its shortest side: balls that large do not meet themselves.
#pragma once

#include "base/geometry/periodic_box.hpp"
#include "base/geometry/point_set.hpp"
#include "base/points/point_strips.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace poissonlab {

/// One bin of distances, averaged over K sets.
struct PairCorrelationBin
{
    double distance = 0;       ///< central distance, in unit lengths
    double value = 0;          ///< g, mean over the sets
    double standard_error = 0; ///< of the mean: sample standard deviation over sqrt K; 0 where K = 1
    double pairs = 0;          ///< unordered pairs of points in this bin, mean over the sets
};

/// Averages g over sets, in the order given.
/// Shells of a volume below 1e-14, as those next to the largest distance can be, have g = 0.
///
/// Time of a set is O(N times neighbours within max_distance), at most O(N^2). Any number of threads gives
/// the same bytes.
class PairCorrelationEstimate
{
public:
    /// `bins` of equal width from distance 0 to max_distance in unit lengths; `is_window`: sets are windows, not tori.
    /// Throws InputError unless 0 < max_distance <= largest_toroidal_distance(dimension), bins > 0 and dimension 2 or
    /// 3; in a box that is no square (cube), which holds no windows, unless max_distance is half of its sides at most.
    PairCorrelationEstimate(int dimension, double max_distance, std::size_t bins, bool is_window = false,
                            const PeriodicBox& box = {});

    /// Adds one set. Throws InputError for another dimension or fewer than two points. Coordinates must lie
    /// in [0, 1).
    void add(const PointSet& points);

    /// Adds a set on disk, whose pairs are counted strip by strip. Numbers are equal to those of the set in memory.
    void add(const PointStrips& points);

    /// Appends the sets of `other`, which was constructed alike; equal to adding them here, up to rounding.
    void append(const PairCorrelationEstimate& other);

    /// The mean of what was added; no bins where nothing was. Errors are between the `groups` of sets, see
    /// errors_of_mean().
    std::vector<PairCorrelationBin> mean(const std::vector<std::size_t>& groups = {}) const;

    /// The sums as bytes, which are read into an estimate that was constructed alike.
    template <class Archive>
    void serialize(Archive& archive)
    {
        archive(values_, pairs_);
    }

private:
    std::vector<std::uint64_t> count(const PointSet& points) const;
    void add_counts(const std::vector<std::uint64_t>& counts, std::uint64_t points);

    int dimension_;
    double max_distance_;
    std::size_t bins_;
    bool is_window_;
    PeriodicBox box_;
    std::vector<std::vector<double>> values_; ///< one list of g a set
    std::vector<double> pairs_;               ///< sums over the sets
};

}
