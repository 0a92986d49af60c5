// The keys that say how a region is read, planar, crs, overlap and buffer, and those of obstacles.
#pragma once

#include "base/regions/region_reading.hpp"
#include "host/settings/keys/keys.hpp"

#include <array>
#include <optional>
#include <string>

namespace poissonlab {

inline constexpr std::array region_reading_names{"planar", "crs", "overlap", "buffer"};

/// Visits planar and crs, which lines have as well. Throws InputError for systems of coordinates that PROJ does not
/// know.
void region_coordinates_keys(Keys& keys, RegionReading& reading);

/// Visits all of them.
void region_reading_keys(Keys& keys, RegionReading& reading);

/// Visits obstacles and obstacle_distance; `usually` says which distance is kept where none is given.
void obstacle_keys(Keys& keys, std::string& obstacles, std::optional<double>& distance, const std::string& usually);

}
