// Spectra of periodic rectangles and boxes, against sums over points and over their reciprocal lattice.
#include "analysis/measures/hyperuniformity.hpp"
#include "analysis/spectra/radial_statistics.hpp"
#include "analysis/spectra/spectrum.hpp"
#include "tests/support/periodic_boxes.hpp"
#include "tests/support/point_patterns.hpp"

#include <gtest/gtest.h>

#include <complex>
#include <map>
#include <numbers>

namespace poissonlab {
namespace {

using namespace test;

/// The structure factor of points at `positions` = coordinates times sides, at the wave vector 2 pi (u_k / side_k).
double structure_factor(const PointSet& points, const std::vector<double>& sides, const std::array<int, 3>& u)
{
    std::complex<double> sum;
    for (std::size_t i = 0; i < points.size(); ++i) {
        double phase = 0;
        for (std::size_t k = 0; k < sides.size(); ++k)
            phase += 2 * std::numbers::pi * u[k] / sides[k] * (points[i][k] * sides[k]);
        sum += std::polar(1.0, -phase);
    }
    return std::norm(sum) / static_cast<double>(points.size());
}

Spectrum spectrum_in(const std::vector<double>& sides, const std::vector<PointSet>& sets, int size,
                     PeriodogramMethod method = PeriodogramMethod::fast)
{
    SpectrumEstimate estimate(sets.front().dimension, size, false, method);
    estimate.lie_in(periodic_box(sides));
    for (const PointSet& set : sets) estimate.add(set);
    return estimate.mean();
}

/// Rings by the length of the wave vector in the sides' own unit, over 2 pi and times the root of the area (volume).
std::map<long, std::pair<double, std::size_t>> direct_rings(const PointSet& points, const std::vector<double>& sides,
                                                            int size)
{
    std::map<long, std::pair<double, std::size_t>> rings;
    double volume = 1;
    for (const double side : sides) volume *= side;
    const double root = std::pow(volume, 1.0 / static_cast<double>(sides.size()));
    const int half = size / 2, slices = sides.size() == 3 ? half : 1;
    for (int w = -slices + 1; w < slices; ++w)
        for (int v = -half + 1; v < half; ++v)
            for (int u = -half + 1; u < half; ++u) {
                const std::array<int, 3> f{u, v, w};
                double squared = 0;
                for (std::size_t k = 0; k < sides.size(); ++k) squared += std::pow(f[k] / sides[k] * root, 2);
                if (squared == 0) continue;
                auto& [power, samples] = rings[std::max(1l, std::lround(std::sqrt(squared)))];
                power += structure_factor(points, sides, f);
                ++samples;
            }
    return rings;
}

TEST(BoxSpectrum, IsTheSumOverPointsAtWaveVectorsOfTheReciprocalLattice)
{
    std::mt19937_64 random(1);
    for (const auto& sides : sides_of_boxes()) {
        const int size = sides.size() == 2 ? 48 : 14;
        const PointSet points = random_points(60, static_cast<int>(sides.size()), random);
        auto rings = direct_rings(points, sides, size);
        for (const auto method : {PeriodogramMethod::exact, PeriodogramMethod::fast}) {
            const auto radial = radial_statistics(spectrum_in(sides, {points}, size, method));
            ASSERT_FALSE(radial.empty());
            for (const RadialBin& ring : radial) {
                const auto& [power, samples] = rings[std::lround(ring.frequency)];
                EXPECT_EQ(ring.samples, samples) << ring.frequency;
                EXPECT_NEAR(ring.power, power / static_cast<double>(samples), 1e-6 * ring.power);
            }
            // The next ring would leave the spectrum along the longest side.
            EXPECT_GT((radial.back().frequency + 1.5) * periodic_box(sides).longest(), size / 2 - 0.5);
        }
    }
}

TEST(BoxSpectrum, RingsOfHalfSpectraAreThoseOfWholeOnes)
{
    std::mt19937_64 random(2);
    for (const auto& sides : sides_of_boxes()) {
        const PointSet points = random_points(50, static_cast<int>(sides.size()), random);
        SpectrumEstimate estimate(points.dimension, 20);
        estimate.lie_in(periodic_box(sides));
        estimate.add(points);
        const auto radial = radial_statistics(estimate.mean());
        const auto& means = estimate.radial_curves().front();
        ASSERT_EQ(means.size(), radial.size());
        for (std::size_t k = 0; k < means.size(); ++k) EXPECT_NEAR(means[k], radial[k].power, 1e-12 * means[k]);
    }
}

TEST(BoxSpectrum, OfRandomPointsIs1InEveryRing)
{
    std::mt19937_64 random(3);
    constexpr int sets = 20;
    for (const auto& sides : sides_of_boxes()) {
        const int dimension = static_cast<int>(sides.size());
        std::vector<PointSet> all;
        for (int i = 0; i < sets; ++i) all.push_back(random_points(300, dimension, random));
        for (const RadialBin& ring : radial_statistics(spectrum_in(sides, all, dimension == 2 ? 128 : 32))) {
            const double deviation = std::sqrt(2 / (sets * static_cast<double>(ring.samples)));
            EXPECT_NEAR(ring.power, 1, 5 * deviation) << ring.frequency;
        }
    }
}

TEST(BoxSpectrum, OfAStretchedSquareLatticeHasItsPeaks)
{
    constexpr int n = 12; // 2 n x n points in a box of 2 x 1: squares with the frequency n root 2 in its unit
    PointSet points{2, {}};
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < 2 * n; ++x)
            points.coordinates.insert(points.coordinates.end(), {x / (2.0 * n), y / (1.0 * n)});
    const Spectrum spectrum = spectrum_in({2, 1}, {points}, 128, PeriodogramMethod::exact);
    for (int v = -64; v < 64; ++v)
        for (int u = -64; u < 64; ++u)
            EXPECT_NEAR(spectrum.at(u, v), u % (2 * n) == 0 && v % n == 0 ? 2.0 * n * n : 0, 1e-9);
    for (const RadialBin& ring : radial_statistics(spectrum)) {
        int peaks = 0; // of the lattice, within the ring
        for (int j = -9; j <= 9; ++j)
            for (int i = -9; i <= 9; ++i)
                peaks += (i != 0 || j != 0) &&
                         std::lround(n * std::sqrt(2.0 * (i * i + j * j))) == std::lround(ring.frequency);
        EXPECT_NEAR(ring.power, peaks * 2.0 * n * n / static_cast<double>(ring.samples), 1e-8) << ring.frequency;
    }
}

TEST(BoxSpectrum, OfTwoCopiesIsThatOfTheSquareAtEvenFrequenciesAndZeroBetween)
{
    std::mt19937_64 random(4);
    const PointSet one = random_points(80, 2, random);
    const Spectrum single = spectrum_in({}, {one}, 32, PeriodogramMethod::exact);
    const Spectrum both = spectrum_in({2, 1}, {two_copies(one)}, 64, PeriodogramMethod::exact);
    // Sums over points are twice as large, and so are their squares over the number of points.
    for (int v = -16; v < 16; ++v)
        for (int u = -32; u < 32; ++u) EXPECT_NEAR(both.at(u, v), u % 2 == 0 ? 2 * single.at(u / 2, v) : 0, 1e-10);
}

TEST(BoxSpectrum, ShellsHoldFrequenciesOfOneLength)
{
    std::mt19937_64 random(5);
    const PointSet points = random_points(200, 2, random);
    const Spectrum spectrum = spectrum_in({2, 1}, {points}, 64, PeriodogramMethod::exact);
    std::map<int, std::pair<double, std::size_t>> expected; // by twice the squared length, u^2 + 4 v^2
    for (int v = 0; v < 32; ++v)
        for (int u = v == 0 ? 1 : -31; u < 32; ++u)
            if (u * u + 4 * v * v <= 100) {
                expected[u * u + 4 * v * v].first += spectrum.at(u, v);
                ++expected[u * u + 4 * v * v].second;
            }
    const auto range = hyperuniform_range(200, 2, 0, periodic_box(std::vector<double>{2, 1}));
    EXPECT_NEAR(range.begin, std::sqrt(0.5), 1e-9); // the lowest frequency of all
    const auto shells = power_shells(spectrum, {range.begin, std::sqrt(50) * (1 + 1e-9)});
    ASSERT_EQ(shells.size(), expected.size());
    auto shell = shells.begin();
    for (const auto& [squared, sum] : expected) {
        EXPECT_NEAR(shell->frequency, std::sqrt(squared / 2.0), 1e-12);
        EXPECT_EQ(shell->pairs, sum.second);
        EXPECT_NEAR(shell->power, sum.first / static_cast<double>(sum.second), 1e-12);
        ++shell;
    }
}

TEST(BoxSpectrum, SizesReachAsFarAlongTheLongestSide)
{
    for (const std::size_t points : {100u, 4'096u, 100'000u})
        for (const double length : {1.5, 2.0, 9.0}) {
            const PeriodicBox box = periodic_box(std::vector<double>{length, 1});
            const int size = spectrum_size(points, 2, box);
            EXPECT_EQ(size % 2, 0);
            EXPECT_GE(size, spectrum_size(points, 2));
            // Four times the principal frequency of sets with relative radius 0.75, on either side of zero together.
            const double asked = 4 / 0.75 * std::sqrt(static_cast<double>(points) * std::sqrt(3) / 2) * box.longest();
            EXPECT_GE(size, std::min(asked, 8192.0 * 7 / 8));
            EXPECT_LE(size, std::max(1.0 * spectrum_size(points, 2), asked * 1.26));
        }
    EXPECT_EQ(spectrum_size(5'000, 3, {}), spectrum_size(5'000, 3));
}

}
}
