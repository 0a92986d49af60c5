// Sums and smallest values over points on a device. Runs summarize_points of kernels/relaxation.cl.
#pragma once

#include "host/device/needed_buffers.hpp"
#include "host/sampling/lloyd_iteration.hpp"

#include <cstddef>

namespace poissonlab {

class PointSummary
{
public:
    PointSummary(Device device, int dimension, std::size_t points);

    static DeviceMemory memory(std::size_t points) { return memory_of(Buffers{}.needed(points)); }

    /// The summary of a value for each point. Sums are taken in the same order on every device.
    IterateMeasure summarize(const Buffer<double>& energies, const Buffer<double>& squared_near);

private:
    struct Buffers
    {
        Buffer<double> sums, smallest;

        NeededBuffers needed(std::size_t points);
    };

    std::size_t points_;
    Buffers buffers_;
    Kernel summarize_;
};

}
