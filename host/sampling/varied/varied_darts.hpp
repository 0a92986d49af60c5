// Dart throwing with distances that vary from place to place, in a region: to a number of points, or until
// no further one fits; or relaxation, where all distances shrink until so many points fit.
//
// Mitchell, Rand, Ebeida, Bajaj, Variable radii Poisson-disk sampling, CCCG 2012, where the smaller distance of two
// points is kept ("smaller-disks"); or the mean of both, so that disks of half the distance around points do not
// overlap. Darts fall with a density of 1 / distance^2, so that every prefix is as dense everywhere as the distances
// say. They fall into cells that may have room: the whole region at first, and, each time that so many darts of a point
// failed, cells of half the size that no single point covers. No place without a point near it is ever left out, and
// where no cell is left, none is there: the set is saturated, proven by whole numbers down to single positions.
//
// McCool and Fiume 1992 for relaxation, see host/sampling/relaxation_dart_throwing.hpp.
#pragma once

#include "base/random/random.hpp"
#include "base/regions/distance_field.hpp"
#include "host/sampling/device_method.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace poissonlab {

struct VariedDartRequest
{
    std::shared_ptr<const DistanceField> field;
    std::shared_ptr<const FixedRegion> region;
    bool is_mean = false; ///< the mean of both distances is kept, else the smaller one
    double slope = 0;     ///< of distances, no less than the largest one on any way between two places; may be infinite
    std::optional<std::size_t> points; ///< stop at so many points; empty: at saturation
    std::size_t expected = 0;          ///< points, nearly: for memory and speed alone
    std::uint32_t attempts = 0;        ///< of relaxation: darts that fail in a row before distances shrink; 0: never
    double factor = 0.99;              ///< which they are multiplied by then
    StreamKey stream{};
};

struct VariedDarts
{
    std::vector<TorusPoint<2>> points; ///< in dart order
    bool is_full = false;              ///< no further point fits, proven
    double scale = 1;                  ///< of relaxation: what all distances were multiplied by in the end

    bool operator==(const VariedDarts&) const = default;
};

namespace reference {
VariedDarts throw_varied_darts(const VariedDartRequest& request);
}

/// Throws darts by kernels/varied_darts.cl: every device finds the bytes of the reference.
class VariedDartThrower : DeviceMethod<struct VariedDartBuffers>
{
public:
    /// `work_group_size` 0: the default.
    explicit VariedDartThrower(Device device, std::size_t work_group_size = 0);

    VariedDarts throw_darts(const VariedDartRequest& request);

    /// The memory that throw_darts() takes, nearly: chance decides how many cells have room.
    static DeviceMemory memory(const VariedDartRequest& request);
};

}
