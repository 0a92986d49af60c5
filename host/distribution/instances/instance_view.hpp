// Shaded views of instances from above: trees as crowns, sunflowers, asteroids around a planet.
//
// Bodies are simple ones that show model, turn, scale and tilt; meshes are for renderers, see instance_files.hpp.
// Colours depend on the C library's sines and may differ by rounding elsewhere.
#pragma once

#include "base/images/png_file.hpp"
#include "host/distribution/instances/instances.hpp"

namespace poissonlab {

inline constexpr int least_view_pixels = 16, most_view_pixels = 4096; ///< along a side

/// The colour of all instances of a model, linear, from 0 to 1: one between two of the scene.
std::array<double, 3> color_of_model(const InstanceSettings& settings, std::uint32_t model);

/// The window of settings with these instances on its ground. Each pixel is the mean of 3 x 3 places. Throws
/// InputError for views of more than most_view_pixels along a side, and Interrupted.
PngPixels view_from_above(const std::vector<Instance>& instances, const InstanceSettings& settings, double radius);

}
