// The point sets that Poisson disk distributions are compared with: random, regular, jittered.
#pragma once

#include "host/sampling/sampler.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace poissonlab {

/// `random`: independent uniform points, a Poisson process given that it has N points.
SamplerSpec random_sampler();

/// The points `first` ... `first` + `count` - 1 of a set of it, dimension coordinates each.
std::vector<double> random_points_from(std::uint64_t first, std::size_t count, int dimension, std::uint64_t seed,
                                       std::uint32_t realization);

/// `regular`: the centres of a lattice of square (3D: cubic) cells. Every realization is the same set.
SamplerSpec regular_sampler();

/// `jittered`: one uniform point in each cell of that lattice.
SamplerSpec jittered_sampler();

/// Cells along a side of the lattice whose number of cells, side^dimension, is nearest to `points`.
/// `points` >= 1; at least 1, at most 2^32 - 1.
std::uint32_t lattice_side(std::size_t points, int dimension);

}
