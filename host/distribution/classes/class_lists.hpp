// Keys that have a number, a distance or a text for each class: of classes on the torus, in regions, on lines and on
// meshes.
#pragma once

#include "host/distribution/classes/class_points.hpp"
#include "host/settings/keys/keys.hpp"

#include <string>
#include <vector>

namespace poissonlab {

/// Visits points, distances, matrix and relative_radius; distances are in `lengths`, in the unit that help names.
void class_list_keys(Keys& keys, ClassSettings& settings, const Interval& lengths, const std::string& unit);

/// Throws InputError where these do not fit together.
void check_class_lists(const Keys& keys, const ClassSettings& settings);

/// Visits a key with a text for each class.
Keys::Said names_of_classes(Keys& keys, const std::string& key, std::vector<std::string>& values,
                            const std::string& help);

/// Visits densities, `help` says of what, and densities_from.
void class_density_keys(Keys& keys, ClassSettings& settings, const std::string& help);

}
