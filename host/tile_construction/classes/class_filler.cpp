// Fills tori with points of several classes on a device, a batch a launch.
#include "host/tile_construction/classes/class_filling.hpp"

#include "host/device/needed_buffers.hpp"
#include "kernels/common/tiles/class_tiles.h"

#include <algorithm>

namespace poissonlab {
namespace {

/// On CPUs, work-items of a group run one after the other.
constexpr std::size_t cpu_group = 1, gpu_group = 32;

/// The most coordinates of a launch; larger batches are cut.
constexpr std::size_t most_coordinates = std::size_t{1} << 23;

struct ClassFillBuffers
{
    Buffer<std::uint32_t> wanted, parts;
    Buffer<double> pushed;
    Buffer<std::int32_t> points, moved, kept;                      ///< a coordinate each
    Buffer<std::uint32_t> classes;                                 ///< a point each
    Buffer<std::uint32_t> streams, held, targets, counts, reached; ///< a torus each

    NeededBuffers needed(std::size_t class_count, std::size_t part_count, std::size_t tori, std::size_t points_of_torus,
                         std::size_t axes)
    {
        const std::size_t all = tori * points_of_torus;
        return {{wanted, class_count * class_count},
                {pushed, class_count * class_count},
                {parts, part_count},
                {points, all * axes},
                {moved, all * axes},
                {kept, all * axes},
                {classes, all},
                {streams, tori},
                {held, tori},
                {targets, tori},
                {counts, tori},
                {reached, tori}};
    }
};

/// The most parts of distances that darts are thrown at, of any factor that is common.
constexpr std::size_t usual_parts = 1024;

class DeviceClassFiller final : public ClassTileFiller
{
public:
    DeviceClassFiller(const ClassFillSettings& settings, Device device, std::size_t work_group_size)
        : settings_(settings), device_(std::move(device))
    {
        work_group_size_ = work_group_size > 0 ? work_group_size : device_.info().type == "CPU" ? cpu_group : gpu_group;
    }

    std::vector<ClassFilledTorus> fill(const FillStage& stage, std::span<const ClassFillProblem> problems,
                                       std::uint32_t attempt) override
    {
        use_dimension(stage.regions.dimension);
        std::size_t most = 1;
        for (const ClassFillProblem& problem : problems)
            most = std::max(most, point_count(problem.held) + problem.active_points());
        capacity_ = most;
        const std::size_t batch = std::max<std::size_t>(1, most_coordinates / (most * axes_));
        std::vector<ClassFilledTorus> results;
        for (std::size_t i = 0; i < problems.size(); i += batch)
            fill_batch(stage, problems.subspan(i, std::min(batch, problems.size() - i)), attempt, results);
        return results;
    }

private:
    void use_dimension(int dimension)
    {
        if (axes_ == static_cast<std::size_t>(dimension)) return;
        axes_ = static_cast<std::size_t>(dimension);
        const KernelProgram program = kernel_program("class_tiles.cl", {{"DIMENSION", dimension}});
        throw_ = device_.kernel(program, "throw_class_tile_darts");
        push_ = device_.kernel(program, "push_class_tiles");
    }

    void fill_batch(const FillStage& stage, std::span<const ClassFillProblem> problems, std::uint32_t attempt,
                    std::vector<ClassFilledTorus>& results)
    {
        upload(problems);
        ClassFillBuffers& b = buffers_;
        const contract::class_tiles::ClassFilling filling = arguments(stage, attempt);
        const std::size_t items = problems.size() * work_group_size_;
        throw_.run(items, work_group_size_, filling, b.streams, b.wanted, b.parts, b.held, b.targets, b.classes,
                   b.points, b.counts);
        push_.run(items, work_group_size_, filling, b.wanted, b.pushed, b.held, b.targets, b.counts, b.classes,
                  b.points, b.moved, b.kept, b.reached);
        download(problems, results);
    }

    contract::class_tiles::ClassFilling arguments(const FillStage& stage, std::uint32_t attempt) const
    {
        const TileRegions& r = stage.regions;
        return {.tori = {.cells = stage.active.cells,
                         .regions = {r.width, r.pair_one, r.pair_sum, r.corner_one, r.corner_two, r.corner_three},
                         .capacity = static_cast<std::uint32_t>(capacity_),
                         .copies = 1,
                         .in_polygon = 0,
                         .keep_tiles = 0},
                .attempt = attempt,
                .stage = stage.number,
                .key_x = settings_.stream[0],
                .key_y = settings_.stream[1],
                .low = stage.active.low,
                .extent = stage.active.extent,
                .classes = static_cast<std::uint32_t>(settings_.classes()),
                .levels = static_cast<std::uint32_t>(settings_.parts.size()),
                .attempts = settings_.attempts,
                .passes = settings_.passes};
    }

    void upload(std::span<const ClassFillProblem> problems)
    {
        const std::size_t n = problems.size();
        std::vector<std::int32_t> points(n * axes_ * capacity_);
        std::vector<std::uint32_t> classes(n * capacity_), streams, held, targets;
        for (std::size_t i = 0; i < n; ++i) {
            const ClassFillProblem& problem = problems[i];
            std::size_t number = 0;
            std::int32_t* const to = points.data() + i * axes_ * capacity_;
            std::uint32_t* const own = classes.data() + i * capacity_;
            for (std::uint32_t of = 0; of < settings_.classes(); ++of)
                for (const TilePosition& point : problem.held[of]) {
                    for (std::size_t k = 0; k < axes_; ++k) to[k * capacity_ + number] = point[k];
                    own[number++] = of;
                }
            held.push_back(static_cast<std::uint32_t>(number));
            for (const std::uint32_t of : settings_.order) {
                std::fill_n(own + number, problem.active[of], of);
                number += problem.active[of];
            }
            targets.push_back(static_cast<std::uint32_t>(number));
            streams.push_back(problem.stream);
        }
        ClassFillBuffers& b = buffers_;
        reserve(device_, b.needed(settings_.classes(), settings_.parts.size(), n, capacity_, axes_));
        b.wanted.write(settings_.wanted);
        b.pushed.write(settings_.pushed);
        b.parts.write(settings_.parts);
        b.points.write(points);
        b.classes.write(classes);
        b.streams.write(streams);
        b.held.write(held);
        b.targets.write(targets);
    }

    void download(std::span<const ClassFillProblem> problems, std::vector<ClassFilledTorus>& results)
    {
        const std::size_t n = problems.size();
        const std::vector<std::uint32_t> counts = buffers_.counts.read(0, n), reached = buffers_.reached.read(0, n);
        const std::vector<std::int32_t> kept = buffers_.kept.read(0, n * axes_ * capacity_);
        for (std::size_t i = 0; i < n; ++i) {
            const ClassFillProblem& problem = problems[i];
            ClassFilledTorus& result = results.emplace_back();
            std::size_t number = point_count(problem.held);
            if (counts[i] < number + problem.active_points()) continue;
            result.part = reached[i];
            result.active.resize(settings_.classes());
            const std::int32_t* const from = kept.data() + i * axes_ * capacity_;
            for (const std::uint32_t of : settings_.order)
                for (std::uint32_t point = 0; point < problem.active[of]; ++point, ++number) {
                    TilePosition position{};
                    for (std::size_t k = 0; k < axes_; ++k) position[k] = from[k * capacity_ + number];
                    result.active[of].push_back(position);
                }
        }
    }

    ClassFillSettings settings_;
    Device device_;
    std::size_t work_group_size_ = 0, axes_ = 0, capacity_ = 0;
    Kernel throw_, push_;
    ClassFillBuffers buffers_;
};

}

std::unique_ptr<ClassTileFiller> make_class_tile_filler(const ClassFillSettings& settings, Device device,
                                                        std::size_t work_group_size)
{
    return std::make_unique<DeviceClassFiller>(settings, std::move(device), work_group_size);
}

DeviceMemory class_filling_memory(std::size_t classes, std::size_t tori, std::size_t points)
{
    constexpr std::size_t axes = 2; // classes are for tiles in the plane
    const std::size_t batch = std::min(tori, std::max<std::size_t>(1, most_coordinates / (points * axes)));
    return memory_of(ClassFillBuffers{}.needed(classes, usual_parts, batch, points, axes));
}

}
