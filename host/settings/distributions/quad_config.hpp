// These settings say how a mesh becomes a surface of quads. They are keys of [[distribution]] kind = "surface" with
// method = "quads", and of textures and objects on surfaces.
#pragma once

#include "base/word_table.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>

namespace poissonlab {

/// The quads of a surface come from one of these.
enum class QuadWay
{
    faces,    ///< of the mesh, all of which are quads
    polycube, ///< squares of a polycube, on which another file has the mesh's vertices
    cube,     ///< squares of a cube, from whose middle the mesh is seen
};
inline constexpr WordTable<QuadWay, 3> quad_ways{
    {{{QuadWay::faces, "faces"}, {QuadWay::polycube, "polycube"}, {QuadWay::cube, "cube"}}}};

/// A mesh as quads: see host/distribution/surfaces/quad_surface.hpp.
struct QuadSurface;

struct QuadSettings
{
    std::filesystem::path mesh;
    QuadWay way = QuadWay::faces;
    std::filesystem::path polycube{};
    double cube_side = 1;                      ///< of the polycube's cubes, in units of its file
    std::uint32_t smooth = 0;                  ///< steps of Catmull and Clark
    std::uint32_t refine = 1;                  ///< parts along a side of a quad
    std::shared_ptr<const QuadSurface> read{}; ///< the surface, where it was made already
};

}
