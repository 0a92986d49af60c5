// The patches of the exemplar that the colours of corners stand for.
#pragma once

#include "host/texture/texture_request.hpp"
#include "host/texture/window_choice.hpp"

#include <vector>

namespace poissonlab {

/// The patches of all colours, T x T.
using Patches = std::vector<ExemplarWindow>;

/// The best of several sets of random patches: those that misfit least where they meet at the middles of edges, and
/// have about the exemplar's colours. Patches of marked corners come from their exemplar.
Patches chosen_patches(const PngPixels& exemplar, const TextureRequest& request, int distance);

/// Where a piece over patches of these colours comes from: the exemplar of most of them, or either. Empty where there
/// is one exemplar.
std::vector<ColumnRange> ranges_for(const PngPixels& exemplar, const TextureRequest& request,
                                    const std::vector<Color>& colors);

}
