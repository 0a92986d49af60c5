// Sample elimination on surfaces: of many random points, the one that has the others nearest is removed, again and
// again.
//
// Yuksel, Sample elimination for generating Poisson disk sample sets, Computer Graphics Forum 34(2), 2015; section 4.2
// is of surfaces, with distances straight through space. A pair of points at a distance d weighs (1 - d / d_max)^8,
// where d_max is the distance of the densest packing of as many points as are kept in a plane of the surface's area.
// Points whose normals are too far apart do not see each other. Elimination goes on from n to n / 2 points, for the
// order: every beginning of the set is one that elimination would keep, or nearly.
#pragma once

#include "base/random/random.hpp"
#include "host/sampling/device_method.hpp"
#include "host/sampling/surfaces/fixed_surface.hpp"
#include "kernels/common/surfaces/surface_elimination.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace poissonlab {

/// The distances between which weights vary, in the mesh's units, and which normals are near enough.
struct SurfaceReach
{
    double most = 0;  ///< d_max
    double least = 0; ///< d_min
    double angle = 180;
};

/// The numbers of the first `count` points that are removed, in that order.
using SurfaceRemovalOrder = std::function<std::vector<std::uint32_t>(const std::vector<SurfacePoint>& points,
                                                                     const SurfaceReach& reach, std::size_t count)>;

/// Points that are uniform on a surface.
std::vector<SurfacePoint> surface_candidates(const FixedSurface& surface, std::size_t count, const StreamKey& stream);

/// The points that are kept, in progressive order.
std::vector<SurfacePoint> eliminate_on_surface(const FixedSurface& surface, const std::vector<SurfacePoint>& points,
                                               std::size_t kept, double angle,
                                               const SurfaceRemovalOrder& removal_order);

/// Converts a reach to the arguments of kernels; the mask of buckets is left to them.
contract::surface_elimination::Elimination surface_elimination(const FixedSurface& surface, const SurfaceReach& reach,
                                                               std::size_t points);

namespace reference {
/// Finds the order of removal by a heap.
std::vector<std::uint32_t> surface_removal_order(const FixedSurface& surface, const std::vector<SurfacePoint>& points,
                                                 const SurfaceReach& reach, std::size_t count);
}

/// Finds the order of removal by kernels/surfaces/surface_elimination.cl: every device finds that of the reference.
class SurfaceElimination : DeviceMethod<struct SurfaceEliminationBuffers>
{
public:
    /// `work_group_size` 0: the default.
    SurfaceElimination(Device device, std::shared_ptr<const FixedSurface> surface, std::size_t work_group_size = 0);

    std::vector<std::uint32_t> removal_order(const std::vector<SurfacePoint>& points, const SurfaceReach& reach,
                                             std::size_t count);

    static DeviceMemory memory(const FixedSurface& surface, std::size_t points);

private:
    std::shared_ptr<const FixedSurface> surface_;
};

}
