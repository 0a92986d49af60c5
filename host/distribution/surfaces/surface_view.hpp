// Files of points on a surface, and pictures of them: orthographic views, from the front above and from behind above.
#pragma once

#include "base/images/png_file.hpp"
#include "host/sampling/surfaces/fixed_surface.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace poissonlab {

/// Views are drawn so wide by default, two of them beside each other.
inline constexpr int default_view_pixels = 2048;

/// How points are drawn.
struct SurfaceDots
{
    double distance = 0;    ///< in the mesh's units: dots are a third of it wide
    bool is_closed = false; ///< the surface has no open edges, and points on triangles that face away are hidden
};

/// Draws both views, `pixels` wide together: triangles in the light from the viewer, points as dots where the surface
/// does not hide them. z points upwards. The picture is as high as the views need, and no higher than half its width.
PngPixels surface_view(const FixedSurface& surface, const std::vector<SurfacePoint>& points, const SurfaceDots& dots,
                       int pixels = default_view_pixels);

/// Writes points, whole or not at all: .ply has x, y, z as doubles and the normals nx, ny, nz of their triangles as
/// floats, binary in the byte order of this machine, .csv has these columns, and .glb (glTF 2.0) both as floats; other
/// ends are point files as write_points() has them. Throws StorageError.
void write_surface_points(const std::filesystem::path& file, const FixedSurface& surface,
                          const std::vector<SurfacePoint>& points, const std::string& comment);

/// Normals of points, three numbers each.
PointSet normals_of(const FixedSurface& surface, const std::vector<SurfacePoint>& points);

}
