#include "host/large_sets/slab_plan.hpp"

#include "base/errors/errors.hpp"
#include "base/programs/memory_limit.hpp"
#include "host/device/device_memory.hpp"
#include "host/large_sets/scattered_points.hpp"
#include "host/sampling/slabs/slab_mover.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

/// The program itself takes so much, with an OpenCL device and its compiler, messages and pieces of the file.
constexpr std::uint64_t program_bytes = 250'000'000;

/// Bytes of a slab on a processor that are fast, as more of them stay in its caches, and how much thicker than what is
/// around it a slab is, for that to be a small part of the work.
constexpr std::uint64_t fast_slab_bytes = 64'000'000;
constexpr std::uint32_t least_thickness = 8;

constexpr std::uint64_t message_bytes_per_point = 32;

/// Points of the set that are in so many of the grid's layers, if they are spread evenly.
std::uint64_t points_in(std::uint64_t layers, const SlabMethod& method, const SlabTask& task)
{
    const std::uint64_t all = method.cells_per_axis();
    return static_cast<std::uint64_t>(static_cast<double>(task.points) * static_cast<double>(std::min(layers, all)) /
                                      static_cast<double>(all));
}

/// The device memory of the thickest slab.
DeviceMemory slab_memory(const SlabMethod& method, const SlabTask& task, std::uint32_t slabs)
{
    const std::uint32_t thickest = (method.cells_per_axis() + slabs - 1) / slabs;
    const GridPart part = layers_of_grid(method.cells_per_axis(), task.dimension, 0, thickest, method.layers_around());
    const std::uint64_t layers = thickest + std::uint64_t{2} * method.layers_around();
    return SlabMover::memory(method, task.dimension, points_in(layers, method, task), part);
}

/// Layers around slabs are doubled where cells reach farther, which those of random points do nearly always.
constexpr std::uint64_t layers_around_factor = 2;

/// The host's memory of a process: the points before and after a step, those around its slabs, which come in messages
/// as well, those of a slab that come back from the device, and what writing the file takes.
std::uint64_t host_bytes(const SlabMethod& method, const SlabTask& task, std::uint32_t slabs)
{
    const std::uint64_t of_point = SlabPoints::bytes_per_point(task.dimension);
    const std::uint64_t own = task.points / task.processes;
    const std::uint64_t in_slab = points_in((method.cells_per_axis() + slabs - 1) / slabs, method, task);
    const std::uint64_t read_back = 2 * of_point + sizeof(double); // displacements, distances and moved points
    const std::uint64_t kept = task.keeps_best ? own * of_point : 0;
    const std::uint64_t start = task.shares_start ? 0 : task.points * of_point;
    const std::uint64_t slabs_here = slabs / task.processes;
    const std::uint64_t around =
        slabs_here * points_in(2 * layers_around_factor * method.layers_around(), method, task);
    const std::uint64_t steps =
        2 * own * of_point + in_slab * read_back + around * (2 * of_point + message_bytes_per_point);
    const std::uint64_t writing = own * (of_point + scattered_bytes_per_point);
    return kept + std::max({steps, writing, own * of_point + start});
}

/// Kernels number grid cells by 31 bits. Throws InputError where there are more, with the largest set that has fewer.
void check_cells(const SlabMethod& method, const SlabTask& task)
{
    const double cells = std::pow(method.cells_per_axis(), task.dimension);
    if (cells < 0x1p31) return;
    throw InputError(fmt::format("--points {}: at most {:.3g}, whose grid has 2^31 cells", task.points,
                                 std::floor(static_cast<double>(task.points) * 0x1p31 / cells)));
}

/// Throws InputError where the machine has less, with the largest set that it has room for.
void check_process_memory(const SlabTask& task, std::uint64_t needed)
{
    const std::uint64_t limit = memory_limit(task.processes_here);
    if (needed <= limit) return;
    const double part =
        static_cast<double>(limit - std::min(limit, program_bytes)) / static_cast<double>(needed - program_bytes);
    throw InputError(fmt::format(
        "--points {}: takes {} in each process, which may have {}: {:.3g} fit, and more in more "
        "processes, on other machines",
        task.points, bytes_text(needed), bytes_text(limit), std::floor(part * static_cast<double>(task.points))));
}

}

SlabPlan plan_slabs(const SlabMethod& method, const SlabTask& task, const DeviceInfo& device)
{
    check_cells(method, task);
    // A processor takes the host's memory, which check_process_memory() divides between processes.
    const DeviceInfo share = device.type == "CPU" ? device : share_of(device, static_cast<int>(task.processes_here));
    for (std::uint32_t slabs = task.least_slabs;; slabs += (slabs + 7) / 8) {
        const DeviceMemory memory = slab_memory(method, task, slabs * task.processes);
        const bool is_thick =
            method.cells_per_axis() / (slabs * task.processes) > least_thickness * method.layers_around();
        const bool is_slow = device.type == "CPU" && memory.total > fast_slab_bytes && is_thick;
        if (!is_slow && memory.total <= task.most_slab_bytes && fits(memory, share)) {
            const std::uint64_t on_device = device.type == "CPU" ? memory.total : 0; // which is the host's
            const SlabPlan plan{slabs, memory.total,
                                program_bytes + on_device + host_bytes(method, task, slabs * task.processes)};
            check_process_memory(task, plan.process_bytes);
            return plan;
        }
        if (slabs * task.processes < method.cells_per_axis()) continue;
        check_fits("a layer of grid cells", memory, share);
        throw InputError(fmt::format("--memory {:.3g}: must be at least {:.3g} here",
                                     static_cast<double>(task.most_slab_bytes) * 1e-9,
                                     std::ceil(static_cast<double>(memory.total) * 1e-6) * 1e-3));
    }
}

}
