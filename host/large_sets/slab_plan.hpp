// How a set is divided into slabs, and the memory that this takes: said and checked before any work.
#pragma once

#include "host/device/device.hpp"
#include "host/sampling/slabs/slab_method.hpp"

#include <cstdint>

namespace poissonlab {

/// The set that is to be relaxed, and by how many processes.
struct SlabTask
{
    int dimension = 2;
    std::uint64_t points = 0;
    std::uint32_t processes = 1;
    std::uint32_t processes_here = 1;  ///< on this machine, which share its device
    std::uint32_t least_slabs = 1;     ///< of each process, which all have as many
    std::uint64_t most_slab_bytes = 0; ///< that a slab may take on the device
    bool keeps_best = false;           ///< has a copy of the best iterate
    bool shares_start = true;          ///< else the first process has it as a whole
};

struct SlabPlan
{
    std::uint32_t slabs = 1;         ///< of each process
    std::uint64_t slab_bytes = 0;    ///< on the device
    std::uint64_t process_bytes = 0; ///< in all, the most that a process takes where points are spread evenly
};

/// Chooses as few slabs as fit in memory, or, on processors, some more, which are faster. Throws InputError, about the
/// options --memory and --points, where no number of slabs fits, or where processes have not the memory that they need,
/// with the largest set that would fit.
SlabPlan plan_slabs(const SlabMethod& method, const SlabTask& task, const DeviceInfo& device);

}
