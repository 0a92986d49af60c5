// A region of the plane in a frame: the unit square that its box has been scaled into, from its lowest corner on.
//
// Points in a region are measured in the frame, where all regions are alike. Lengths of the frame
// times side() are lengths in the region's own units.
#pragma once

#include "analysis/regions/boundary_edges.hpp"
#include "base/geometry/point_set.hpp"
#include "base/regions/fixed_region.hpp"
#include "base/regions/plane_region.hpp"

#include <array>
#include <string>

namespace poissonlab {

class FramedRegion
{
public:
    /// Takes a region that check_region() takes. `name` is how users call it.
    FramedRegion(const PlaneRegion& region, std::string name);

    const std::string& name() const { return name_; }

    /// The polygons in the region's own units, as they were taken.
    const PlaneRegion& own_polygons() const { return own_polygons_; }

    /// The polygons in the frame: outlines go round against the clock, holes with it.
    const PlaneRegion& polygons() const { return polygons_; }
    const BoundaryEdges& boundary() const { return boundary_; }

    std::uint64_t hash() const { return hash_; } ///< of all corners

    double side() const { return side_; } ///< of the frame, in the region's units
    double area() const { return area_; } ///< in squares of the frame
    double own_area() const { return area_ * side_ * side_; }
    double unit_length() const { return unit_length_; } ///< the root of the area, in sides of the frame

    /// The exact region of whole numbers: positions are parts of 2^31 of the frame.
    const FixedRegion& fixed() const { return fixed_; }

    bool contains(const std::array<double, 2>& place) const;

    /// Places that are outside by no more than this count as places on the boundary, in sides of the frame: numbers in
    /// files are rounded.
    static constexpr double tolerance = 1e-6;

    /// Points as files have them, moved into the frame: in the region's units, or in longitude and latitude where it
    /// was mapped to a plane. Throws InputError that begins with `name` where some of them lie outside, or none is
    /// there, or they are in space.
    PointSet framed(const PointSet& points, const std::string& name) const;

    /// A place of the frame in the region's own units.
    std::array<double, 2> own(const std::array<double, 2>& place) const
    {
        return {low_[0] + side_ * place[0], low_[1] + side_ * place[1]};
    }

private:
    std::string name_;
    FixedRegion fixed_;
    std::array<double, 2> low_{};
    double side_ = 1;
    PlaneRegion own_polygons_;
    PlaneRegion polygons_;
    BoundaryEdges boundary_;
    std::uint64_t hash_ = 0;
    double area_ = 0;
    double unit_length_ = 0;
};

}
