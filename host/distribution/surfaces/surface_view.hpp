// Pictures of points on a surface: orthographic views, from the front above and from behind above.
#pragma once

#include "base/images/png_file.hpp"
#include "host/sampling/surfaces/fixed_surface.hpp"

#include <vector>

namespace poissonlab {

/// Views are drawn so wide by default, two of them beside each other.
inline constexpr int default_view_pixels = 2048;

/// Both views, `pixels` wide together: triangles in the light from the viewer, points as dots of a third of their
/// distance, where the surface does not hide them. z points upwards. `distance` is in the mesh's units.
PngPixels surface_view(const FixedSurface& surface, const std::vector<SurfacePoint>& points, double distance,
                       int pixels = default_view_pixels);

}
