// Dart throwing by Voronoi cells: darts fall only where there is room, into what each point's disk leaves of its cell.
//
// Jones, Efficient generation of Poisson-disk sampling patterns, journal of graphics tools 11(2), 2006; dissertation,
// section 6.12. The law is that of dart throwing. Unlike there, the square is a torus, and darts fall in batches: many
// are uniform in the area that is free before the batch, one after the other, and those that are too near to an earlier
// one are rejected, as dart throwing does. Areas are integers, so that sums of them are exact. While most of the torus
// is free, darts fall anywhere.
#pragma once

#include "host/sampling/dart_throwing.hpp"
#include "kernels/common/darts/voronoi_darts.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace poissonlab {

/// The grid for a minimum distance in (0, 1].
contract::voronoi_darts::Torus voronoi_dart_torus(double min_distance);

/// The cells around a cell by their gap to it, then by rows; itself first.
std::vector<contract::voronoi_darts::Offset> offsets_by_gap();

/// The number of darts in a batch, and where they fall; the same for both engines.
class VoronoiDartBatches
{
public:
    explicit VoronoiDartBatches(const contract::voronoi_darts::Torus& torus) : grid_size_(torus.grid_size) {}

    /// Should the free area be measured, or may the next darts fall anywhere?
    bool measures() const { return measures_; }

    /// The darts of a batch that fall anywhere.
    std::uint32_t darts_anywhere() const;

    /// The darts of a batch that fall into the free area of so many sites.
    static std::uint32_t darts_for(std::size_t sites);

    /// Is told what came of a batch. False where there is no room for more: rounding takes the last places, so that a
    /// batch in free area of which no dart is accepted is the last one.
    bool goes_on(std::uint32_t darts, std::size_t accepted, bool fell_anywhere);

private:
    std::uint32_t grid_size_;
    bool measures_ = false;
};

/// Points in dart order. Coordinates are multiples of 2^-32. Fewer points than asked for: a circle of the minimum
/// distance, and of some units of 2^-32 more, has a point in it wherever it lies.
namespace reference {
PointSet throw_voronoi_darts(const DartThrowingRequest& request);
}

/// Throws darts by kernels/voronoi_darts.cl: every device finds the bytes of the reference.
class VoronoiDarts : DeviceMethod<struct VoronoiDartBuffers>
{
public:
    /// `work_group_size` 0: the default.
    explicit VoronoiDarts(Device device, std::size_t work_group_size = 0);

    PointSet throw_darts(const DartThrowingRequest& request);

    /// The memory that throw_darts() takes, nearly, on any device.
    static DeviceMemory memory(const DartThrowingRequest& request, const DeviceInfo&);
};

/// The sampler "voronoi-darts": relative_radius, or stop = "saturation" with min_distance.
SamplerSpec voronoi_dart_sampler();

}
