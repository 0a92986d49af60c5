// The half of a real set's frequencies that determines the rest: P(-f) = P(f).
#pragma once

#include "analysis/spectra/uninitialized_vector.hpp"
#include "base/geometry/periodic_box.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace poissonlab {

/// Frequencies in the order in which transforms end with them: u = 0 .. M/2 along x, slowest; then -M/2 ..
/// M/2 along y, then z, fastest. Scale and sign as in spectrum.hpp.
struct HalfSpectrum
{
    int dimension = 2;
    int size = 0; ///< M, even
    UninitializedVector<double> power;
    PeriodicBox box = {}; ///< of which these are the frequencies

    std::size_t columns() const { return static_cast<std::size_t>(size) / 2 + 1; }
    /// Frequencies along y, and along z.
    std::size_t rows() const { return static_cast<std::size_t>(size) + 1; }
    /// Lines of rows() frequencies for each u.
    std::size_t lines() const { return dimension == 3 ? rows() : 1; }
};

/// All M^dimension frequencies in the order of Spectrum, times `factor`, from those in the order of
/// HalfSpectrum.
std::vector<double> all_frequencies(std::span<const double> half, int dimension, int size, double factor = 1);

inline std::vector<double> all_frequencies(const HalfSpectrum& half)
{
    return all_frequencies(half.power, half.dimension, half.size);
}

/// The half of all M^dimension frequencies.
HalfSpectrum half_of(const std::vector<double>& power, int dimension, int size);

/// The mean power of each bin of radial_statistics(), from half of the samples: the other half is the same.
std::vector<double> radial_means(const HalfSpectrum& half, double bin_width = 1);

}
