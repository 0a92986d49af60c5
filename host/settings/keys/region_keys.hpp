// The keys that say how a region is read: planar, crs, overlap and buffer.
#pragma once

#include "base/regions/region_reading.hpp"
#include "host/settings/keys/keys.hpp"

#include <array>

namespace poissonlab {

inline constexpr std::array region_reading_names{"planar", "crs", "overlap", "buffer"};

/// Visits planar and crs, which lines have as well. Throws InputError for systems of coordinates that PROJ does not
/// know.
void region_coordinates_keys(Keys& keys, RegionReading& reading);

/// Visits all of them.
void region_reading_keys(Keys& keys, RegionReading& reading);

}
