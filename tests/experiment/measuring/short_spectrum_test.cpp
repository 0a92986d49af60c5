// Measures of a spectrum that ends early are those of the usual size, or are left out.
#include "experiment/measuring/series_analysis.hpp"
#include "results/measures.hpp"

#include "tests/support/point_patterns.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace poissonlab {
namespace {

std::map<std::string, double> measured(const PointSet& set, int size)
{
    AnalysisOptions options;
    options.spectrum_size = size;
    options.tiles = 4;
    SeriesAnalysis analysis("s", false, options);
    analysis.add(set);
    analysis.measure_spectrum(analysis.mean_spectrum());
    std::map<std::string, double> numbers;
    const Series series = analysis.result();
    for (const Measure& measure : measures())
        if (const auto value = measure.get(series); value) numbers[measure.key] = value->value;
    return numbers;
}

/// Points one in each cell of a grid, off its middle by at most a tenth of it.
PointSet displaced_grid(int n, std::mt19937_64& random)
{
    PointSet set{2, {}};
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x)
            for (const int cell : {x, y}) set.coordinates.push_back((cell + 0.4 + 0.2 * test::uniform(random)) / n);
    return set;
}

TEST(ShortSpectrum, HasNoOtherMeasuresThanTheUsualOne)
{
    std::mt19937_64 random(5);
    for (const int n : {8, 16, 32})
        for (const PointSet& set :
             {test::random_points(static_cast<std::size_t>(n * n), 2, random), displaced_grid(n, random)}) {
            const int usual = spectrum_size(set.size(), 2);
            const auto right = measured(set, usual);
            EXPECT_TRUE(right.contains("oscillation") && right.contains("effective_nyquist"));
            std::size_t fewest = right.size();
            for (int size = 4; size < usual; size += 2) {
                const auto numbers = measured(set, size);
                fewest = std::min(fewest, numbers.size());
                for (const auto& [key, value] : numbers)
                    EXPECT_NEAR(value, right.at(key), 1e-6 * (1 + std::abs(value))) << key << " " << n << " " << size;
                for (const char* key : {"oscillation", "anisotropy_above_chance", "lattice_peaks", "lattice_share"})
                    EXPECT_FALSE(numbers.contains(key)) << key << " " << n << " " << size;
                EXPECT_EQ(numbers.contains("low_frequency_mean"), size / 2 - 1 >= n / 4) << n << " " << size;
            }
            EXPECT_LT(fewest + 5, right.size());
        }
}

}
}
