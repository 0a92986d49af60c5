#include "analysis/measures/lattice_peaks.hpp"

#include "analysis/spectra/frequency_power.hpp"
#include "base/errors/errors.hpp"
#include "tests/support/point_patterns.hpp"
#include "tests/support/statistics.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace poissonlab {
namespace {

using namespace test;

/// Background power 1, `peak` at the multiples of `tiles`, and much at f = 0.
Spectrum spectrum_with_peaks(int dimension, int size, int tiles, double peak)
{
    Spectrum spectrum{dimension, size, 100, 1, {}};
    const int half = size / 2;
    for (int w = dimension == 3 ? -half : 0; w < (dimension == 3 ? half : 1); ++w) {
        for (int v = -half; v < half; ++v) {
            for (int u = -half; u < half; ++u) {
                const bool multiple = u % tiles == 0 && v % tiles == 0 && w % tiles == 0;
                spectrum.power.push_back(!multiple ? 1 : u == 0 && v == 0 && w == 0 ? 1e9 : peak);
            }
        }
    }
    return spectrum;
}

double& power_at(Spectrum& spectrum, int fx, int fy)
{
    return spectrum.power[static_cast<std::size_t>((fy + spectrum.size / 2) * spectrum.size + fx + spectrum.size / 2)];
}

TEST(LatticePeaks, AreThePowerOverThatOfTheirSurroundings)
{
    for (const int tiles : {2, 3, 4, 7}) {
        for (const int d : {2, 3}) {
            const int size = d == 2 ? 64 : 32;
            const LatticePeaks peaks = lattice_peaks(spectrum_with_peaks(d, size, tiles, 250), tiles);
            EXPECT_EQ(peaks.max_ratio, 250);
            EXPECT_NEAR(peaks.mean_ratio, 250, 1e-10);
            // Multiples along an axis whose ring of width w = min(3, M - 1) stays within [-size/2, size/2).
            const int w = std::min(3, tiles - 1);
            const int positive = (size / 2 - 1 - w) / tiles, negative = (size / 2 - w) / tiles;
            const auto along = static_cast<std::size_t>(positive + negative + 1);
            EXPECT_EQ(peaks.peaks, (d == 2 ? along * along : along * along * along) - 1) << tiles;
        }
    }
}

TEST(NearLatticePeaks, AreThoseUpToTheFirstRing)
{
    for (const int d : {2, 3}) {
        const int size = d == 2 ? 64 : 32, tiles = 5;
        const Spectrum spectrum = spectrum_with_peaks(d, size, tiles, 250);
        // 100 points: the limit is 11.28 in 2D, 5.32 in 3D. All of the power is counted.
        const double limit = d == 2 ? 1.05 * 10.7457 : 1.05 * 1.73205 * std::cbrt(25.0);
        double peaks = 0, all = 0;
        const int reach = static_cast<int>(limit), slices = d == 3 ? reach : 0;
        for (int z = -slices; z <= slices; ++z)
            for (int y = -reach; y <= reach; ++y)
                for (int x = -reach; x <= reach; ++x) {
                    if (x * x + y * y + z * z > limit * limit || (x == 0 && y == 0 && z == 0)) continue;
                    const bool multiple = x % tiles == 0 && y % tiles == 0 && z % tiles == 0;
                    peaks += multiple;
                    all += multiple ? 250 : 1;
                }
        EXPECT_EQ(peaks, d == 2 ? 20 : 6);
        const auto near = near_lattice_peaks(spectrum, tiles);
        ASSERT_TRUE(near);
        EXPECT_NEAR(near->mean_ratio, 250, 1e-10);
        EXPECT_NEAR(near->excess_share, peaks * 249 / all, 1e-12);
    }
    EXPECT_FALSE(near_lattice_peaks(spectrum_with_peaks(2, 64, 13, 250), 13)) << "none is as low";
}

TEST(LatticePeaks, SayWhichIsTheLargest)
{
    Spectrum spectrum = spectrum_with_peaks(2, 64, 4, 1);
    power_at(spectrum, 12, -8) = 10;
    power_at(spectrum, 11, -8) = 1e4; // not a multiple: no peak, and surroundings of (12, -8) and (8, -8)
    power_at(spectrum, -4, 20) = 7;
    const LatticePeaks peaks = lattice_peaks(spectrum, 4);
    EXPECT_EQ(peaks.max_ratio, 7);
    EXPECT_EQ(peaks.frequency, (std::array{-4, 20, 0}));
    Spectrum volume = spectrum_with_peaks(3, 16, 2, 1);
    volume.power[static_cast<std::size_t>(((2 + 8) * 16 + (-4 + 8)) * 16 + (6 + 8))] = 3;
    EXPECT_EQ(lattice_peaks(volume, 2).frequency, (std::array{6, -4, 2}));
}

TEST(LatticePeaks, OfARepeatedTileHoldAllPower)
{
    std::mt19937_64 random(1);
    const PointSet tile = random_points(20, 2, random);
    PointSet points{2, {}};
    for (int t = 0; t < 16; ++t) {
        for (std::size_t i = 0; i < tile.size(); ++i) {
            points.coordinates.push_back((tile[i][0] + t % 4) / 4);
            points.coordinates.push_back((tile[i][1] + t / 4) / 4);
        }
    }
    const Spectrum spectrum{2, 64, points.size(), 1, exact_periodogram(points, 64)};
    EXPECT_GT(lattice_peaks(spectrum, 4).mean_ratio, 1e15); // nothing else has any, but for rounding
    // Taken for 5 x 5 tiles: the common multiples alone.
    for (const int f : lattice_peaks(spectrum, 5).frequency) EXPECT_EQ(f % 20, 0);
}

TEST(LatticePeaks, OfIndependentPointsAreNone)
{
    std::mt19937_64 random(2);
    std::vector<double> means;
    for (int i = 0; i < 30; ++i) {
        const PointSet points = random_points(400, 2, random);
        const Spectrum spectrum{2, 128, 400, 1, exact_periodogram(points, 128)};
        means.push_back(lattice_peaks(spectrum, 8).mean_ratio);
    }
    // E[P / mean of 48] with exponential P: 24 independent powers in a ring, mean of the inverse 24/23.
    const Mean mean = mean_of(means);
    EXPECT_LT(std::abs(mean.value - 24.0 / 23), z_bound(1) * mean.standard_error);
}

TEST(LatticePeaks, RejectOrLeaveOutWhatHasNoSurroundings)
{
    const Spectrum spectrum = spectrum_with_peaks(2, 16, 4, 2);
    EXPECT_THROW(lattice_peaks(spectrum, 1), InputError);
    EXPECT_THROW(lattice_peaks(spectrum, 0), InputError);
    EXPECT_EQ(lattice_peaks(spectrum, 8).peaks, 0u);
    EXPECT_EQ(lattice_peaks(spectrum, 1000).max_ratio, 0);
    const Spectrum dark{2, 32, 100, 1, std::vector<double>(32 * 32)};
    EXPECT_EQ(lattice_peaks(dark, 4).max_ratio, 0); // 0 over the floor, not 0 / 0
}

/// The list of shells holds every peak and all power of peaks, and where the peaks of a shell have the same power
/// around them its ratio is the mean ratio.
TEST(LatticePeaks, FollowFromListsOfShellsOfEachSet)
{
    for (const int d : {2, 3}) {
        const int size = d == 2 ? 64 : 16, tiles = 4;
        std::mt19937_64 random(3);
        const std::vector<double> power = exact_periodogram(random_points(100, d, random), size);
        const std::vector<double> shells = lattice_shell_powers(half_of(power, d, size), 100, tiles);
        double peaks = 0, of_peaks = 0;
        for (std::size_t i = 0; i < shells.size(); i += 3) peaks += shells[i], of_peaks += shells[i + 1];
        const Spectrum whole{d, size, 100, 1, power};
        EXPECT_EQ(peaks, lattice_peaks(whole, tiles).peaks);
        double sum = 0;
        const int reach = size / 2 - 1, slices = d == 3 ? reach : 0;
        for (int z = -slices; z <= slices; ++z)
            for (int y = -reach; y <= reach; ++y)
                for (int x = -reach; x <= reach; ++x) {
                    const bool is_multiple = x % tiles == 0 && y % tiles == 0 && z % tiles == 0;
                    const int along = std::max({std::abs(x), std::abs(y), std::abs(z)});
                    if (is_multiple && along > 0 && along + 3 < size / 2) sum += frequency_power(whole, {x, y, z});
                }
        EXPECT_NEAR(of_peaks, sum, 1e-9 * sum);
        const Spectrum even = spectrum_with_peaks(d, size, tiles, 250);
        const std::vector<double> of_even = lattice_shell_powers(half_of(even.power, d, size), even.points, tiles);
        EXPECT_NEAR(mean_ratio_of_shells(of_even, even.points), lattice_peaks(even, tiles).mean_ratio, 1e-9);
    }
    EXPECT_EQ(mean_ratio_of_shells({}, 100), 0);
    EXPECT_THROW(lattice_shell_powers(half_of(std::vector<double>(64 * 64), 2, 64), 100, 1), InputError);
}

/// The list that near peaks are made of is linear: a mean of lists has the peaks of the mean spectrum.
TEST(NearLatticePeaks, FollowFromListsOfPowersOfEachSet)
{
    for (const int d : {2, 3}) {
        const int size = d == 2 ? 64 : 16, tiles = 4;
        std::mt19937_64 random(4);
        std::vector<double> sum, sum_of_lists;
        for (int set = 0; set < 3; ++set) {
            const std::vector<double> power = exact_periodogram(random_points(100, d, random), size);
            const std::vector<double> list = near_lattice_powers(half_of(power, d, size), 100, tiles);
            sum.resize(power.size());
            sum_of_lists.resize(list.size());
            for (std::size_t i = 0; i < power.size(); ++i) sum[i] += power[i] / 3;
            for (std::size_t i = 0; i < list.size(); ++i) sum_of_lists[i] += list[i] / 3;
        }
        const auto whole = near_lattice_peaks(Spectrum{d, size, 100, 3, sum}, tiles),
                   lists = near_lattice_peaks(sum_of_lists, 100);
        ASSERT_TRUE(whole && lists);
        EXPECT_NEAR(lists->mean_ratio, whole->mean_ratio, 1e-9 * whole->mean_ratio);
        EXPECT_NEAR(lists->excess_share, whole->excess_share, 1e-9);
    }
    EXPECT_FALSE(near_lattice_peaks(std::vector<double>{3}, 100)) << "no peaks";
}

}
}
