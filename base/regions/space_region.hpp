// Regions of space in units of their own: a box, a ball, or where a formula is positive.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace poissonlab {

enum class SpaceShape
{
    box,
    ball,
    solid ///< where a formula in x, y and z is above 0 in a box, or inside of a mesh
};

/// A box, from its lowest corner to its highest.
struct SpaceBox
{
    std::array<double, 3> low{};
    std::array<double, 3> high{};

    double extent(std::size_t k) const { return high[k] - low[k]; }
    double longest() const;
};

struct SolidLattice;

/// Reads a solid at the nodes of a lattice: node 0 lies at `low`, others by steps of `step` away.
using SolidReading = std::function<SolidLattice(const std::array<double, 3>& low, double step,
                                                const std::array<std::uint32_t, 3>& cells)>;

struct SpaceRegion
{
    SpaceShape shape = SpaceShape::box;
    SpaceBox box;           ///< the least one around a ball; that of a solid as it was typed
    std::string formula{};  ///< of a solid
    SolidReading reading{}; ///< of a solid that is no formula, whose file `formula` names then
};

/// Does the text begin as those of read_space_region() do, with a word and a number? Any other text is a region of the
/// plane, or a file.
bool is_space_region_text(std::string_view text);

/// Does a name end as those of meshes do, whose inside is a region of space? See base/surfaces/mesh_solid.hpp.
bool is_mesh_name(std::string_view name);

/// The region that a text describes:
///   box X0 Y0 Z0 X1 Y1 Z1
///   ball X Y Z RADIUS
///   solid X0 Y0 Z0 X1 Y1 Z1 EXPRESSION
/// Throws InputError, a line that begins with the text.
SpaceRegion read_space_region(const std::string& text);

/// The rounding of a distance in space, as distance_rounding() of plane_region.hpp has it in the plane.
double distance_rounding(double distance, const SpaceBox& box);

}
