// The anisotropy between lattice peaks of spectra whose powers have a known variance.
#include "analysis/measures/off_lattice_anisotropy.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace poissonlab {
namespace {

/// Mean powers of K realizations of exponential power, times a speckle that all realizations have in common: the mean
/// of `tiles - 1` exponential variables, 1 for none. Multiples of `lattice` have a thousand times as much.
Spectrum speckled(int dimension, int size, int realizations, int lattice, int tiles)
{
    Spectrum spectrum{.dimension = dimension, .size = size, .points = 1000, .realizations = realizations, .power = {}};
    const auto count = static_cast<std::size_t>(std::pow(size, dimension));
    std::mt19937 random(static_cast<unsigned>(realizations + tiles));
    std::gamma_distribution<double> mean_of_sets(realizations, 1.0 / realizations);
    std::gamma_distribution<double> speckle(std::max(1, tiles - 1), 1.0 / std::max(1, tiles - 1));
    const auto is_multiple = [&](std::size_t index) { return (static_cast<int>(index) - size / 2) % lattice == 0; };
    const auto m = static_cast<std::size_t>(size);
    for (std::size_t i = 0; i < count; ++i) {
        const double power = mean_of_sets(random) * (tiles > 1 ? speckle(random) : 1);
        const bool on_lattice =
            is_multiple(i % m) && is_multiple(i / m % m) && (dimension == 2 || is_multiple(i / m / m));
        spectrum.power.push_back(on_lattice ? 1000 * power : power);
    }
    return spectrum;
}

TEST(OffLatticeAnisotropy, IsThatOfTheSpeckleAlone)
{
    for (const int tiles : {1, 8, 64}) {
        const double variance = tiles > 1 ? 1.0 / (tiles - 1) : 0;
        // The variance of a product of independent factors of mean 1.
        const double expected = 10 * std::log10((1 + 0.1) * (1 + variance) - 1) + 10;
        for (const int dimension : {2, 3}) {
            const auto found =
                off_lattice_anisotropy_db(speckled(dimension, dimension == 2 ? 512 : 48, 10, 8, tiles), 8);
            ASSERT_TRUE(found);
            EXPECT_NEAR(*found, expected, 0.15) << tiles << " tiles";
        }
    }
}

TEST(OffLatticeAnisotropy, NeedsRealizationsAndRings)
{
    EXPECT_FALSE(off_lattice_anisotropy_db(speckled(2, 64, 1, 8, 1), 8));
    EXPECT_FALSE(off_lattice_anisotropy_db(speckled(2, 16, 10, 8, 1), 8));
    Spectrum even = speckled(2, 64, 10, 8, 1);
    even.power.assign(even.power.size(), 1);
    EXPECT_FALSE(off_lattice_anisotropy_db(even, 8));
}

}
}
