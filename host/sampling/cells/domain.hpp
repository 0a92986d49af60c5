// The domain in which points move: the unit torus, less convex regions that they must not enter, with points
// that are held.
//
// Poisson tiles are made in such domains: the points of corner and edge tiles are held, and the displacement
// vectors of the others end where they meet those tiles' regions (dissertation, sections 4.3 to 4.6).
#pragma once

#include "base/geometry/point_set.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace poissonlab {

/// A displacement or a direction; in 2D the last component is 0.
using Vector = std::array<double, 3>;

/// The positions p with normal . p <= offset. Normals have unit length.
struct HalfSpace
{
    Vector normal{};
    double offset = 0;
};

/// The intersection of half-spaces, which are given relative to a centre on the torus. Along each axis a
/// region either stays within half the torus around its centre, or goes on unchanged for ever: a slab across
/// all of the torus is the intersection of two half-spaces. Regions that adjoin should overlap: along a
/// common face there is no way in, but a movement exactly in the plane of that face is free.
struct ConvexRegion
{
    Vector centre{};
    std::vector<HalfSpace> half_spaces; ///< at least one
};

struct Domain
{
    std::vector<ConvexRegion> forbidden;
    std::vector<std::uint8_t> is_fixed; ///< one a point, non-zero: the point is held; empty: none is
};

/// The part of a displacement that keeps out of forbidden regions: movement ends where it meets one or, with
/// `slides`, goes on along the boundary with the component that is left. A point that is inside of a region can
/// leave it but not get deeper; up to 2^-46 inside counts as on the boundary. `position` is in [0, 1), and
/// components of the displacement are in [-1, 1].
Vector allowed_displacement(const Domain& domain, const Vector& position, const Vector& displacement, bool slides);

}
