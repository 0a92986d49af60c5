// The region around a point in which its next neighbours may lie, as sectors between arcs of circles.
//
// Dunbar and Humphreys, A spatial data structure for fast Poisson-disk sample generation, 2006: an annulus from which
// disks are cut. A sector has an angle and, at each of its directions, all distances between two arcs.
// kernels/common/sectors/scalloped_region.clh does the same operations.
#pragma once

#include "kernels/common/sectors/directions.h"

#include <vector>

namespace poissonlab::reference {

/// A place by direction and distance from the point.
struct PolarPlace
{
    double angle = 0;
    double distance = 0;
};

class ScallopedRegion
{
public:
    /// The annulus from `radius` to twice that. Empty by default.
    ScallopedRegion() = default;
    explicit ScallopedRegion(double radius);

    /// Cuts off a disk with its centre at a place, relative to the point. Slivers of less than a billionth of a turn or
    /// of the area are dropped.
    void subtract(double x, double y, double radius);

    bool is_empty() const { return sectors_.empty(); }
    double area() const { return area_; }

    /// A uniform place in the region, from two uniform numbers in [0, 1). It must not be empty.
    PolarPlace sample(double u, double v) const;

private:
    using UnitVector = contract::directions::UnitVector;

    /// An arc as a distance for each direction: of a circle's two intersections with a ray, the nearer or the farther.
    struct Arc
    {
        double x = 0, y = 0; ///< of the circle's centre
        double radius = 0;
        bool is_far = true;

        double across(const UnitVector& direction) const { return x * direction.y - y * direction.x; }
        double at(const UnitVector& direction) const;
        double swept(double angle, const UnitVector& direction) const; ///< area up to an angle, but for a constant
    };

    struct Sector
    {
        double begin = 0, end = 0;
        Arc inner, outer;
        double area = 0;

        double swept(double angle) const;
    };

    void cut(const Sector& sector, const Arc& near, std::vector<Sector>& result) const;
    void keep(Sector sector, std::vector<Sector>& result) const;
    static void add_crossings(const Arc& a, const Arc& b, std::vector<double>& directions);

    double radius_ = 0;
    double area_ = 0;
    std::vector<Sector> sectors_;
};

}
