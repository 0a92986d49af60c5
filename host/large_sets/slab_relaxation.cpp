#include "host/large_sets/slab_relaxation.hpp"

#include "base/errors/errors.hpp"
#include "base/programs/interrupt.hpp"
#include "base/programs/memory_limit.hpp"
#include "host/device/device_memory.hpp"
#include "host/sampling/baselines.hpp"
#include "host/sampling/optimized/gaussian_blue_noise.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

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

SlabRelaxation::SlabRelaxation(Device device, int dimension, std::uint64_t points, std::unique_ptr<SlabMethod> method,
                               std::uint32_t slabs, Crew& crew)
    : dimension_(dimension), count_(points), mover_(std::move(device), dimension, std::move(method)),
      division_(mover_.method().cells_per_axis(), dimension, slabs * static_cast<std::uint32_t>(crew.size())),
      crew_(crew), around_(mover_.method().layers_around()),
      points_(std::make_unique<SlabPoints>(division_, crew, points)),
      moved_(std::make_unique<SlabPoints>(division_, crew, points))
{}

/// The least of what all processes have; 0 or more.
double SlabRelaxation::least_of_all(double value)
{
    std::vector<std::uint64_t> bits(static_cast<std::size_t>(crew_.size()));
    bits[static_cast<std::size_t>(crew_.rank())] = std::bit_cast<std::uint64_t>(value);
    return std::bit_cast<double>(std::ranges::min(crew_.sum(bits))); // bits are in the order of the numbers
}

bool SlabRelaxation::move_slabs(bool& is_known, double& squared_near)
{
    const auto axes = static_cast<std::size_t>(dimension_);
    return crew_.together([&] {
        moved_->clear();
        for (std::uint32_t slab = points_->first_slab(); slab < points_->end_slab() && is_known; ++slab) {
            stop_if_interrupted();
            if (points_->own(slab).size() == 0) continue;
            const SlabMover::Moved* step =
                mover_.move(division_.part(slab, around_), points_->own(slab), points_->around(slab));
            is_known = step != nullptr;
            if (!is_known) break;
            squared_near = std::min(squared_near, step->squared_near);
            for (std::size_t i = 0; i < step->points.size(); ++i)
                moved_->put(std::span(step->points.coordinates).subspan(i * axes, axes), step->points.ids[i]);
        }
    });
}

/// Fills `moved_` and `squared_near_`.
bool SlabRelaxation::make_step()
{
    for (;; around_ *= 2) {
        bool is_known = true;
        double squared_near = std::numeric_limits<double>::infinity();
        if (!points_->fetch_around(around_) || !move_slabs(is_known, squared_near)) return false;
        const std::uint64_t unknown = crew_.sum({is_known ? 0u : 1u}).front();
        if (!moved_->settle()) return false;
        if (unknown > 0) continue;
        squared_near_ = least_of_all(squared_near);
        return true;
    }
}

bool SlabRelaxation::run(const LloydRequest& request, const OnIteration& on_iteration)
{
    IterationCourse course(count_, dimension_, request);
    std::optional<SlabPoints> best;
    for (;;) {
        if (!make_step()) return false;
        const auto now = course.add({0, squared_near_});
        const bool is_noted = crew_.together([&] {
            on_iteration(course.iterations().size() - 1, course.iterations().back().relative_radius);
            if (now.is_kept && request.keep_best) best.emplace(*points_);
        });
        if (!is_noted) return false;
        if (now.is_last) break;
        std::swap(points_, moved_);
    }
    kept_ = course.kept();
    relative_radius_ = course.iterations()[kept_].relative_radius;
    if (best) points_ = std::make_unique<SlabPoints>(std::move(*best));
    moved_.reset();
    return true;
}

namespace {

/// Points that a process makes and sends at a time.
constexpr std::uint64_t points_a_turn = std::uint64_t{1} << 18;

}

bool SlabStart::make()
{
    points_ = request_.points;
    if (shares()) return true;
    const bool is_made = crew_.together([&] {
        if (!crew_.leads()) return;
        set_ = choice_.spec->create(choice_.parameters, request_, place_.engine, place_.device)->sample(0);
        points_ = set_.size();
    });
    if (is_made) points_ = std::stoull(crew_.from_leader(std::to_string(points_)));
    return is_made;
}

std::vector<double> SlabStart::piece(std::uint64_t first, std::uint64_t end) const
{
    if (shares())
        return random_points_from(first, static_cast<std::size_t>(end - first), request_.dimension, request_.seed, 0);
    const auto axes = static_cast<std::uint64_t>(request_.dimension);
    const double* const all = set_.coordinates.data();
    return {all + first * axes, all + end * axes};
}

bool SlabStart::put_into(SlabPoints& slabs)
{
    const auto axes = static_cast<std::size_t>(request_.dimension);
    const std::uint64_t makers = shares() ? static_cast<std::uint64_t>(crew_.size()) : 1;
    const auto rank = static_cast<std::uint64_t>(crew_.rank());
    for (std::uint64_t turn = 0; turn < points_; turn += makers * points_a_turn) {
        const bool is_put = crew_.together([&] {
            stop_if_interrupted();
            if (rank >= makers) return;
            const std::uint64_t first = std::min(points_, turn + rank * points_a_turn);
            const std::vector<double> coordinates = piece(first, std::min(points_, first + points_a_turn));
            for (std::size_t i = 0; i * axes < coordinates.size(); ++i)
                slabs.put(std::span(coordinates).subspan(i * axes, axes), static_cast<std::uint32_t>(first + i));
        });
        if (!is_put || !slabs.settle()) return false;
    }
    set_ = {};
    return true;
}

bool put_parts(const SlabPoints& coarse, std::uint64_t coarse_points, SlabPoints& fine, std::uint64_t points,
               int dimension, Crew& crew)
{
    const auto axes = static_cast<std::size_t>(dimension);
    const auto put_corner = [&](std::size_t corner, const NumberedPoints& own) {
        for (std::size_t i = 0; i < own.size(); ++i) {
            const std::uint64_t id = corner * coarse_points + own.ids[i];
            if (id >= points) continue;
            const auto part = split_place(std::span(own.coordinates).subspan(i * axes, axes), corner, coarse_points);
            fine.put(std::span(part).first(axes), static_cast<std::uint32_t>(id));
        }
    };
    for (std::size_t corner = 0; corner >> axes == 0; ++corner) {
        const bool is_put = crew.together([&] {
            stop_if_interrupted();
            for (std::uint32_t slab = coarse.first_slab(); slab < coarse.end_slab(); ++slab)
                put_corner(corner, coarse.own(slab));
        });
        if (!is_put || !fine.settle()) return false;
    }
    return true;
}

}
