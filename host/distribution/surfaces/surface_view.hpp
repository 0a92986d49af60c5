// Pictures of points on a surface: orthographic views, from the front above and from behind above.
#pragma once

#include "base/images/png_file.hpp"
#include "host/sampling/surfaces/fixed_surface.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace poissonlab {

/// Views are drawn so wide by default, two of them beside each other.
inline constexpr int default_view_pixels = 2048;

/// The ways in which points are drawn.
struct SurfaceDots
{
    double distance = 0;    ///< in the mesh's units: dots are a third of it wide
    bool is_closed = false; ///< the surface has no open edges, and points on triangles that face away are hidden
    std::vector<std::uint32_t> classes{}; ///< of each point, whose dots have a colour for each class; empty: black dots
};

/// The colour of a class in pictures and files: red, green, blue of sRGB, from 0 to 255.
std::array<float, 3> color_of_class(std::size_t own);

/// Draws both views, `pixels` wide together: triangles in the light from the viewer, points as dots where the surface
/// does not hide them. z points upwards. The picture is as high as the views need, and no higher than half its width.
/// It is grey unless points have classes.
PngPixels surface_view(const FixedSurface& surface, const std::vector<SurfacePoint>& points, const SurfaceDots& dots,
                       int pixels = default_view_pixels);

}
