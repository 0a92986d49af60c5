// Fills tori on a device, a batch a launch.
#include "host/tile_construction/filling/tile_filling.hpp"

#include "host/device/needed_buffers.hpp"
#include "kernels/common/tiles/tile_filling.h"
#include "kernels/common/vectors.h"
#include "tiles/poisson/tile_moments.hpp"

#include <algorithm>

namespace poissonlab {
namespace {

/// The most that the buffers of one launch may take; larger batches are cut.
constexpr std::uint64_t max_batch_bytes = std::uint64_t{256} << 20;

/// Less where a device has less: all buffers of a batch together take no more than one buffer may.
std::uint64_t batch_bytes(const DeviceInfo& device)
{
    return std::min({max_batch_bytes, device.global_memory_bytes / 4, device.max_allocation_bytes});
}

/// The size of work-groups on CPUs: there, work-items of a group run one after the other.
constexpr std::size_t cpu_work_group_size = 1;
constexpr std::size_t gpu_work_group_size = 32;

contract::tile_filling::Regions shared(const TileRegions& r)
{
    return {r.width, r.pair_one, r.pair_sum, r.corner_one, r.corner_two, r.corner_three};
}

static_assert(tile_units == 1 << contract::tile_filling::TILE_BITS);

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

/// Half the width, in spacings, of the box whose points are listed for each; in 2D, the radius of the disk: less than
/// of the first box, as the few cells that need more are looked for in boxes.
double list_reach(int dimension) { return dimension == 2 ? 1.7 : 2.1; }

/// The length, in spacings, by which lists reach beyond list_reach(), so that they stand for several iterations.
double list_slack(int dimension) { return dimension == 2 ? 0.35 : 0.5; }

/// Elements of buffers that a torus takes.
struct TorusRoom
{
    std::size_t capacity; ///< points with their images, as many as are read at once
    std::size_t lists;
};

std::size_t in_whole(std::size_t vector, std::size_t count) { return (count + vector - 1) / vector * vector; }

TorusRoom torus_room(const FillShape& shape, int dimension)
{
    // Kernels read points 32 at a time, and lists of 8 points.
    constexpr std::size_t lanes = contract::vectors::LANES;
    return {in_whole(4 * lanes, shape.points * shape.images),
            in_whole(lanes, shape.moving) * contract::tile_filling::LIST_WORDS(dimension)};
}

/// Tori that are filled at once.
std::size_t batch_size(const TorusRoom& room, int dimension, const DeviceInfo& device)
{
    const std::size_t bytes = room.capacity * static_cast<std::size_t>(dimension) *
                                  (3 * sizeof(std::int32_t) + sizeof(std::int16_t) + sizeof(double)) +
                              room.lists * sizeof(std::uint16_t);
    return std::max<std::size_t>(1, batch_bytes(device) / std::max<std::size_t>(1, bytes));
}

/// A shape in which all problems of a stage have room.
FillShape shape_of(const FillStage& stage, std::span<const FillProblem> problems, int dimension)
{
    FillShape shape{problems.size(), 0, 0, stage.is_one_tile ? std::size_t{1} << dimension : 1};
    for (const FillProblem& p : problems) {
        shape.points = std::max(shape.points, p.held.size() + p.active + p.surroundings);
        shape.moving = std::max<std::size_t>(shape.moving, p.active + (stage.surroundings_move ? p.surroundings : 0));
    }
    return shape;
}

struct FillBuffers
{
    Buffer<std::uint32_t> distances;
    Buffer<std::int32_t> points, moved, kept; ///< a coordinate each
    Buffer<std::int16_t> coarse;              ///< a coordinate each
    Buffer<double> doubles;
    Buffer<std::uint16_t> lists;
    Buffer<std::uint8_t> exponents;
    Buffer<std::int64_t> moments; ///< a torus' after the other
    Buffer<std::uint32_t> problem_numbers, streams, held, active, active_targets, all_targets, counts, levels,
        squared_kept; ///< a torus each

    NeededBuffers needed(const FillSettings& settings, std::size_t tori, std::size_t coordinates, std::size_t listed)
    {
        NeededBuffers all{{distances, settings.squared_distances.size()},
                          {points, coordinates},
                          {moved, coordinates},
                          {kept, coordinates},
                          {coarse, coordinates},
                          {doubles, coordinates},
                          {lists, listed},
                          {exponents, contract::tile_filling::MAX_MONOMIALS * std::size_t{3}},
                          {moments, tori * contract::tile_filling::MAX_MONOMIALS}};
        for (Buffer<std::uint32_t>* buffer : {&problem_numbers, &streams, &held, &active, &active_targets, &all_targets,
                                              &counts, &levels, &squared_kept})
            all.emplace_back(*buffer, tori);
        return all;
    }
};

class DeviceFiller final : public TileFiller
{
public:
    DeviceFiller(const FillSettings& settings, Device device, std::size_t work_group_size)
        : settings_(settings), device_(std::move(device)), reaches_(voronoi_reaches(settings))
    {
        work_group_size_ = work_group_size > 0            ? work_group_size
                           : device_.info().type == "CPU" ? cpu_work_group_size
                                                          : gpu_work_group_size;
        const std::vector<KernelValue> constants{{"DIMENSION", settings.dimension}};
        throw_ = device_.kernel(kernel_program("tile_darts.cl", constants), "throw_tile_darts");
        relax_ = device_.kernel(kernel_program("tile_relaxation.cl", constants), "relax_tiles");
        repel_ = device_.kernel(kernel_program("tile_relaxation.cl", constants), "repel_tiles");
        reserve(device_, buffers_.needed(settings, 0, 0, 0));
        buffers_.distances.write(settings.squared_distances);
    }

    std::vector<FilledTorus> fill(const FillStage& stage, std::span<const FillProblem> problems,
                                  std::uint32_t attempt) override
    {
        const FillShape shape = shape_of(stage, problems, settings_.dimension);
        const TorusRoom room = torus_room(shape, settings_.dimension);
        copies_ = shape.images;
        max_moving_ = in_whole(contract::vectors::LANES, shape.moving);
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
        throw_darts(stage, stage.active, attempt, 2 * stage.number, settings_.attempts, buffers_.active_targets);
        const std::vector<std::uint32_t> active_ends = buffers_.counts.read(0, problems.size());

        // Tori that could not be filled go no farther.
        std::vector<std::uint32_t> filled;
        for (std::size_t i = 0; i < problems.size(); ++i) {
            if (active_ends[i] == problems[i].held.size() + problems[i].active)
                filled.push_back(static_cast<std::uint32_t>(i));
        }
        groups_ = filled.size();
        buffers_.problem_numbers.write(filled);
        throw_darts(stage, stage.surroundings, attempt, 2 * stage.number + 1, settings_.surrounding_attempts,
                    buffers_.all_targets);
        const std::vector<std::int32_t> thrown = buffers_.points.read(0, problems.size() * axes() * capacity_);
        relax(stage);
        if (settings_.repulsion_passes > 0) repel(stage, problems);
        download(stage, problems, active_ends, thrown, filled, results);
    }

    void upload(std::span<const FillProblem> problems)
    {
        const std::size_t n = problems.size();
        const std::size_t per_problem = axes() * capacity_;
        std::vector<std::int32_t> points(n * per_problem);
        std::vector<std::uint32_t> numbers(n), streams(n), held(n), there(n), active(n), active_targets(n),
            all_targets(n);
        for (std::size_t i = 0; i < n; ++i) {
            const FillProblem& problem = problems[i];
            put(problem.held, 0, points.data() + i * per_problem);
            put(problem.given, problem.held.size(), points.data() + i * per_problem);
            numbers[i] = static_cast<std::uint32_t>(i);
            streams[i] = problem.stream;
            held[i] = static_cast<std::uint32_t>(problem.held.size());
            active[i] = problem.active;
            there[i] = held[i] + static_cast<std::uint32_t>(problem.given.size());
            active_targets[i] = held[i] + problem.active;
            all_targets[i] = active_targets[i] + problem.surroundings;
        }
        const std::size_t listed = n * max_moving_ * contract::tile_filling::LIST_WORDS(settings_.dimension);
        reserve(device_, buffers_.needed(settings_, n, n * per_problem, std::max<std::size_t>(1, listed)));
        buffers_.points.write(points);
        buffers_.problem_numbers.write(numbers);
        buffers_.streams.write(streams);
        buffers_.held.write(held);
        buffers_.counts.write(there);
        buffers_.active.write(active);
        buffers_.active_targets.write(active_targets);
        buffers_.all_targets.write(all_targets);
        groups_ = n;
    }

    /// Puts positions where the points of a problem from number `first` on are.
    void put(const std::vector<TilePosition>& positions, std::size_t first, std::int32_t* points) const
    {
        for (std::size_t i = 0; i < positions.size(); ++i) {
            for (std::size_t image = 0; image < copies_; ++image) {
                for (std::size_t k = 0; k < axes(); ++k) {
                    points[k * capacity_ + (first + i) * copies_ + image] =
                        wrapped(positions[i][k] + static_cast<std::int32_t>(image >> k & 1) * tile_units);
                }
            }
        }
    }

    contract::tile_filling::Tori tori(const FillStage& stage, CellSet cells) const
    {
        return {cells,
                shared(stage.regions),
                static_cast<std::uint32_t>(capacity_),
                static_cast<std::uint32_t>(copies_),
                stage.in_polygon,
                stage.keep_tiles};
    }

    void throw_darts(const FillStage& stage, const DartZone& zone, std::uint32_t attempt, std::uint32_t zone_number,
                     std::uint32_t attempts, const Buffer<std::uint32_t>& targets)
    {
        const contract::tile_filling::Darts darts{.tori = tori(stage, zone.cells),
                                                  .attempt = attempt,
                                                  .zone = zone_number,
                                                  .key_x = settings_.stream[0],
                                                  .key_y = settings_.stream[1],
                                                  .low = zone.low,
                                                  .extent = zone.extent,
                                                  .levels =
                                                      static_cast<std::uint32_t>(settings_.squared_distances.size()),
                                                  .attempts = attempts};
        FillBuffers& b = buffers_;
        throw_.run(groups_ * work_group_size_, work_group_size_, darts, b.problem_numbers, b.streams, b.distances,
                   targets, b.held, b.points, b.coarse, b.counts, b.levels);
    }

    void relax(const FillStage& stage)
    {
        contract::tile_filling::Relaxation relaxation{
            .tori = tori(stage, stage.active.cells),
            .surrounding_cells = stage.surroundings_move ? stage.surroundings.cells : 0,
            .spacing = settings_.spacing,
            .iterations = settings_.lloyd_iterations,
            .keeps_last = settings_.repulsion_passes > 0,
            .wanted = settings_.wanted,
            .reaches = {},
            .reach_count = static_cast<std::uint32_t>(reaches_.size()),
            .listed = std::min(reaches_.front(),
                               static_cast<std::int32_t>(list_reach(settings_.dimension) * settings_.spacing)),
            .slack = static_cast<std::int32_t>(list_slack(settings_.dimension) * settings_.spacing),
            .max_moving = static_cast<std::uint32_t>(max_moving_)};
        std::ranges::copy(reaches_, relaxation.reaches);
        FillBuffers& b = buffers_;
        relax_.run(groups_ * work_group_size_, work_group_size_, relaxation, b.problem_numbers, b.counts, b.held,
                   b.active, b.lists, b.points, b.coarse, b.doubles, b.moved, b.kept, b.squared_kept);
    }

    /// Returns the number of monomials.
    std::uint32_t upload_moments(const FillStage& stage, std::span<const FillProblem> problems)
    {
        const std::vector<Monomial> monomials = monomials_up_to(stage.equal_moments, settings_.dimension);
        if (monomials.empty()) return 0;
        std::vector<std::uint8_t> exponents;
        for (const Monomial& monomial : monomials)
            exponents.insert(exponents.end(), monomial.begin(), monomial.begin() + settings_.dimension);
        std::vector<std::int64_t> moments;
        for (const FillProblem& problem : problems)
            moments.insert(moments.end(), problem.moments.begin(), problem.moments.end());
        buffers_.exponents.write(exponents);
        buffers_.moments.write(moments);
        return static_cast<std::uint32_t>(monomials.size());
    }

    void repel(const FillStage& stage, std::span<const FillProblem> problems)
    {
        const contract::tile_filling::Repulsion repulsion{.tori = tori(stage, stage.active.cells),
                                                          .distance = settings_.repulsion_distance,
                                                          .passes = settings_.repulsion_passes,
                                                          .wanted = settings_.wanted,
                                                          .surroundings_moved = stage.surroundings_move,
                                                          .monomials = upload_moments(stage, problems)};
        FillBuffers& b = buffers_;
        repel_.run(groups_ * work_group_size_, work_group_size_, repulsion, b.problem_numbers, b.counts, b.held,
                   b.active, b.exponents, b.moments, b.points, b.moved, b.kept, b.squared_kept);
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

    void download(const FillStage& stage, std::span<const FillProblem> problems,
                  const std::vector<std::uint32_t>& active_ends, const std::vector<std::int32_t>& thrown,
                  const std::vector<std::uint32_t>& filled, std::vector<FilledTorus>& results)
    {
        const std::size_t n = problems.size();
        const std::size_t first_result = results.size();
        results.resize(first_result + n);
        for (std::size_t i = 0; i < n; ++i) {
            const std::size_t held = problems[i].held.size();
            results[first_result + i].thrown = points_of(thrown, i, held, active_ends[i] - held, copies_);
        }
        if (filled.empty()) return;
        const std::vector<std::uint32_t> ends = buffers_.counts.read(0, n);
        const std::vector<std::uint32_t> squared = buffers_.squared_kept.read(0, n);
        const std::vector<std::int32_t> kept = buffers_.kept.read(0, n * axes() * capacity_);
        for (const std::uint32_t i : filled) {
            FilledTorus& result = results[first_result + i];
            const std::size_t held = problems[i].held.size();
            result.active = points_of(kept, i, held, problems[i].active, 1);
            const std::size_t around = ends[i] - active_ends[i];
            result.thrown_surroundings = points_of(thrown, i, active_ends[i], around, copies_);
            result.surroundings =
                stage.surroundings_move ? points_of(kept, i, active_ends[i], around, 1) : result.thrown_surroundings;
            result.squared_min_distance = squared[i];
        }
    }

    FillSettings settings_;
    Device device_;
    std::vector<std::int32_t> reaches_;
    std::size_t work_group_size_;
    std::size_t capacity_ = 0;
    std::size_t max_moving_ = 0;
    std::size_t copies_ = 1;
    std::size_t groups_ = 0;
    Kernel throw_, relax_, repel_;
    FillBuffers buffers_;
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
    return memory_of(FillBuffers{}.needed(settings, most, values, lists));
}

}
