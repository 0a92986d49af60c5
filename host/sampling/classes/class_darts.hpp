// Dart throwing with classes of points on the unit torus or in a region: each class and all together are even.
//
// Wei, Multi-class blue noise sampling, SIGGRAPH 2010, section 3. Points come one after the other, each of the class
// that is least filled: darts of that class are thrown until one is far enough from all points, by a distance for each
// pair of classes. A class is full when no further point of it fits, which is proven: then the others go on. Points are
// never taken away again; the paper does so where a class of large distances finds no room.
//
// Relaxation: where `factor` is less than 1, a full class that lacks points makes all distances smaller by it, and all
// classes go on (McCool and Fiume, Hierarchical Poisson disk sampling distributions, Graphics Interface 1992, with the
// proof that nothing fits in the place of a number of failures).
//
// The darts of a slot, the place of one point, fall uniformly into cells that may have room for its class: the whole
// torus at first, and, each time that TRIES darts of a slot failed, the parts of half the size that no single point
// covers. Those are never more than what is left, so the law is that of darts that fall anywhere. In a region, the
// first cells are those that are not outside of it.
#pragma once

#include "base/geometry/class_distances.hpp"
#include "base/geometry/point_set.hpp"
#include "base/random/random.hpp"
#include "base/regions/fixed_region.hpp"
#include "host/sampling/device_method.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace poissonlab {

struct ClassDartRequest
{
    int dimension = 2;
    ClassDistances distances;
    std::vector<double> shares;      ///< see FillOrder
    std::vector<std::size_t> points; ///< of each class, where it stops; empty: at saturation
    double factor = 1;               ///< all distances are multiplied by it where a class with an end is full
    StreamKey stream{};
    std::shared_ptr<const FixedRegion> region{}; ///< the plane region that all points lie in; none: the torus
};

struct ClassedPoints
{
    PointSet points;                    ///< in the order in which they came; coordinates are multiples of 2^-32
    std::vector<std::uint32_t> classes; ///< of each point
    std::vector<bool> is_full;          ///< of each class: no further point of it fits, proven
    double scale = 1;                   ///< what all distances have been multiplied by

    std::vector<std::size_t> counts() const; ///< points of each class
    PointSet of_class(std::uint32_t wanted) const;

    bool operator==(const ClassedPoints&) const = default;
};

namespace reference {
ClassedPoints throw_class_darts(const ClassDartRequest& request);
}

/// Throws darts by kernels/class_darts.cl: every device finds the bytes of the reference.
class ClassDartThrower : DeviceMethod<struct ClassDartBuffers>
{
public:
    /// `work_group_size` 0: the default.
    explicit ClassDartThrower(Device device, std::size_t work_group_size = 0);

    ClassedPoints throw_darts(const ClassDartRequest& request);

    /// The memory that throw_darts() takes, nearly: chance decides how many cells have room.
    static DeviceMemory memory(const ClassDartRequest& request);
};

}
