// Lloyd relaxation of several sets of few points in 2D, side by side.
#pragma once

#include "host/sampling/lloyd_relaxation.hpp"

#include <cstddef>
#include <vector>

namespace poissonlab {

/// Relaxes sets by kernels/lloyd_sets.cl, one work-item each: launches are few, and no thread waits for another.
class LloydSets
{
public:
    explicit LloydSets(Device device);

    /// The most sets of so many points that are relaxed side by side; 0: there are too many points in one.
    static std::size_t most_sets(std::size_t points);

    /// Are sets relaxed faster side by side than one after the other? Only on processors.
    static bool are_faster(const DeviceInfo& device, std::size_t sets, std::size_t points);

    /// The results that LloydRelaxation has for each, bit by bit. All sets have as many points, at least one.
    std::vector<LloydResult> relax(const std::vector<PointSet>& sets, std::size_t iterations);

    /// The memory that relax() takes, and gives back.
    static DeviceMemory memory(std::size_t sets, std::size_t points);

private:
    Device device_;
};

}
