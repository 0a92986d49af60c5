// Functions of counts of pairs of points, and of points and random points, on a mesh: see mesh_pairs.hpp.
#pragma once

#include "host/distribution/surface_spectra/mesh_pairs.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace poissonlab {

/// Anisotropy is that of rings of distances, over sectors of lines without a direction.
inline constexpr std::size_t difference_rings = 16, difference_sectors = 12;

/// Pairs of points, [0], and of points and random points, [1].
using PairCounts = std::array<std::vector<std::uint64_t>, 2>;

/// Returns g by bins, its errors as those of independent pairs. `expected`: pairs for each pair of a point and a random
/// one; `twice`: 2 where pairs of points are counted from both ends, else 1.
std::vector<PairCorrelationBin> pair_correlation(const PairCounts& counts, double expected, double twice);

/// Returns the sum of pairs over the sum of what the densities around the points of each part let expect: those of
/// points within reach, the points themselves left out. Counts are those of all bins of a part after those of the
/// former.
std::vector<PairCorrelationBin> localised_correlation(const PairCounts& bins, std::size_t parts);

/// Returns distances and, in dB, the variance of the pairs in the sectors of a ring over that of independent pairs.
std::vector<std::array<double, 2>> difference_anisotropy(const PairCounts& counts);

/// Blurs counts of differences with the binomial weights of a Gaussian whose standard deviation is 1.4 squares along
/// both axes.
std::vector<double> blurred_differences(const std::vector<std::uint64_t>& counts);

}
