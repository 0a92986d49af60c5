// The scales of a picture: how wide the things are that it shows, and whether it is alike everywhere.
#pragma once

#include "host/texture/comparison/light_map.hpp"

#include <optional>

namespace poissonlab {

/// Subtracts from each value the mean over a square of 2 reach + 1 values around it, as far as it is in the map: what
/// changes slowly is gone.
LightMap without_slow_light(const LightMap& light, int reach);

/// Returns the side of the squares, between whole numbers, whose means have the part `share` of the variance of all
/// values. It returns nothing if squares of half of the shorter side still have more, or if all values are the same.
std::optional<double> side_at_share(const LightMap& light, double share);

}
