// Dart throwing on the unit torus, or in a region of the plane: to a number of points, or until no further point fits
// (saturation).
//
// Dissertation, section 4.2.4.1 and 6.3; maximal sets after Ebeida et al. 2012. Darts fall as a Poisson
// process in space and time; a dart becomes a point when no earlier point is nearer than the minimum
// distance. That is the textbook algorithm (random sequential addition): darts that fall on covered cells are
// simply not drawn.
#pragma once

#include "base/geometry/point_set.hpp"
#include "base/random/random.hpp"
#include "base/regions/fixed_region.hpp"
#include "host/sampling/darts/dart_request.hpp"
#include "host/sampling/darts/dart_settler.hpp"
#include "host/sampling/device_method.hpp"
#include "host/sampling/sampler.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace poissonlab {

/// Points in dart order (every prefix is a dart throwing of its own). Coordinates are multiples of 2^-32.
/// Fewer points than asked for: the set is saturated, no further point of that grid of coordinates fits.
namespace reference {
PointSet throw_darts(const DartThrowingRequest& request);

/// Throws darts with what the order of points follows from; D is the dimension of the request. It goes on to the end of
/// the batch in which the number of points is reached.
template <int D>
std::vector<OrderedDart<D>> ordered_darts(const DartThrowingRequest& request);
}

/// Throws darts by kernels/dart_throwing.cl and either way of DartSettling: every device finds the bytes of the
/// reference.
class DartThrower : DeviceMethod<DartBuffers>
{
public:
    /// `work_group_size` 0: the default. `settling` empty: the faster way for the device.
    explicit DartThrower(Device device, std::size_t work_group_size = 0, std::optional<DartSettling> settling = {});

    PointSet throw_darts(const DartThrowingRequest& request);

    /// Throws the darts of reference::ordered_darts().
    template <int D>
    std::vector<OrderedDart<D>> ordered_darts(const DartThrowingRequest& request);

    /// The memory that throw_darts() takes on a device, nearly: chance decides how many darts a batch has.
    static DeviceMemory memory(const DartThrowingRequest& request, const DeviceInfo& device);

private:
    DartSettling settling_;
};

/// The sampler "dart-throwing": relative_radius, or stop = "saturation" with min_distance.
SamplerSpec dart_throwing_sampler();

}
