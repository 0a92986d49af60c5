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
//
// Classes may have densities: then the cells of a part of the region have shares of the density in a space-filling
// order, and the darts of slots aim at places that are evenly spread over these shares.
#pragma once

#include "base/geometry/class_distances.hpp"
#include "base/geometry/point_set.hpp"
#include "base/random/random.hpp"
#include "base/regions/fixed_region.hpp"
#include "host/sampling/device_method.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace poissonlab {

/// Cells that may have room for a class: 2^level along each axis, D coordinates each, in an order in which neighbours
/// are near each other (Morton's). At first one, all of the torus.
struct OpenCells
{
    std::uint32_t level = 0;
    std::vector<std::uint32_t> cells;
    std::vector<double> masses{};        ///< of each cell, in any unit; empty: there is no density
    std::vector<std::uint32_t> starts{}; ///< the share of the masses before each cell, in units of 2^-32
    std::size_t covered_at = 0;          ///< the points that the class had when cells were last looked at

    std::size_t count(int dimension) const { return cells.size() / static_cast<std::size_t>(dimension); }
};

/// A part of a region that has its own numbers of points.
struct ClassPart
{
    std::shared_ptr<const FixedRegion> region{}; ///< none: the torus
    std::vector<double> shares;                  ///< see FillOrder
    std::vector<std::size_t> points{};           ///< of each class, where it stops; empty: at saturation
    std::vector<OpenCells> densities{};          ///< of each class; empty: points fall uniformly

    std::size_t most_of(std::size_t own) const { return points.empty() ? SIZE_MAX : points[own]; }
};

struct ClassDartRequest
{
    int dimension = 2;
    ClassDistances distances;
    std::vector<double> shares;      ///< see FillOrder
    std::vector<std::size_t> points; ///< of each class, where it stops; empty: at saturation
    double factor = 1;               ///< all distances are multiplied by it where a class with an end is full
    StreamKey stream{};
    std::shared_ptr<const FixedRegion> region{}; ///< the plane region that all points lie in; none: the torus
    std::size_t parts = 0;                       ///< filled one after another; 0: one part with all of this
    /// Makes a part when it is filled, so that memory holds one of them at a time.
    std::function<ClassPart(std::size_t part)> part_at{};
    /// Is told of each part with densities and of its points, in order. They are in the last argument alone.
    std::function<void(std::size_t part, const ClassPart& made, const struct ClassedPoints& points)> on_filled{};
};

struct ClassedPoints
{
    PointSet points;                      ///< in the order in which they came; coordinates are multiples of 2^-32
    std::vector<std::uint32_t> classes;   ///< of each point
    std::vector<bool> is_full;            ///< of each class: no further point of it fits, proven
    double scale = 1;                     ///< what all distances have been multiplied by
    std::vector<std::size_t> part_ends{}; ///< for each part of the request, the number of points up to its end

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
