// The density over the distance from tiles' borders, of points whose density is known.
#include "analysis/measures/seam_density.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace poissonlab {
namespace {

/// Random points on a torus of tiles; those nearer to a border than `strip` tiles are `times` as likely.
PointSet random_tiling(int dimension, int tiles, std::size_t count, double strip, double times, unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(0, 1);
    PointSet set{dimension, {}};
    while (set.size() < count) {
        std::array<double, 3> point{};
        double distance = 1;
        for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k) {
            point[k] = uniform(random);
            const double place = point[k] * tiles;
            distance = std::min(distance, std::abs(place - std::round(place)));
        }
        if (uniform(random) * std::max(1.0, times) > (distance < strip ? times : 1)) continue;
        set.coordinates.insert(set.coordinates.end(), point.begin(), point.begin() + dimension);
    }
    return set;
}

TEST(SeamDensity, FindsWhatStripsHaveTooMuch)
{
    for (const int dimension : {2, 3}) {
        constexpr std::size_t points = 200'000;
        SeamDensity even(dimension, 8, 4096), strips(dimension, 8, 4096);
        even.add(random_tiling(dimension, 8, points, 0, 1, 1));
        EXPECT_LT(*even.largest_deviation(), 0.1);
        // Two bins from the border have twice the density.
        const double strip = even.bins()[1].end;
        strips.add(random_tiling(dimension, 8, points, strip, 2, 2));
        const double part = 1 - std::pow(1 - 2 * strip, dimension);
        EXPECT_NEAR(*strips.largest_deviation(), 2 / (1 + part) - 1, 0.1);
        EXPECT_NEAR(strips.bins()[0].density, 2 / (1 + part), 0.06);
        EXPECT_NEAR(strips.bins()[2].density, 1 / (1 + part), 0.06);
        EXPECT_NEAR(strips.bins().back().end, 0.5, 1e-12);
    }
}

/// Strips of a radius, four bins, that have fewer points or more.
TEST(SeamDensity, TellsWhetherBordersLackPoints)
{
    for (const double times : {0.5, 1.0, 2.0}) {
        SeamDensity seams(2, 8, 4096);
        const double strip = seams.bins()[3].end, part = 1 - std::pow(1 - 2 * strip, 2);
        seams.add(random_tiling(2, 8, 200'000, strip, times, 5));
        EXPECT_NEAR(*seams.border_density(), times / (times * part + 1 - part), 0.02) << times;
    }
    EXPECT_FALSE(SeamDensity(2, 8, 64).border_density()) << "too few points";
}

TEST(SeamDensity, OfPartsIsThatOfTheWhole)
{
    const PointSet first = random_tiling(2, 5, 5000, 0, 1, 3), second = random_tiling(2, 5, 5000, 0, 1, 4);
    SeamDensity whole(2, 5, 5000), part(2, 5, 5000), rest(2, 5, 5000);
    whole.add(first);
    whole.add(second);
    part.add(first);
    rest.add(second);
    part.append(rest);
    EXPECT_EQ(part.largest_deviation(), whole.largest_deviation());
}

TEST(SeamDensity, OfFewPointsIsNotKnown)
{
    SeamDensity density(2, 5, 25);
    density.add(random_tiling(2, 5, 25, 0, 1, 5));
    EXPECT_FALSE(density.largest_deviation());
}

}
}
