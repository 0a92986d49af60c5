// Instances for other programs: tables of numbers, points with properties, USD's point instancer and glTF's instances.
#pragma once

#include "host/distribution/instances/instances.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace poissonlab {

/// A turn about z, then a tilt about the horizontal axis across its direction: w, x, y, z of the quaternion.
std::array<double, 4> orientation_of(const Instance& instance);

/// The height of the cone that stands for a model of plants, as high as its number says, over its radius.
double height_of_stand_in(const InstanceSettings& settings, std::uint32_t model);

/// Lines under the names of their columns.
std::string instances_csv(const std::vector<Instance>& instances);

/// Vertices with properties, ascii.
std::string instances_ply(const std::vector<Instance>& instances);

/// Writes glTF whose nodes, one for each model, repeat a simple stand-in that fits a disk of this radius: a cone or a
/// ball. Units are those of the instances; y is up, as glTF wants it: (x, y, z) is written as (x, z, -y). _ID counts
/// instances from 0, and _CLASS is there where they have classes. Throws StorageError, and InputError where numbers are
/// too large for floats.
void write_instances_glb(const std::filesystem::path& file, const std::vector<Instance>& instances,
                         const InstanceSettings& settings, double radius);

/// A point instancer whose prototypes are simple stand-ins that fit a disk of this radius: put your models in their
/// place.
std::string instances_usda(const std::vector<Instance>& instances, const InstanceSettings& settings, double radius);

}
