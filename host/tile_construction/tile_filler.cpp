// Fills tori on a device, a batch a launch.
#include "host/tile_construction/tile_filling.hpp"

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

/// The most that the buffers of one launch may take; larger batches are cut.
constexpr std::uint64_t max_batch_bytes = std::uint64_t{256} << 20;

/// Less where a device has less: all buffers of a batch together take no more than one buffer may.
std::uint64_t batch_bytes(const DeviceInfo& device)
{
    return std::min({max_batch_bytes, device.global_memory_bytes / 4, device.max_allocation_bytes});
}

constexpr std::size_t lanes = 8;

/// The size of work-groups on CPUs, where work-items of a group run one after the other.
constexpr std::size_t default_work_group_size = 1;
constexpr std::size_t gpu_work_group_size = 32;

std::vector<std::int32_t> region_values(const TileRegions& r)
{
    return {r.width, r.pair_one, r.pair_sum, r.corner_one, r.corner_two, r.corner_three};
}

/// Half widths of the boxes in which Voronoi neighbours are looked for, one after the other; units.
std::vector<std::int32_t> voronoi_reaches(const FillSettings& settings)
{
    const std::vector<double> spacings =
        settings.dimension == 2 ? std::vector<double>{1.9, 3, 4.6} : std::vector<double>{2.1, 3.2};
    std::vector<std::int32_t> reaches;
    for (const double factor : spacings) {
        // A box is less than half of the torus, whose points are then all different.
        const double reach = std::min<double>(factor * settings.spacing, tile_units - 1);
        reaches.push_back(static_cast<std::int32_t>(reach));
    }
    return reaches;
}

/// The width, in spacings, by which a box is larger if its points are listed once for several iterations.
constexpr double list_slack = 0.5;

/// The words of a list of points, as in the kernel.
std::size_t list_words(int dimension) { return dimension == 2 ? 64 : 256; }

/// Elements of buffers that a torus takes.
struct TorusRoom
{
    std::size_t capacity; ///< points with their images, a multiple of `lanes`
    std::size_t lists;
};

TorusRoom torus_room(const FillShape& shape, int dimension)
{
    return {(shape.points * shape.images + lanes - 1) / lanes * lanes, shape.active * list_words(dimension)};
}

/// Tori that are filled at once.
std::size_t batch_size(const TorusRoom& room, int dimension, const DeviceInfo& device)
{
    const std::size_t bytes =
        room.capacity * static_cast<std::size_t>(dimension) * (3 * sizeof(std::int32_t) + sizeof(double)) +
        room.lists * sizeof(std::uint16_t);
    return std::max<std::size_t>(1, batch_bytes(device) / std::max<std::size_t>(1, bytes));
}

/// A shape in which all problems of a stage have room.
FillShape shape_of(const FillStage& stage, std::span<const FillProblem> problems, int dimension)
{
    FillShape shape{problems.size(), 0, 0, stage.is_one_tile ? std::size_t{1} << dimension : 1};
    for (const FillProblem& p : problems) {
        shape.points = std::max(shape.points, p.held.size() + p.active + p.surroundings);
        shape.active = std::max<std::size_t>(shape.active, p.active);
    }
    return shape;
}

class DeviceFiller final : public TileFiller
{
public:
    DeviceFiller(const FillSettings& settings, Device device, std::size_t work_group_size)
        : settings_(settings), device_(std::move(device)), reaches_(voronoi_reaches(settings))
    {
        work_group_size_ = work_group_size > 0            ? work_group_size
                           : device_.info().type == "CPU" ? default_work_group_size
                                                          : gpu_work_group_size;
        const std::vector<KernelValue> constants{{"DIMENSION", settings.dimension}};
        throw_ = device_.kernel(kernel_program("tile_darts.cl", constants), "throw_tile_darts");
        relax_ = device_.kernel(kernel_program("tile_relaxation.cl", constants), "relax_tiles");
        repel_ = device_.kernel(kernel_program("tile_relaxation.cl", constants), "repel_tiles");
        distances_ = device_.buffer<std::uint32_t>(settings.squared_distances.size());
        distances_.write(settings.squared_distances);
        reach_values_ = device_.buffer<std::int32_t>(reaches_.size());
        reach_values_.write(reaches_);
        region_values_ = device_.buffer<std::int32_t>(region_values({}).size());
    }

    std::vector<FilledTorus> fill(const FillStage& stage, std::span<const FillProblem> problems,
                                  std::uint32_t attempt) override
    {
        region_values_.write(region_values(stage.regions));
        const FillShape shape = shape_of(stage, problems, settings_.dimension);
        const TorusRoom room = torus_room(shape, settings_.dimension);
        copies_ = shape.images;
        max_active_ = shape.active;
        capacity_ = room.capacity;
        const std::size_t batch = batch_size(room, settings_.dimension, device_.info());
        std::vector<FilledTorus> results;
        for (std::size_t i = 0; i < problems.size(); i += batch) {
            fill_batch(stage, problems.subspan(i, std::min(batch, problems.size() - i)), attempt, results);
        }
        return results;
    }

private:
    std::size_t axes() const { return static_cast<std::size_t>(settings_.dimension); }

    void fill_batch(const FillStage& stage, std::span<const FillProblem> problems, std::uint32_t attempt,
                    std::vector<FilledTorus>& results)
    {
        upload(problems);
        throw_darts(stage.active, attempt, 2 * stage.number, settings_.attempts, active_targets_);
        const std::vector<std::uint32_t> active_ends = counts_.read(0, problems.size());
        const std::vector<std::int32_t> thrown = points_.read(0, problems.size() * axes() * capacity_);

        // Tori that could not be filled go no farther.
        std::vector<std::uint32_t> filled;
        for (std::size_t i = 0; i < problems.size(); ++i) {
            if (active_ends[i] == problems[i].held.size() + problems[i].active)
                filled.push_back(static_cast<std::uint32_t>(i));
        }
        groups_ = filled.size();
        problem_numbers_.write(filled);
        throw_darts(stage.surroundings, attempt, 2 * stage.number + 1, settings_.surrounding_attempts, all_targets_);
        relax(stage);
        if (settings_.repulsion_passes > 0) repel(stage);
        download(problems, active_ends, thrown, filled, results);
    }

    void upload(std::span<const FillProblem> problems)
    {
        const std::size_t n = problems.size();
        const std::size_t per_problem = axes() * capacity_;
        std::vector<std::int32_t> points(n * per_problem);
        std::vector<std::uint32_t> numbers(n), streams(n), held(n), active(n), active_targets(n), all_targets(n);
        for (std::size_t i = 0; i < n; ++i) {
            const FillProblem& problem = problems[i];
            put_held(problem.held, points.data() + i * per_problem);
            numbers[i] = static_cast<std::uint32_t>(i);
            streams[i] = problem.stream;
            held[i] = static_cast<std::uint32_t>(problem.held.size());
            active[i] = problem.active;
            active_targets[i] = held[i] + problem.active;
            all_targets[i] = active_targets[i] + problem.surroundings;
        }
        reserve(device_, points_, n * per_problem);
        reserve(device_, moved_, n * per_problem);
        reserve(device_, kept_, n * per_problem);
        reserve(device_, doubles_, n * per_problem);
        reserve(device_, lists_, std::max<std::size_t>(1, n * max_active_ * list_words(settings_.dimension)));
        for (Buffer<std::uint32_t>* buffer : {&problem_numbers_, &streams_, &held_, &active_, &active_targets_,
                                              &all_targets_, &counts_, &levels_, &squared_kept_})
            reserve(device_, *buffer, n);
        points_.write(points);
        problem_numbers_.write(numbers);
        streams_.write(streams);
        held_.write(held);
        counts_.write(held);
        active_.write(active);
        active_targets_.write(active_targets);
        all_targets_.write(all_targets);
        groups_ = n;
    }

    void put_held(const std::vector<TilePosition>& held, std::int32_t* points) const
    {
        for (std::size_t i = 0; i < held.size(); ++i) {
            for (std::size_t image = 0; image < copies_; ++image) {
                for (std::size_t k = 0; k < axes(); ++k) {
                    points[k * capacity_ + i * copies_ + image] =
                        wrapped(held[i][k] + static_cast<std::int32_t>(image >> k & 1) * tile_units);
                }
            }
        }
    }

    void throw_darts(const DartZone& zone, std::uint32_t attempt, std::uint32_t zone_number, std::uint32_t attempts,
                     const Buffer<std::uint32_t>& targets)
    {
        throw_.run(groups_ * work_group_size_, work_group_size_, problem_numbers_, streams_, attempt, zone_number,
                   settings_.stream[0], settings_.stream[1], static_cast<std::uint32_t>(capacity_),
                   static_cast<std::uint32_t>(copies_), region_values_, zone.cells, zone.low, zone.extent, distances_,
                   static_cast<std::uint32_t>(settings_.squared_distances.size()), attempts, targets, points_, counts_,
                   levels_);
    }

    void relax(const FillStage& stage)
    {
        relax_.run(groups_ * work_group_size_, work_group_size_, problem_numbers_,
                   static_cast<std::uint32_t>(capacity_), static_cast<std::uint32_t>(copies_), region_values_,
                   stage.active.cells, counts_, held_, active_, settings_.lloyd_iterations,
                   static_cast<std::uint32_t>(settings_.repulsion_passes > 0), settings_.wanted, reach_values_,
                   static_cast<std::uint32_t>(reaches_.size()),
                   static_cast<std::int32_t>(list_slack * settings_.spacing), settings_.spacing, lists_,
                   static_cast<std::uint32_t>(max_active_), points_, doubles_, moved_, kept_, squared_kept_);
    }

    void repel(const FillStage& stage)
    {
        repel_.run(groups_ * work_group_size_, work_group_size_, problem_numbers_,
                   static_cast<std::uint32_t>(capacity_), static_cast<std::uint32_t>(copies_), region_values_,
                   stage.active.cells, counts_, held_, active_, settings_.repulsion_passes, settings_.wanted,
                   settings_.repulsion_distance, points_, moved_, kept_, squared_kept_);
    }

    /// `count` points of a problem from number `first` on, `images` apart.
    std::vector<TilePosition> points_of(const std::vector<std::int32_t>& all, std::size_t problem, std::size_t first,
                                        std::size_t count, std::size_t images) const
    {
        std::vector<TilePosition> points(count);
        const std::int32_t* from = all.data() + problem * axes() * capacity_;
        for (std::size_t i = 0; i < count; ++i) {
            for (std::size_t k = 0; k < axes(); ++k) points[i][k] = from[k * capacity_ + (first + i) * images];
        }
        return points;
    }

    void download(std::span<const FillProblem> problems, const std::vector<std::uint32_t>& active_ends,
                  const std::vector<std::int32_t>& thrown, const std::vector<std::uint32_t>& filled,
                  std::vector<FilledTorus>& results)
    {
        const std::size_t n = problems.size();
        const std::size_t first_result = results.size();
        results.resize(first_result + n);
        for (std::size_t i = 0; i < n; ++i) {
            const std::size_t held = problems[i].held.size();
            results[first_result + i].thrown = points_of(thrown, i, held, active_ends[i] - held, copies_);
        }
        if (filled.empty()) return;
        const std::vector<std::uint32_t> ends = counts_.read(0, n);
        const std::vector<std::uint32_t> squared = squared_kept_.read(0, n);
        const std::vector<std::int32_t> kept = kept_.read(0, n * axes() * capacity_);
        const std::vector<std::int32_t> points = points_.read(0, n * axes() * capacity_);
        for (const std::uint32_t i : filled) {
            FilledTorus& result = results[first_result + i];
            const std::size_t held = problems[i].held.size();
            result.active = points_of(kept, i, held, problems[i].active, 1);
            result.surroundings = points_of(points, i, active_ends[i], ends[i] - active_ends[i], copies_);
            result.squared_min_distance = squared[i];
        }
    }

    FillSettings settings_;
    Device device_;
    std::vector<std::int32_t> reaches_;
    std::size_t work_group_size_;
    std::size_t capacity_ = 0;
    std::size_t max_active_ = 0;
    std::size_t copies_ = 1;
    std::size_t groups_ = 0;
    Kernel throw_, relax_, repel_;
    Buffer<std::uint32_t> distances_;
    Buffer<std::int32_t> reach_values_, region_values_;
    Buffer<std::int32_t> points_, moved_, kept_;
    Buffer<double> doubles_;
    Buffer<std::uint16_t> lists_;
    Buffer<std::uint32_t> problem_numbers_, streams_, held_, active_, active_targets_, all_targets_, counts_, levels_,
        squared_kept_;
};

}

std::unique_ptr<TileFiller> make_tile_filler(const FillSettings& settings, Device device, std::size_t work_group_size)
{
    return std::make_unique<DeviceFiller>(settings, std::move(device), work_group_size);
}

DeviceMemory filling_memory(const FillSettings& settings, std::span<const FillShape> stages, const DeviceInfo& device)
{
    // Buffers are kept from stage to stage, each as large as the largest needs it.
    std::size_t values = 0, lists = 1, most = 0;
    for (const FillShape& stage : stages) {
        const TorusRoom room = torus_room(stage, settings.dimension);
        const std::size_t tori = std::min(stage.tori, batch_size(room, settings.dimension, device));
        values = std::max(values, tori * room.capacity * static_cast<std::size_t>(settings.dimension));
        lists = std::max(lists, tori * room.lists);
        most = std::max(most, tori);
    }
    DeviceMemory memory;
    memory.add_buffer<std::uint32_t>(settings.squared_distances.size());
    memory.add_buffer<std::int32_t>(voronoi_reaches(settings).size());
    memory.add_buffer<std::int32_t>(region_values({}).size());
    for (int i = 0; i < 3; ++i) memory.add_buffer<std::int32_t>(values); // points, moved, kept
    memory.add_buffer<double>(values).add_buffer<std::uint16_t>(lists);
    for (int i = 0; i < 9; ++i) memory.add_buffer<std::uint32_t>(most); // numbers of each torus
    return memory;
}

}
