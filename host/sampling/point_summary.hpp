// Sums and smallest values over points on a device. Runs summarize_points of kernels/relaxation.cl.
#pragma once

#include "host/device/needed_buffers.hpp"
#include "host/sampling/lloyd_iteration.hpp"

#include <cstddef>
#include <vector>

namespace poissonlab {

class PointSummary
{
public:
    /// Room for the summaries of so many iterates.
    PointSummary(Device device, int dimension, std::size_t points, std::size_t iterates = 1);

    static DeviceMemory memory(std::size_t points, std::size_t iterates = 1)
    {
        return memory_of(Buffers{}.needed(points, iterates));
    }

    /// Enqueues the summary of a value for each point. Sums are taken in the same order on every device.
    void add(const Buffer<double>& energies, const Buffer<double>& squared_near);

    /// Waits for the summaries that were added since the last call.
    std::vector<IterateMeasure> take();

    /// One summary, at once.
    IterateMeasure summarize(const Buffer<double>& energies, const Buffer<double>& squared_near)
    {
        add(energies, squared_near);
        return take().front();
    }

private:
    struct Buffers
    {
        Buffer<double> sums, smallest;

        NeededBuffers needed(std::size_t points, std::size_t iterates);
    };

    std::size_t points_;
    std::size_t added_ = 0;
    Buffers buffers_;
    Kernel summarize_;
};

}
