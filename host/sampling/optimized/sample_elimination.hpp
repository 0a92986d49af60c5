// Sample elimination: of many points, the one that has the others nearest is removed, again and again.
//
// Yuksel, Sample elimination for generating Poisson disk sample sets, Computer Graphics Forum 34(2), 2015. A pair of
// points at a distance d weighs (1 - d / d_max)^8, where d_max is the minimum distance of the densest packing of as
// many points as are kept; pairs nearer than d_min weigh no more than at d_min. The order, too: elimination from n to n
// / 2 points puts those that are removed behind those that are kept, the first one last, and so on with these, so that
// every prefix is a set that elimination would keep, or nearly.
//
// Weights are integers here, so that sums do not depend on their order. Distances are the shortest ones on the torus;
// images farther away weigh nothing, which matters for a handful of points only.
#pragma once

#include "base/geometry/point_set.hpp"
#include "host/sampling/device_method.hpp"
#include "host/sampling/sampler.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace poissonlab {

/// The distances between which weights vary; unit lengths.
struct EliminationReach
{
    double most = 0;  ///< d_max
    double least = 0; ///< d_min
};

/// These reaches are those for keeping so many of so many points: section 3.1 of the paper, with beta = 0.65 and gamma
/// = 1.5.
EliminationReach elimination_reach(std::size_t kept, std::size_t points, int dimension);

/// The numbers of the first `count` points of a set that are removed, in that order. Coordinates count to 2^-32.
using RemovalOrder =
    std::function<std::vector<std::uint32_t>(const PointSet&, const EliminationReach&, std::size_t count)>;

/// The points of a set that are kept, in progressive order. `area` is that of what they lie in, in space its
/// volume.
PointSet eliminate(const PointSet& points, std::size_t kept, const RemovalOrder& removal_order, double area = 1);

namespace reference {
/// A point in reach of another, and what the pair weighs.
struct Partner
{
    std::uint32_t point;
    std::uint64_t weight;
};

/// The order in which the heaviest point goes, again and again, of points with these partners.
std::vector<std::uint32_t> heaviest_first(const std::vector<std::vector<Partner>>& partners, std::size_t count,
                                          std::span<const std::uint32_t> factors);

/// Finds the order of removal by a heap.
std::vector<std::uint32_t> removal_order(const PointSet& points, const EliminationReach& reach, std::size_t count);

/// Finds the order of removal where the weights of each point's pairs, for that point alone, are multiplied by a factor
/// in units of 1 / FACTOR_UNITS; none: by 1.
std::vector<std::uint32_t> factored_removal_order(const PointSet& points, const EliminationReach& reach,
                                                  std::size_t count, std::span<const std::uint32_t> factors);
}

/// Returns the ids of the `count` heaviest removed candidates, the heaviest first, equal ones by their ids. Kernels
/// mark a candidate as removed by the one's complement of its weight.
std::vector<std::uint32_t> heaviest_removed(const std::vector<std::int64_t>& weights,
                                            const std::vector<std::uint32_t>& ids, std::size_t count);

/// Finds the order of removal by kernels/sample_elimination.cl: every device finds that of the reference.
class SampleElimination : DeviceMethod<struct EliminationBuffers>
{
public:
    /// `work_group_size` 0: the default.
    explicit SampleElimination(Device device, std::size_t work_group_size = 0);

    std::vector<std::uint32_t> removal_order(const PointSet& points, const EliminationReach& reach, std::size_t count,
                                             std::span<const std::uint32_t> factors = {});

    /// The memory that eliminate() takes, where points lie in an area of so much, and have factors or not.
    static DeviceMemory memory(int dimension, std::size_t points, std::size_t kept, double area = 1,
                               bool has_factors = false);
};

/// The sampler "sample-elimination": candidates.
SamplerSpec sample_elimination_sampler();

}
