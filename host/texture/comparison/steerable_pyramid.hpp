// Statistics of how a texture's structures go together: correlations of the magnitudes of a steerable pyramid.
//
// Portilla and Simoncelli, A Parametric Texture Model Based on Joint Statistics of Complex Wavelet Coefficients, IJCV
// 40, 2000, section 3: edges are large magnitudes at neighbouring places, in several orientations and scales at once,
// which neither colours nor the power spectrum know of. Filters are of their kind, with four orientations and scales,
// each as many coefficients as pixels; coefficients at the border, which see the opposite one, do not count.
#pragma once

#include "host/texture/comparison/light_map.hpp"

#include <vector>

namespace poissonlab {

inline constexpr int pyramid_scales = 4, pyramid_orientations = 4;

/// Magnitudes of the complex coefficients, of a scale (0 the finest) and an orientation (0: structures that change from
/// west to east, then in eighths of a turn), scale after scale.
std::vector<LightMap> pyramid_magnitudes(const LightMap& map);

/// For each scale, correlations of magnitudes: between orientations, with themselves at twice the scale's distance in
/// four directions, and with those of the next coarser scale.
std::vector<std::vector<double>> magnitude_correlations(const LightMap& map);

}
