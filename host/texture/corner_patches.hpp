// The patches of the exemplar that the colours of corners stand for.
#pragma once

#include "host/texture/salience.hpp"
#include "host/texture/texture_request.hpp"

#include <vector>

namespace poissonlab {

/// The patches of all colours, T x T.
using Patches = std::vector<ExemplarWindow>;

/// Patches are drawn from this part of all windows, those whose middles stand out least (salience.hpp).
inline constexpr double most_salience = 0.25;

/// A free window that stands out no more than most_salience of all do, or the plainest of those drawn.
ExemplarWindow plain_window(const UsedWindows& used, const PngPixels& exemplar, ColumnRange columns,
                            const Salience& salience, int size, RandomWords& words);

/// The best of several sets of random patches that do not stand out: those that misfit least where they meet at the
/// middles of edges, have about the exemplar's colours, and give a tiling little power at multiples of 1/T. Patches of
/// marked corners come from their exemplar.
Patches chosen_patches(const PngPixels& exemplar, const TextureRequest& request, int distance);

/// Returns the exemplar that a piece over patches of these colours comes from: that of most of them, or either. Empty
/// where there is one exemplar.
std::vector<ColumnRange> ranges_for(const PngPixels& exemplar, const TextureRequest& request,
                                    const std::vector<Color>& colors);

}
