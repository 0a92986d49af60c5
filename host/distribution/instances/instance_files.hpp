// Instances for other programs: tables of numbers, points with properties, and USD's point instancer.
#pragma once

#include "host/distribution/instances/instances.hpp"

#include <string>

namespace poissonlab {

/// Lines under the names of their columns.
std::string instances_csv(const std::vector<Instance>& instances);

/// Vertices with properties, ascii.
std::string instances_ply(const std::vector<Instance>& instances);

/// A point instancer whose prototypes are simple stand-ins that fit a disk of this radius: put your models in their
/// place.
std::string instances_usda(const std::vector<Instance>& instances, const InstanceSettings& settings, double radius);

}
