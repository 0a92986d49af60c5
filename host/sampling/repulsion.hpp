// Repulsion: points that are too close push each other apart, until a minimum distance is reached.
//
// Not from the papers: it finishes what Lloyd relaxation leaves short of a large relative radius, in tile
// sets above all. One pass pushes every pair that is closer than t = min_distance * 1.0005 apart along its
// line, by half of what it lacks of t each; a free point takes all of it when its partner is held. The pushes
// of a point are summed and applied at once; movement stops at forbidden regions and slides along them. A
// point moves by t at most, which matters only where many points coincide. Coincident points are pushed along
// x, the lower id to the left.
#pragma once

#include "base/geometry/point_set.hpp"
#include "host/sampling/cells/domain.hpp"
#include "host/sampling/device_method.hpp"

#include <cstddef>
#include <cstdint>

namespace poissonlab {

struct RepulsionRequest
{
    double min_distance; ///< that is wanted, in (0, 1], unit lengths
    std::size_t passes = 400;
};

/// The first configuration with the minimum distance or, when there is none within the passes, the best one
/// seen, which may be the start.
struct RepulsionResult
{
    PointSet points;         ///< in the order of the start
    std::size_t passes = 0;  ///< that were made
    double min_distance = 0; ///< of all pairs of these points and their images on the torus, held ones too

    bool operator==(const RepulsionResult&) const = default;
};

/// The neighbourhood that one pass looks at: the points in the cells around a point's own, `reach` in each direction,
/// on a grid of cells_per_axis cells along each axis.
struct RepulsionPass
{
    double distance; ///< t: pairs that are closer are pushed apart
    double limit;    ///< of a point's movement
    std::uint32_t cells_per_axis;
    std::int32_t reach;
};

/// Cells are wide enough for t and for the distance of the closest pair of any set of so many points.
RepulsionPass repulsion_pass(const RepulsionRequest& request, std::size_t points, int dimension);

namespace reference {
/// `points` has at least one point.
RepulsionResult repel(const PointSet& points, const Domain& domain, const RepulsionRequest& request);
}

/// Pushes points apart by kernels/repulsion.cl, with the bytes of the reference.
class Repulsion : DeviceMethod<struct RepulsionState>
{
public:
    /// `work_group_size` 0: the default.
    explicit Repulsion(Device device, std::size_t work_group_size = 0);

    RepulsionResult repel(const PointSet& points, const Domain& domain, const RepulsionRequest& request);

    /// The memory that repel() takes on the torus.
    static DeviceMemory memory(int dimension, std::size_t points, const RepulsionRequest& request);
};

}
