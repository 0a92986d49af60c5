// Lloyd relaxation on the unit torus: every point moves to the centroid of its Voronoi cell, again and again.
//
// Dissertation, sections 4.2.4.3 and 6.5. Cells are exact, never rasterised.
#pragma once

#include "base/geometry/point_set.hpp"
#include "host/device/device.hpp"
#include "host/sampling/cells/domain.hpp"
#include "host/sampling/sampler.hpp"

#include <cstddef>
#include <vector>

namespace poissonlab {

struct LloydRequest
{
    std::size_t iterations = 0;
    double until_relative_radius = 2; ///< stop at the first iterate that has it; no set has more than 1
    bool keep_best = false;           ///< give the iterate of the largest relative radius, not the last one
};

struct LloydResult
{
    PointSet points;                         ///< in the order of the start
    std::vector<IterationRecord> iterations; ///< the start and every iterate
    std::size_t kept = 0;                    ///< the iterate that `points` is
};

/// In the domain, held points stay where they are, and movements end at forbidden regions. `points` has at
/// least one point.
namespace reference {
LloydResult relax(const PointSet& points, const Domain& domain, const LloydRequest& request);
}

/// Relaxes points by kernels/voronoi_2d.cl and voronoi_3d_*.cl. The bytes do not depend on the number of threads; they
/// are equal to the reference within rounding.
class LloydRelaxation
{
public:
    /// `work_group_size` 0: the default.
    explicit LloydRelaxation(Device device, std::size_t work_group_size = 0);

    LloydResult relax(const PointSet& points, const Domain& domain, const LloydRequest& request);

    /// The memory that relax() takes on the torus, and gives back.
    static DeviceMemory memory(int dimension, std::size_t points);

private:
    Device device_;
    std::size_t work_group_size_;
};

/// The request that the sampler's parameters make, without repulsion.
LloydRequest lloyd_request(const Parameters& parameters);

/// The sampler "lloyd": iterations, until_relative_radius, start, keep, repulsion.
SamplerSpec lloyd_sampler();

}
