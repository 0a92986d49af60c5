// Values of keys that several schemes have.
#pragma once

#include "host/settings/config_tree.hpp"
#include "tiles/isohedral/isohedral_tile.hpp"

#include <optional>
#include <vector>

namespace poissonlab {

/// The numbers of a list, from -most to most; nothing for any other value.
std::optional<std::vector<double>> numbers_of_list(const ConfigNode& list, double most = 100);

/// The curve of a list of points [x, y], with (0, 0) before and (1, 0) after them; nothing for any other value.
std::optional<PlaneCurve> curve_of_node(const ConfigNode& list);

}
