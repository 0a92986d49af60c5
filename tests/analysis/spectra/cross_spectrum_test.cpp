// Spectra of several sets, against sums term by term.
#include "analysis/spectra/cross_spectrum.hpp"

#include "tests/support/brute_force.hpp"
#include "tests/support/point_patterns.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace poissonlab {
namespace {

TEST(CrossSpectra, AreMeansOfSumsOfWaves)
{
    std::mt19937_64 random(4);
    constexpr int reach = 6;
    const std::vector<PointSet> sets{test::random_points_with_borders(30, 2, random),
                                     test::random_points_with_borders(50, 2, random),
                                     test::random_points_with_borders(9, 2, random)};
    PointSet all{2, {}};
    for (const PointSet& set : sets)
        all.coordinates.insert(all.coordinates.end(), set.coordinates.begin(), set.coordinates.end());
    const CrossSpectra spectra = cross_spectra(sets, reach);
    ASSERT_EQ(spectra.power.size(), 4U);
    ASSERT_EQ(spectra.cross.size(), 3U);
    for (int ring = 1; ring <= reach; ++ring) {
        double own = 0, together = 0, between = 0, count = 0;
        for (int v = -reach; v <= reach; ++v)
            for (int u = -reach; u <= reach; ++u) {
                if (std::lround(std::hypot(u, v)) != ring) continue;
                const auto a = std::complex<double>(test::brute_force_transform(sets[0], {u, v, 0}));
                const auto b = std::complex<double>(test::brute_force_transform(sets[2], {u, v, 0}));
                own += std::norm(a) / 30;
                between += (a * std::conj(b)).real() / std::sqrt(30.0 * 9.0);
                together += test::brute_force_power(all, {u, v, 0});
                ++count;
            }
        const auto bin = static_cast<std::size_t>(ring - 1);
        EXPECT_NEAR(spectra.power[0][bin], own / count, 1e-5);
        EXPECT_NEAR(spectra.power[3][bin], together / count, 1e-5);
        EXPECT_NEAR(spectra.cross[1][bin], between / count, 1e-5); // pairs are (0, 1), (0, 2), (1, 2)
    }
}

}
}
