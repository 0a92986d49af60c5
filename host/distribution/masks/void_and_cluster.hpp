// Ranks of the pixels of a torus by the void-and-cluster method.
//
// Ulichney, The void-and-cluster method for dither array generation, 1993. The influence of pixels is a Gaussian of
// deviation 1.5 pixels, as there, in whole numbers: their sums do not depend on their order. The paper's third phase,
// clusters of the pixels that are left, is its second one here: on a torus where there is most of them there is least
// of the others.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

namespace poissonlab {

/// The rank of each pixel, row after row, each of 0 to width * height - 1 once: those of a lower rank than any are
/// even. `width` and `height` are at least 16. `on_part` is told how much is done, from 0 to 1.
std::vector<std::uint32_t> void_and_cluster(std::uint32_t width, std::uint32_t height, std::uint64_t seed,
                                            const std::function<void(double part)>& on_part = {});

}
