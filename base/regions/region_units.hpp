// The words for lengths in regions.
#pragma once

#include "base/regions/region_source.hpp"

namespace poissonlab {

/// The unit of lengths of any region, for descriptions.
inline constexpr auto region_units = "units of the region, or metres for longitude and latitude";

/// The unit of lengths in the plane of a region: "metres" where longitude and latitude were mapped to it.
inline std::string length_units(const PlaneRegion& region)
{
    return is_mapped(region) ? "metres" : "units of the region";
}

}
