// Where the seams of a site are dearest.
#pragma once

#include "host/texture/joint/site_move.hpp"

#include <optional>
#include <set>
#include <utility>

namespace poissonlab {

/// North-western pixels of boxes.
using BoxPlaces = std::set<std::pair<int, int>>;

/// The box of a site whose seams cost most, over all its tiles, but for those that are left out; nothing where none has
/// seams. Boxes lie around corners and edges, an eighth of T apart along them, and anywhere in tiles.
std::optional<SiteBox> dearest_box(const Assembly& assembly, const Site& site, int side, const BoxPlaces& left_out);

}
