// The share of the power on a lattice, of spectra that are known.
#include "analysis/tilings/tiled_sets.hpp"

#include "base/errors/errors.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace poissonlab {
namespace {

/// Power 1, `peak` at the multiples of `tiles`, much at f = 0 and at the lowest frequencies, which have no mirror
/// images.
HalfSpectrum spectrum_with_lattice(int dimension, int size, int tiles, double peak)
{
    std::vector<double> power;
    const int half = size / 2;
    for (int z = dimension == 3 ? -half : 0; z < (dimension == 3 ? half : 1); ++z)
        for (int y = -half; y < half; ++y)
            for (int x = -half; x < half; ++x) {
                const bool is_origin = x == 0 && y == 0 && z == 0;
                const bool is_lowest = x == -half || y == -half || z == -half;
                const bool is_multiple = x % tiles == 0 && y % tiles == 0 && z % tiles == 0;
                power.push_back(is_origin || is_lowest ? 1e9 : is_multiple ? peak : 1);
            }
    return half_of(power, dimension, size);
}

TEST(LatticeShare, CountsThePowerAtMultiplesOfTheTiles)
{
    for (const int dimension : {2, 3})
        for (const int tiles : {1, 2, 3, 5})
            for (const double peak : {1.0, 20.0}) {
                constexpr int size = 16;
                const double all = std::pow(size - 1, dimension) - 1;
                const double lattice = std::pow(2 * ((size / 2 - 1) / tiles) + 1, dimension) - 1;
                EXPECT_NEAR(lattice_share(spectrum_with_lattice(dimension, size, tiles, peak), tiles),
                            peak * lattice / (peak * lattice + all - lattice), 1e-12)
                    << dimension << "D, " << tiles << " tiles, " << peak;
            }
}

TEST(LatticeShare, NeedsATile) { EXPECT_THROW(lattice_share(spectrum_with_lattice(2, 8, 2, 1), 0), InputError); }

}
}
