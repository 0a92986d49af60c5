// Penrose points: kernel against twin, windows in windows, and both against a subdivision that leaves nothing out.
#include "host/tile_sampling/penrose/penrose_points.hpp"

#include "analysis/spectra/spectrum.hpp"
#include "base/densities/density_text.hpp"
#include "host/tile_sampling/penrose/penrose_sampler.hpp"
#include "host/tile_sampling/penrose/penrose_walk.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <map>
#include <numbers>
#include <random>
#include <set>

namespace poissonlab {
namespace {

/// Vectors of all sizes that tables have.
PenroseTable random_table(unsigned seed)
{
    std::mt19937 random(seed);
    PenroseTable table;
    for (auto& row : table.rows)
        for (PenroseVector& v : row)
            v = {static_cast<std::int32_t>(random() % 30'000) - 15'000,
                 static_cast<std::int32_t>(random() % 30'000) - 15'000};
    return table;
}

PenroseTiling tiling_with(const std::string& formula)
{
    const PenroseTable table = random_table(5);
    return formula.empty() ? PenroseTiling(table)
                           : PenroseTiling(table, DensityBounds(density_of_formula(formula, 1, 1)));
}

constexpr std::array formulas{"", "exp(-9*(x^2+y^2))", "x > 0 ? 1 : 0.1", "x > 0.99 && y > 0.99 ? 1 : 0"};

class PenrosePoints : public testing::TestWithParam<const char*>
{
protected:
    PenroseTiling tiling_ = tiling_with(GetParam());
};

TEST_P(PenrosePoints, OfKernelAndTwinAreTheSame)
{
    Device device = Device::open();
    for (const std::size_t group : {1U, 7U, 64U}) {
        PenroseGenerator generator(device, tiling_, group);
        for (const std::uint64_t importance : {1U, 20U, 999U, 60'000U, 61'000U})
            EXPECT_EQ(generator.points(importance), point_set_of(reference::penrose_points(tiling_, importance)))
                << importance;
    }
}

/// Few enough for an interpreter of kernels.
TEST(FewPenrosePoints, OfKernelAndTwinAreTheSame)
{
    const PenroseTiling tiling = tiling_with("x > 0 ? 1 : 0.1");
    PenroseGenerator generator(Device::open(), tiling, 7);
    for (const std::uint64_t importance : {1U, 20U, 999U})
        EXPECT_EQ(generator.points(importance), point_set_of(reference::penrose_points(tiling, importance)))
            << importance;
}

TEST_P(PenrosePoints, OfAWindowAreThoseOfTheSquareThere)
{
    const auto all = reference::penrose_points(tiling_, 150'000);
    for (const PenroseWindow window : {PenroseWindow{{0, 0}, 1U << 30},
                                       {{3'000'000'000U, 3'000'000'000U}, 1'294'967'296U},
                                       {{77, 1U << 31}, 12'345'678}}) {
        std::set<std::pair<std::uint64_t, std::uint32_t>> inside, found;
        for (const PenrosePoint& point : all)
            if (point.place[0] - std::uint64_t{window.low[0]} < window.side &&
                point.place[1] - std::uint64_t{window.low[1]} < window.side)
                inside.insert({point.value, point.place[0]});
        for (const PenrosePoint& point : reference::penrose_points(tiling_, 150'000, window))
            found.insert({point.value, point.place[0]});
        EXPECT_EQ(found, inside);
    }
}

/// Places by complex numbers, in scales of the root and relative to its first corner.
std::complex<double> complex_place(const RingPlace& place)
{
    std::complex<double> sum = 0;
    for (int k = 0; k < 4; ++k)
        sum += static_cast<double>(place.c[static_cast<std::size_t>(k)]) * std::polar(1.0, k * std::numbers::pi / 5);
    return sum;
}

/// The places of all points of a level that stay, by value: nothing is left out on the way, and numbers are rounded as
/// they come.
std::map<std::uint64_t, std::complex<double>> all_points(const PenroseTiling& tiling, std::uint64_t importance)
{
    const PenroseRow row = row_of_importance(tiling.scales, importance);
    const double phi = std::numbers::phi, scale = 2 * std::pow(phi, -static_cast<double>(row.level));
    std::vector<PenroseTile> tiles{PenroseTile{}}, next;
    for (std::size_t level = 0; level < row.level; ++level, tiles.swap(next)) {
        next.clear();
        for (const PenroseTile& tile : tiles)
            for (const PenroseTile& child : divided(tile)) next.push_back(child);
    }
    std::map<std::uint64_t, std::complex<double>> places;
    for (const PenroseTile& tile : tiles) {
        if (!is_point(tile) || tile.value >= importance) continue;
        const PenroseVector v = tiling.table.rows[row.row][static_cast<std::size_t>(structural_index(tile.digits))];
        const std::complex<double> moved =
            std::complex<double>(v.along, v.left) * 0x1p-14 * std::polar(1.0, tile.direction * std::numbers::pi / 10);
        places[tile.value] = scale * (complex_place(tile.p1) + moved) - std::complex<double>(phi * phi - 0.5, 0.25);
    }
    return places;
}

TEST(PenroseCulling, LosesNoPoint)
{
    const PenroseTiling tiling(random_table(8));
    for (const std::uint64_t importance : {900U, 1'300U, 40'000U}) {
        auto expected = all_points(tiling, importance);
        std::erase_if(expected, [](const auto& point) {
            const auto [x, y] = std::pair(point.second.real(), point.second.imag());
            return x < 0 || y < 0 || x >= 1 || y >= 1;
        });
        const auto found = reference::penrose_points(tiling, importance);
        ASSERT_EQ(found.size(), expected.size());
        for (const PenrosePoint& point : found) {
            ASSERT_TRUE(expected.contains(point.value));
            const std::complex<double> place(point.place[0] * 0x1p-32, point.place[1] * 0x1p-32);
            EXPECT_LT(std::abs(place - expected[point.value]), 0x1p-31); // rounded down to 2^-32
        }
    }
}

TEST(PenrosePointsOfSmallerImportance, ArePartOfThoseOfALargerOne)
{
    const PenroseTiling tiling{PenroseTable{}}; // without vectors, which change from row to row
    std::map<std::uint64_t, std::array<std::uint32_t, 2>> larger;
    for (const PenrosePoint& point : reference::penrose_points(tiling, 90'000)) larger[point.value] = point.place;
    for (const std::uint64_t importance : {30'000U, 46'368U, 46'369U, 80'000U}) {
        std::size_t below = 0;
        for (const auto& [value, place] : larger) below += value < importance;
        const auto found = reference::penrose_points(tiling, importance);
        EXPECT_NEAR(static_cast<double>(found.size()), static_cast<double>(below), 1); // rounding at the border
        for (const PenrosePoint& point : found)
            for (std::size_t k = 0; k < 2 && larger.contains(point.value); ++k)
                EXPECT_NEAR(point.place[k], larger[point.value][k], 1);
    }
}

TEST(PenroseImportance, HitsTheNumberOfPoints)
{
    const PenroseTiling even = tiling_with("");
    for (const std::size_t points : {1U, 50U, 1'000U, 16'384U}) {
        const auto found = reference::penrose_points(even, importance_for_points(even, points)).size();
        EXPECT_NEAR(static_cast<double>(found), static_cast<double>(points), 0.002 * static_cast<double>(points))
            << points;
    }
    for (const std::size_t i : {1U, 2U, 3U}) {
        const PenroseTiling tiling = tiling_with(formulas[i]);
        const auto found = reference::penrose_points(tiling, importance_for_points(tiling, 5'000)).size();
        EXPECT_NEAR(static_cast<double>(found), 5'000, 25) << formulas[i];
    }
}

TEST(PenroseDensity, IsFollowed)
{
    // Each row's points lie evenly: in a part of the square their number differs by those along its border.
    const PenroseTiling tiling(PenroseTable{}, DensityBounds(density_of_formula("x > 0 ? 1 : 0.25", 1, 1)));
    const auto points = reference::penrose_points(tiling, 200'000);
    double left = 0, right = 0;
    for (const PenrosePoint& point : points) ++(point.place[0] < 1U << 31 ? left : right);
    const double dense = 200'000 * points_per_importance / 2;
    EXPECT_NEAR(right, dense, 3 * std::sqrt(dense));
    EXPECT_NEAR(left, dense / 4, 3 * std::sqrt(dense / 4));
}

TEST(PenroseSpectrum, IsATenfoldStar)
{
    const PenroseTiling tiling{PenroseTable{}};
    const PointSet points = point_set_of(reference::penrose_points(tiling, 40'000));
    SpectrumEstimate estimate(2, 256, false, PeriodogramMethod::fast, 1);
    estimate.add(points);
    const Spectrum spectrum = estimate.mean();
    // Angular harmonics of the power in a ring, over the harmonic 0: a star of ten rays has the tenth only.
    std::array<std::complex<double>, 13> harmonics{};
    for (int fy = -120; fy <= 120; ++fy)
        for (int fx = -120; fx <= 120; ++fx) {
            const double frequency = std::hypot(fx, fy);
            if (frequency < 20 || frequency > 120 || fx == 0 || fy == 0) continue; // the window's cross
            const double power = spectrum.at(fx, fy);
            for (std::size_t k = 0; k < harmonics.size(); ++k)
                harmonics[k] += power * std::polar(1.0, static_cast<double>(k) * std::atan2(fy, fx));
        }
    for (std::size_t k = 1; k < harmonics.size(); ++k) {
        const double share = std::abs(harmonics[k] / harmonics[0]);
        if (k == 10)
            EXPECT_GT(share, 0.3);
        else
            EXPECT_LT(share, 0.15) << k;
    }
}

INSTANTIATE_TEST_SUITE_P(Densities, PenrosePoints, testing::ValuesIn(formulas));

}
}
