// The sampler "sector-darts": Poisson disk sets that grow from their first point, dart beside dart.
//
// Dunbar and Humphreys, A spatial data structure for fast Poisson-disk sample generation, 2006; Lagae, Tile-Based
// Methods in Computer Graphics, 2007, section 6.13. Three ways to choose the next dart, all of them sequential by
// definition: which point is next depends on all points so far. Realizations are what runs side by side. A set ends
// when no point fits any more; before that, a part of the torus has none, so that no number of points can be asked for.
// The law is not that of dart throwing in any of them.
#pragma once

#include "base/geometry/point_set.hpp"
#include "base/random/random.hpp"
#include "host/device/needed_buffers.hpp"
#include "host/sampling/device_method.hpp"
#include "host/sampling/sampler.hpp"
#include "kernels/common/sectors/sector_darts.h"

#include <cstddef>
#include <vector>

namespace poissonlab {

enum class SectorVariant : std::uint32_t
{
    logarithmic = contract::sector_darts::LOGARITHMIC, ///< a uniform place in all that is left around points
    linear = contract::sector_darts::LINEAR,           ///< one point's neighbourhood after the other is filled
    boundary = contract::sector_darts::BOUNDARY,       ///< at the least distance of a point
};

struct SectorDartRequest
{
    double min_distance; ///< in (0, 0.125], so that neighbourhoods do not meet themselves
    SectorVariant variant;
};

/// Lengths in units, and sizes of buffers for one set.
contract::sector_darts::SectorRules sector_rules(const SectorDartRequest& request);

/// The most points that a set may have, nearly: those of boundary darts are densest.
std::size_t most_sector_darts(double min_distance);

namespace reference {
/// Points in dart order. Coordinates are multiples of 2^-32.
PointSet throw_sector_darts(const SectorDartRequest& request, const StreamKey& stream);
}

/// Throws the darts of several streams side by side, one work-item each, by kernels/sector_darts.cl, with the bytes of
/// the reference.
class SectorDarts : DeviceMethod<struct SectorDartBuffers>
{
public:
    explicit SectorDarts(Device device);

    /// One set for each stream; at most sets_at_once() of them.
    std::vector<PointSet> throw_darts(const SectorDartRequest& request, const std::vector<StreamKey>& streams);

    /// The number of sets that are made side by side.
    static std::size_t sets_at_once(const SectorDartRequest& request);

    /// The memory that throw_darts() takes: always that of sets_at_once().
    static DeviceMemory memory(const SectorDartRequest& request);

private:
    void grow(const contract::sector_darts::SectorRules& rules, std::vector<contract::sector_darts::GrowingSet>& sets);
};

/// Parameters: variant, min_distance.
SamplerSpec sector_dart_sampler();

}
