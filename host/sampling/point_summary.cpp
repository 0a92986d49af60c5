#include "host/sampling/point_summary.hpp"

#include "kernels/common/lloyd_sets.h"

#include <algorithm>
#include <limits>

namespace poissonlab {
namespace {

/// Points that one work-item of summarize_points owns.
constexpr std::uint32_t points_of_item = contract::lloyd_sets::SUMMARY_RUN;

std::size_t items_of(std::size_t points) { return (points + points_of_item - 1) / points_of_item; }

}

NeededBuffers PointSummary::Buffers::needed(std::size_t points, std::size_t iterates)
{
    return {{sums, items_of(points) * iterates}, {smallest, items_of(points) * iterates}};
}

PointSummary::PointSummary(Device device, int dimension, std::size_t points, std::size_t iterates)
    : points_(points),
      summarize_(device.kernel(kernel_program("relaxation.cl", {{"DIMENSION", dimension}, doubles_of(device)}),
                               "summarize_points"))
{
    reserve(device, buffers_.needed(points, iterates));
}

void PointSummary::add(const Buffer<double>& energies, const Buffer<double>& squared_near)
{
    const std::size_t items = items_of(points_);
    summarize_.run(items, 1, energies, squared_near, static_cast<std::uint32_t>(points_), points_of_item,
                   static_cast<std::uint32_t>(items * added_), buffers_.sums, buffers_.smallest);
    ++added_;
}

std::vector<IterateMeasure> PointSummary::take()
{
    const std::size_t items = items_of(points_);
    const std::vector<double> sums = buffers_.sums.read(0, items * added_);
    const std::vector<double> smallest = buffers_.smallest.read(0, items * added_);
    std::vector<IterateMeasure> measures(added_, {0, std::numeric_limits<double>::infinity()});
    for (std::size_t i = 0; i < items * added_; ++i) {
        IterateMeasure& measure = measures[i / items];
        measure.energy += sums[i];
        measure.squared_near = std::min(measure.squared_near, smallest[i]);
    }
    added_ = 0;
    return measures;
}

}
