// Polygons on the unit sphere whose edges are arcs of great circles shorter than a half, corners counterclockwise.
#pragma once

#include "tiles/sphere/healpix.hpp"

#include <vector>

namespace poissonlab {

using SphericalPolygon = std::vector<UnitVector>;

/// The area to the left of a polygon that does not meet itself, by the theorem of Gauss and Bonnet: 2 pi less the
/// angles by which its edges turn.
double area_of(const SphericalPolygon& polygon);

/// Returns true where edges meet elsewhere than at the corner that they have in common, or come nearer than some 1e-7.
bool meets_itself(const SphericalPolygon& polygon);

/// Tells places in the polygon from others by how often an arc to a place inside crosses edges.
class SphericalRegion
{
public:
    /// The polygon must not meet itself, and be smaller than half of the sphere.
    explicit SphericalRegion(SphericalPolygon polygon);

    const UnitVector& inner() const { return inner_; }
    bool contains(const UnitVector& place) const;

private:
    SphericalPolygon polygon_;
    UnitVector inner_{};
    std::vector<UnitVector> normals_; ///< of the planes of edges
    std::vector<bool> is_inner_left_; ///< of these planes
    double least_cosine_ = -1;        ///< to the place inside, of corners
};

}
