// Regions that the parameters of a test name.
#pragma once

#include "base/regions/region_text.hpp"
#include "tests/support/random_region.hpp"

#include <string>

namespace poissonlab::test {

/// Returns a star with holes and about N corners in a square of 2^31 units for "starN", or else the region that a text
/// for read_region() describes.
inline PlaneRegion named_region(const std::string& name)
{
    return name.starts_with("star") ? star_with_holes(5, std::stoi(name.substr(4)), 0x1p31) : read_region(name);
}

}
