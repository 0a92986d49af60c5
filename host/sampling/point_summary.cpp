#include "host/sampling/point_summary.hpp"

#include <algorithm>
#include <limits>

namespace poissonlab {
namespace {

/// Points that one work-item of summarize_points owns.
constexpr std::uint32_t points_of_item = 256;

std::size_t items_of(std::size_t points) { return (points + points_of_item - 1) / points_of_item; }

}

NeededBuffers PointSummary::Buffers::needed(std::size_t points)
{
    return {{sums, items_of(points)}, {smallest, items_of(points)}};
}

PointSummary::PointSummary(Device device, int dimension, std::size_t points)
    : points_(points),
      summarize_(device.kernel(kernel_program("relaxation.cl", {{"DIMENSION", dimension}}), "summarize_points"))
{
    reserve(device, buffers_.needed(points));
}

IterateMeasure PointSummary::summarize(const Buffer<double>& energies, const Buffer<double>& squared_near)
{
    const std::size_t items = items_of(points_);
    summarize_.run(items, 1, energies, squared_near, static_cast<std::uint32_t>(points_), points_of_item, buffers_.sums,
                   buffers_.smallest);
    IterateMeasure measure{0, std::numeric_limits<double>::infinity()};
    for (const double sum : buffers_.sums.read(0, items)) measure.energy += sum;
    for (const double near : buffers_.smallest.read(0, items))
        measure.squared_near = std::min(measure.squared_near, near);
    return measure;
}

}
