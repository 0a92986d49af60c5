// Measures of sets on disk are those of the same sets in memory: counts and least distances to the last bit, sums over
// all points within their rounding.
#include "analysis/measures/distance_statistics.hpp"
#include "analysis/measures/integration_error.hpp"
#include "analysis/measures/number_variance.hpp"
#include "analysis/measures/pair_correlation.hpp"
#include "analysis/spectra/spectrum.hpp"
#include "analysis/tilings/tiled_sets.hpp"
#include "base/errors/errors.hpp"
#include "base/files/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace poissonlab {
namespace {

/// Independent uniform points, the hardest ones: some are far from all others. `is_fixed`: multiples of 2^-32, for
/// which distances are exact integers.
PointSet random_points(int dimension, std::size_t count, bool is_fixed)
{
    std::mt19937_64 random(static_cast<std::uint64_t>(dimension));
    PointSet set{dimension, {}};
    for (std::size_t i = 0; i < count * static_cast<std::size_t>(dimension); ++i)
        set.coordinates.push_back(is_fixed ? static_cast<double>(random() >> 32) * 0x1p-32
                                           : static_cast<double>(random() >> 11) * 0x1p-53);
    return set;
}

class StripMeasures : public testing::TestWithParam<std::tuple<int, bool, bool>>
{
protected:
    StripMeasures() : strips_(folder_.path(), points_.dimension, points_.size())
    {
        strips_.add(points_.coordinates);
        strips_.finish();
    }

    /// A bound of the rounding of a sum of `points_.size()` numbers of size 1. Other numbers are equal.
    double rounding() const { return static_cast<double>(points_.size()) * 0x1p-53; }

    int dimension_ = std::get<0>(GetParam());
    bool is_window_ = std::get<2>(GetParam());
    PointSet points_ = random_points(dimension_, dimension_ == 2 ? 1000 : 1500, std::get<1>(GetParam()));
    ScratchFolder folder_;
    PointStrips strips_;
};

TEST_P(StripMeasures, StripsHoldEachPointOnce)
{
    EXPECT_GE(strips_.count(), 3u);
    EXPECT_EQ(strips_.size(), points_.size());
    std::size_t points = 0;
    for (std::size_t strip = 0; strip < strips_.count(); ++strip) {
        PointSet all = strips_.strip(strip);
        points += all.size();
        strips_.append_around(strip, 1, 1, false, all);
        EXPECT_EQ(all.size(), points_.size());
    }
    EXPECT_EQ(points, points_.size());
}

TEST_P(StripMeasures, Distances)
{
    const NearestDistances distances = nearest_distances(strips_, is_window_);
    const double mean = is_window_ ? mean_nearest_distance_in_window(points_) : mean_nearest_distance(points_);
    EXPECT_EQ(distances.least, is_window_ ? min_distance_in_window(points_) : min_toroidal_distance(points_));
    EXPECT_NEAR(distances.mean, mean, rounding() * mean);
    EXPECT_EQ(min_distance_within_tiles(strips_, 3), min_distance_within_tiles(points_, 3));
}

TEST_P(StripMeasures, PairsAndPointsInBalls)
{
    PairCorrelationEstimate pairs(dimension_, 0.05, 40, is_window_), pairs_of_strips = pairs;
    pairs.add(points_);
    pairs_of_strips.add(strips_);
    double all = 0;
    for (std::size_t k = 0; k < 40; ++k) {
        EXPECT_EQ(pairs_of_strips.mean()[k].pairs, pairs.mean()[k].pairs) << k;
        EXPECT_EQ(pairs_of_strips.mean()[k].value, pairs.mean()[k].value) << k;
        all += pairs.mean()[k].pairs;
    }
    EXPECT_GT(all, 300);
    NumberVarianceEstimate variance(dimension_, points_.size(), is_window_), variance_of_strips = variance;
    variance.add(points_);
    variance_of_strips.add(strips_);
    ASSERT_FALSE(variance.mean().empty());
    for (std::size_t k = 0; k < variance.mean().size(); ++k)
        EXPECT_EQ(variance_of_strips.mean()[k].variance, variance.mean()[k].variance) << k;
    PairCorrelationEstimate far(dimension_, 0.5, 10, is_window_), far_of_strips = far;
    far.add(points_);
    far_of_strips.add(strips_);
    for (std::size_t k = 0; k < 10; ++k) EXPECT_EQ(far_of_strips.mean()[k].pairs, far.mean()[k].pairs) << k;
}

TEST_P(StripMeasures, Sums)
{
    IntegrationErrorEstimate errors(dimension_, 0), errors_of_strips = errors;
    errors.add(points_);
    errors_of_strips.add(strips_);
    // Values are up to 8 (cosine in 3D), and errors some N^(-1/2).
    for (std::size_t f = 0; f < errors.mean().size(); ++f)
        EXPECT_NEAR(errors_of_strips.mean()[f].rms_error, errors.mean()[f].rms_error, 8 * rounding());
    const int size = dimension_ == 2 ? 128 : 32;
    SpectrumEstimate spectrum(dimension_, size), spectrum_of_strips(dimension_, size);
    spectrum.add(points_);
    spectrum_of_strips.add(strips_);
    // A transform value is a sum of N numbers of size 1, divided by a kernel's transform of at least 1e-2; powers are
    // squares of up to N, over N.
    const auto powers = spectrum.mean().power, powers_of_strips = spectrum_of_strips.mean().power;
    ASSERT_EQ(powers.size(), powers_of_strips.size());
    for (std::size_t i = 0; i < powers.size(); ++i) {
        const double tolerance = 2 * std::sqrt(powers[i] * static_cast<double>(points_.size())) * 100 * rounding();
        ASSERT_NEAR(powers_of_strips[i], powers[i], tolerance + 1e-12) << i;
    }
    SpectrumEstimate exact(dimension_, size, false, PeriodogramMethod::exact);
    EXPECT_THROW(exact.add(strips_), InputError);
}

INSTANTIATE_TEST_SUITE_P(Sets, StripMeasures,
                         testing::Values(std::tuple(2, true, false), std::tuple(2, false, true),
                                         std::tuple(3, false, false), std::tuple(3, true, true)));

/// Clusters with wide empty strips between them: what is nearest is far away.
TEST(StripDistances, OfClusters)
{
    PointSet points{2, {0.1, 0.05, 0.1, 0.06, 0.7, 0.55, 0.5, 0.95}};
    const ScratchFolder folder;
    PointStrips strips(folder.path(), 2, points.size());
    strips.add(points.coordinates);
    strips.finish();
    for (const bool is_window : {false, true}) {
        const NearestDistances distances = nearest_distances(strips, is_window);
        const double mean = is_window ? mean_nearest_distance_in_window(points) : mean_nearest_distance(points);
        EXPECT_EQ(distances.least, is_window ? min_distance_in_window(points) : min_toroidal_distance(points));
        EXPECT_NEAR(distances.mean, mean, 1e-15);
    }
}

}
}
