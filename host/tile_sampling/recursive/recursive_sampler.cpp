#include "host/tile_sampling/recursive/recursive_sampler.hpp"

#include "base/errors/errors.hpp"
#include "base/programs/cache_folder.hpp"
#include "base/random/random.hpp"
#include "host/sampling/density_parameters.hpp"
#include "host/sampling/device_sampler.hpp"
#include "host/tile_sampling/tile_samplers.hpp"
#include "kernels/common/tile_sampling/recursive_tiles.h"

#include <fmt/format.h>

#include <array>
#include <chrono>
#include <utility>

namespace poissonlab {

using contract::recursive_tiles::RankedLevel;
using contract::recursive_tiles::RankedTile;

namespace {

/// One call finds the points of so many ranks, of so many tiles at most.
constexpr std::size_t ranks_of_a_call = std::size_t{1} << 20;
constexpr std::size_t tiles_of_a_call = std::size_t{1} << 15;

}

struct RecursiveBuffers
{
    Buffer<RankedTile> tiles;
    Buffer<std::uint16_t> links;
    Buffer<std::uint32_t> children;
    Buffer<RecursivePlace> places;
    Buffer<std::uint64_t> weights;
    Buffer<std::array<double, 2>> points;

    NeededBuffers needed(std::size_t points_per_tile, std::size_t weight_count)
    {
        using namespace contract::recursive_tiles;
        return {{tiles, tiles_of_a_call},
                {links, TILES * CELLS * points_per_tile},
                {children, std::size_t{TILES} * CELLS},
                {places, TILES * points_per_tile},
                {weights, weight_count},
                {points, ranks_of_a_call}};
    }
};

RecursiveGenerator::RecursiveGenerator(Device device, const RecursiveTileSet& tiles, const RecursiveDensity& density,
                                       std::size_t work_group_size)
    : DeviceMethod(std::move(device), work_group_size, std::make_shared<RecursiveBuffers>()), density_(&density)
{
    const std::size_t points = tiles.points_per_tile();
    reserve(device_, buffers_->needed(points, density.bounds().weights.size()));
    for (std::size_t tile = 0; tile < even_wang_tiles; ++tile) {
        std::vector<std::uint16_t> links;
        for (const RecursiveLink link : tiles.tile(tile).links) links.push_back(link.word);
        buffers_->links.write(links, tile * links.size());
        const auto& children = tiles.tile(tile).children;
        buffers_->children.write(std::vector<std::uint32_t>(children.begin(), children.end()), tile * recursive_cells);
        buffers_->places.write(tiles.places(tile), tile * points);
    }
    buffers_->weights.write(density.bounds().weights);
}

DeviceMemory RecursiveGenerator::memory(std::size_t points_per_tile, std::size_t weights)
{
    return memory_of(RecursiveBuffers{}.needed(points_per_tile, weights));
}

/// Adds the points of some tiles of a level, in as many calls as buffers ask for.
void RecursiveGenerator::place(const RecursiveTiling& tiling, int level, const std::vector<RankedCell>& cells,
                               PointSet& set)
{
    Kernel place_ranks = device_.kernel(kernel_program("recursive_tiles.cl", {}), "place_ranks");
    RankedLevel header{};
    header.most = density_->most();
    header.across = std::uint64_t{tiling.side()} << 2 * (level + 1);
    header.level = static_cast<std::uint32_t>(level);
    header.points_per_tile = tiling.tiles().points_per_tile();
    header.width = density_->bounds().width;
    header.height = density_->bounds().height;
    header.is_uniform = density_->is_uniform();
    std::vector<std::array<double, 2>> points;
    for (std::size_t next = 0; next < cells.size();) {
        std::vector<RankedTile> tiles;
        header.ranks = 0;
        for (; next < cells.size() && tiles.size() < tiles_of_a_call &&
               header.ranks + cells[next].count <= ranks_of_a_call;
             ++next) {
            const RankedCell& from = cells[next];
            if (from.count == 0) continue;
            tiles.push_back({from.cell[0], from.cell[1], from.turn, from.tile, from.first, header.ranks, 0});
            header.ranks += from.count;
        }
        header.tiles = static_cast<std::uint32_t>(tiles.size());
        buffers_->tiles.write(tiles);
        place_ranks.run(header.ranks, work_group_size_, header, buffers_->tiles, buffers_->links, buffers_->children,
                        buffers_->places, buffers_->weights, buffers_->points);
        points.resize(header.ranks);
        buffers_->points.read(points);
        for (const auto& point : points)
            if (point[0] >= 0) set.coordinates.insert(set.coordinates.end(), point.begin(), point.end());
    }
}

PointSet RecursiveGenerator::torus_points(const RecursiveTiling& tiling, RecursiveDrawing drawing)
{
    PointSet set{2, {}};
    tiling.show_levels(*density_, drawing,
                       [&](int level, const std::vector<RankedCell>& cells) { place(tiling, level, cells, set); });
    return set;
}

namespace {

constexpr WordTable<RecursiveDrawing, 2> recursive_drawings{
    {{{RecursiveDrawing::once, "once"}, {RecursiveDrawing::twice, "twice"}}}};

constexpr const char* base_key = "base_tiles";
constexpr const char* recursive_size_key = "points_per_tile";
constexpr const char* sets_key = "sets";

std::uint32_t small_parameter(const Parameters& given, const char* key)
{
    return static_cast<std::uint32_t>(given.integer(key));
}

RecursiveDensity density_asked(const Parameters& given, const SampleRequest& request)
{
    return {request.points, small_parameter(given, base_key), 0, given_density(given)};
}

bool draws_twice(const Parameters& given)
{
    return given.text("drawing") == recursive_drawings[RecursiveDrawing::twice];
}

/// On CPUs the host's threads are faster: kernels write down, and the host reads, all the ranks that a density leaves
/// out, which are several times as many as its points. The host does without devices that cannot, too.
bool is_faster_on(const DeviceInfo& device) { return device.type != "CPU" && device.has_double_precision; }

class RecursiveSampler final : public DeviceSampler
{
public:
    RecursiveSampler(const Parameters& given, const SampleRequest& request, Engine engine, const DeviceProvider& device)
        : DeviceSampler(engine, device), seed_(request.seed), side_(small_parameter(given, base_key)),
          roots_(side_, seed_), drawing_(*recursive_drawings.find(given.text("drawing"))),
          density_(density_asked(given, request))
    {
        const auto begin = std::chrono::steady_clock::now();
        double waiting_seconds = 0;
        for (std::uint32_t i = 0; i < small_parameter(given, sets_key); ++i) {
            CachedRecursiveTiles cached = cached_recursive_tiles(small_parameter(given, recursive_size_key),
                                                                 request.seed + i, cache_folder(), request.on_step);
            sets_.push_back(std::move(cached.tiles));
            if (i == 0) record_ = std::move(cached.record);
            waiting_seconds += cached.waiting_seconds;
        }
        const std::chrono::duration<double> all = std::chrono::steady_clock::now() - begin;
        preparation_seconds_ = all.count() - waiting_seconds;
        if (device_ && is_faster_on(device_->info()))
            for (const RecursiveTileSet& tiles : sets_) generators_.emplace_back(*device_, tiles, density_);
    }

    PointSet sample(std::uint32_t realization) override
    {
        const std::size_t set = realization % sets_.size();
        const StreamKey stream = stream_key(seed_, Purpose::recursive_tilings, realization);
        const RecursiveTiling tiling(sets_[set], side_, stream, roots_.of(realization));
        return generators_.empty() ? tiling.torus_points(density_, drawing_)
                                   : generators_[set].torus_points(tiling, drawing_);
    }

    SetTraits traits() const override
    {
        SetTraits traits;
        traits.sizes_vary = !density_.is_uniform(); // a density takes points or leaves them by where they lie
        traits.tiles_along_axis = side_;
        traits.tile_sets = static_cast<std::uint32_t>(sets_.size());
        traits.tile_set = record_;
        traits.preparation_seconds = preparation_seconds_;
        return traits;
    }

private:
    std::uint64_t seed_;
    std::uint32_t side_;
    RealizationRoots roots_;
    RecursiveDrawing drawing_;
    RecursiveDensity density_;
    std::vector<RecursiveTileSet> sets_;
    TileSetRecord record_; ///< of the first
    double preparation_seconds_ = 0;
    std::vector<RecursiveGenerator> generators_; ///< one a set; none: the reference does the work
};

std::vector<ParameterSpec> recursive_parameters()
{
    using Kind = ParameterSpec::Kind;
    std::vector<ParameterSpec> specs{
        {.key = recursive_size_key,
         .kind = Kind::integer,
         .help = "N, points of a tile before those of the tiles in its cells are drawn",
         .minimum = min_recursive_points,
         .maximum = max_recursive_points,
         .symbol = "N",
         .otherwise = std::int64_t{2048}},
        {.key = base_key,
         .kind = Kind::integer,
         .help = "M, the largest tiles along each axis of the torus, which has 14 tilings of M = 2 that differ, 128 of "
                 "3, and 8,312 of 4",
         .minimum = 1,
         .maximum = 256,
         .symbol = "M",
         .otherwise = std::int64_t{4}},
        {.key = "drawing",
         .kind = Kind::choice,
         .help = "once; or twice: points of tiles and of their cells, which have some in common, an error of programs",
         .choices = recursive_drawings.all(),
         .otherwise = std::string(recursive_drawings[RecursiveDrawing::once])},
    };
    for (ParameterSpec& spec : density_parameters()) specs.push_back(std::move(spec));
    specs.push_back(tile_sets_parameter());
    return specs;
}

void check_recursive(const Parameters& given, const SampleRequest& request, const SourceLocation& where)
{
    std::uint64_t most = 0; // points of one of the largest tiles, in units of 2^-32
    try {
        most = density_asked(given, request).most();
    } catch (const InputError& error) {
        if (!error.key().empty()) throw;
        throw InputError::at(where, fmt::format("sampler = \"recursive-wang-tiles\": {}", error.what()));
    }
    if (draws_twice(given) && most <= std::uint64_t{small_parameter(given, recursive_size_key)} << 32)
        throw given.error("drawing", fmt::format("differs from \"{}\" only where one of the largest tiles has more "
                                                 "points than points_per_tile = {}, and here they have at most {}",
                                                 recursive_drawings[RecursiveDrawing::once],
                                                 given.integer(recursive_size_key), (most + (1ULL << 32) - 1) >> 32));
}

/// The second drawing has the points of whole tiles on top.
std::size_t most_recursive_points(const Parameters& given, const SampleRequest& request)
{
    const std::size_t tiles = std::size_t{small_parameter(given, base_key)} * small_parameter(given, base_key);
    return draws_twice(given) ? 2 * request.points + tiles * small_parameter(given, recursive_size_key)
                              : request.points;
}

}

SamplerSpec recursive_wang_tile_sampler()
{
    SamplerSpec spec;
    spec.name = "recursive-wang-tiles";
    spec.title = "Recursive Wang tiles";
    spec.summary = "8 Wang tiles with ranked points, each made of 16 of them; of any density";
    spec.dimensions = {2};
    spec.parameters = recursive_parameters();
    spec.check = check_recursive;
    spec.outside_input = density_hash;
    spec.most_points = most_recursive_points;
    // One tile can only lie beside itself.
    spec.is_deterministic = [](const Parameters& given) {
        return given.integer(base_key) == 1 && given.integer(sets_key) == 1;
    };
    spec.memory_growth = MemoryGrowth::fixed;
    spec.device_memory = [](const Parameters& given, const SampleRequest& request, const DeviceInfo& device) {
        DeviceMemory all;
        if (!is_faster_on(device)) return all;
        for (std::uint32_t i = 0; i < small_parameter(given, sets_key); ++i)
            all = all + RecursiveGenerator::memory(small_parameter(given, recursive_size_key),
                                                   density_asked(given, request).bounds().weights.size());
        return all;
    };
    spec.create = [](const Parameters& given, const SampleRequest& request, Engine engine,
                     const DeviceProvider& device) {
        return std::make_unique<RecursiveSampler>(given, request, engine, device);
    };
    return spec;
}

}
