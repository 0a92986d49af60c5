// The keys of [[distribution]] with kind = "stippling" and "hatching".
#pragma once

#include "host/config/config_tree.hpp"
#include "host/config/distributions/distribution_config.hpp"

namespace poissonlab {

/// How marks find their places where nothing is said.
inline constexpr MarkPlaces usual_mark_places = MarkPlaces::gaussian;

// Each fills settings, inputs and, where it is empty, the label, and throws InputError.
void read_stippling(const ConfigTable& table, DistributionConfig& config);
void read_hatching(const ConfigTable& table, DistributionConfig& config);

}
