#include "host/distribution/even_points.hpp"

#include "base/errors/errors.hpp"
#include "base/programs/cache_folder.hpp"
#include "base/programs/interrupt.hpp"
#include "base/random/random.hpp"
#include "host/settings/sampler_table.hpp"
#include "host/tile_points/tile_points.hpp"
#include "host/tile_sampling/tile_samplers.hpp"
#include "host/tile_sampling/tile_set_cache.hpp"
#include "tiles/poisson/tile_regions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace poissonlab {
namespace {

/// The seed of tile sets: which tiling is made of them is another matter.
constexpr std::uint64_t tile_set_seed = 1;

constexpr double most_tiles_along_a_side = 65'536;
constexpr std::uint32_t tile_side = tile_units;

/// A position within a side as a part of 2^32.
std::uint32_t part_of_side(std::uint64_t place, std::uint32_t tiles)
{
    return static_cast<std::uint32_t>((place << 16) / tiles); // units of 1/65,536
}

void stream_tiling(const PoissonTileSet& tiles, const PoissonTiling& tiling, const TileBlock& block,
                   const DistributionPlace& place, const std::function<void(std::span<const std::uint32_t>)>& sink)
{
    if (place.engine == Engine::reference)
        sink(reference::exact_tile_points(tiles, tiling, block));
    else
        TilePointGenerator(place.device(), tiles).stream(tiling, block, sink);
}

std::uint32_t tiling_seed(std::uint64_t seed) { return stream_key(seed, Purpose::tile_choice, 0)[0]; }

/// All points of a torus.
SquarePoints torus_square(const PoissonTileSet& tiles, const EvenTileGrid& grid, std::uint64_t seed,
                          const DistributionPlace& place)
{
    const TileBlock block{{}, {grid.columns, grid.rows, 1}};
    const PoissonTiling tiling{tiling_seed(seed), static_cast<std::int32_t>(std::max(grid.columns, grid.rows))};
    SquarePoints square;
    stream_tiling(tiles, tiling, block, place, [&](std::span<const std::uint32_t> units) {
        stop_if_interrupted();
        for (std::size_t i = 0; i < units.size(); ++i) {
            const std::uint32_t side = i % 2 == 0 ? grid.columns : grid.rows;
            square.push_back(part_of_side(torus_place(units[i], side), side));
        }
    });
    return square;
}

/// Points with the size of the smallest rectangle of given proportions, or the least height, that has them inside.
struct SizedPoints
{
    std::vector<std::array<std::uint32_t, 2>> places; ///< in 1/65,536 of a tile
    std::vector<std::uint64_t> sizes;
};

/// The points of the least sizes, in their order, and the size of the rectangle around them: in the middle between that
/// of the largest one and of the next.
struct SmallestPoints
{
    std::vector<std::size_t> points;
    std::uint64_t whole = 1;
};

SmallestPoints smallest_points(const std::vector<std::uint64_t>& sizes, std::size_t count)
{
    std::vector<std::uint64_t> sorted = sizes;
    const auto last = sorted.begin() + static_cast<std::ptrdiff_t>(count - 1);
    std::ranges::nth_element(sorted, last);
    const std::uint64_t largest = *last;
    std::size_t of_largest = count; // that stay: several may be as large
    for (const std::uint64_t size : sizes) of_largest -= size < largest ? 1 : 0;
    SmallestPoints smallest{{}, largest + 1};
    smallest.points.reserve(count);
    if (const auto next = std::min_element(last + 1, sorted.end()); next != sorted.end())
        smallest.whole = std::max(smallest.whole, largest + (*next - largest) / 2);
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        if (sizes[i] > largest || (sizes[i] == largest && of_largest == 0)) continue;
        of_largest -= sizes[i] == largest ? 1 : 0;
        smallest.points.push_back(i);
    }
    return smallest;
}

/// A place as a part of a side, in 2^-32: below 1.
std::uint32_t part_of_size(std::uint64_t place, std::uint64_t size)
{
    // One division of doubles, which all machines round alike.
    const double part = static_cast<double>(place) / static_cast<double>(size) * 4294967296.0;
    return static_cast<std::uint32_t>(std::min(part, 4294967295.0));
}

/// The first `points` points of a tiling that closes after so many columns, by their heights.
SquarePoints strip_square(const PoissonTileSet& tiles, std::size_t points, std::uint32_t columns, std::uint64_t seed,
                          const DistributionPlace& place)
{
    const std::uint64_t a_row = std::uint64_t{columns} * tiles.parameters.points_per_tile;
    const TileBlock block{{}, {columns, static_cast<std::uint32_t>((points + a_row - 1) / a_row + 3), 1}};
    SizedPoints sized;
    stream_tiling(tiles, {tiling_seed(seed), static_cast<std::int32_t>(columns)}, block, place,
                  [&](std::span<const std::uint32_t> units) {
                      stop_if_interrupted();
                      for (std::size_t i = 0; i < units.size(); i += 2) {
                          const auto y = static_cast<std::int32_t>(units[i + 1] - tile_side); // from the second row on
                          if (y < 0) continue;
                          sized.places.push_back({part_of_side(torus_place(units[i], columns), columns), 0});
                          sized.sizes.push_back(static_cast<std::uint64_t>(y));
                      }
                  });
    const SmallestPoints kept = smallest_points(sized.sizes, points);
    SquarePoints square;
    for (const std::size_t i : kept.points)
        square.insert(square.end(), {sized.places[i][0], part_of_size(sized.sizes[i], kept.whole)});
    return square;
}

/// The first `points` points of a tiling without end, by the size of the rectangle from the corner of a tile that they
/// are in.
SquarePoints window_square(const PoissonTileSet& tiles, std::size_t points, std::array<std::uint64_t, 2> sides,
                           std::uint64_t seed, const DistributionPlace& place)
{
    const double tile_count = static_cast<double>(points) / tiles.parameters.points_per_tile;
    const double columns = std::sqrt(tile_count * static_cast<double>(sides[0]) / static_cast<double>(sides[1]));
    const double rows = tile_count / columns;
    for (double larger = 1;; larger *= 1.25) {
        const auto wide = static_cast<std::uint32_t>(std::ceil(larger * columns) + 1);
        const auto high = static_cast<std::uint32_t>(std::ceil(larger * rows) + 1);
        const std::uint64_t most =
            std::min(std::uint64_t{wide} * tile_side * sides[1], std::uint64_t{high} * tile_side * sides[0]);
        SizedPoints sized;
        stream_tiling(tiles, {tiling_seed(seed), 0}, {{}, {wide + 2, high + 2, 1}}, place,
                      [&](std::span<const std::uint32_t> units) {
                          stop_if_interrupted();
                          for (std::size_t i = 0; i < units.size(); i += 2) {
                              // Tiles around the rectangle reach into it.
                              const std::uint32_t x = units[i] - tile_side, y = units[i + 1] - tile_side;
                              const std::uint64_t size = std::max(x * sides[1], y * sides[0]);
                              if (size >= most) continue; // below 0 as well, modulo 2^32
                              sized.places.push_back({x, y});
                              sized.sizes.push_back(size);
                          }
                      });
        if (sized.sizes.size() < points) continue;
        const SmallestPoints kept = smallest_points(sized.sizes, points);
        SquarePoints square;
        for (const std::size_t i : kept.points)
            for (std::size_t axis = 0; axis < 2; ++axis)
                square.push_back(part_of_size(sized.places[i][axis] * sides[1 - axis], kept.whole));
        return square;
    }
}

SquarePoints tiling_points(const PoissonTileSet& tiles, std::size_t points, int width, int height, std::uint64_t seed,
                           const DistributionPlace& place, Seam seam)
{
    const EvenTileGrid grid = tile_grid(points, tiles.parameters.points_per_tile, width, height);
    if (grid.tiles() * tiles.parameters.points_per_tile == points) return torus_square(tiles, grid, seed, place);
    if (seam == Seam::closed) {
        const double columns =
            std::sqrt(static_cast<double>(points) / tiles.parameters.points_per_tile * width / height);
        return strip_square(tiles, points, std::max(1U, static_cast<std::uint32_t>(std::lround(columns))), seed, place);
    }
    return window_square(tiles, points, {static_cast<std::uint64_t>(width), static_cast<std::uint64_t>(height)}, seed,
                         place);
}

SquarePoints sampled_points(const SamplerChoice& method, std::size_t points, double width, double height,
                            std::uint64_t seed, const DistributionPlace& place)
{
    const double longest = std::max(width, height);
    const double area = width * height / (longest * longest);
    const double in_square = std::round(static_cast<double>(points) / area);
    const SamplerSpec& spec = *method.spec;
    if (in_square > static_cast<double>(max_points))
        throw InputError(
            fmt::format("{} points of {} x {} pixels by \"{}\": are {:.0f} in the square around them; must "
                        "be at most {}",
                        points, width, height, spec.name, in_square, max_points));
    const SampleRequest request{static_cast<std::size_t>(in_square), 2, seed, place.on_step};
    if (std::ranges::find(spec.dimensions, 2) == spec.dimensions.end())
        throw InputError(fmt::format("sampler \"{}\": has no sets in the plane", spec.name));
    try {
        if (spec.check) spec.check(method.parameters, request, {});
    } catch (const InputError& error) { // what is missing has no place of its own
        throw error.place().file.empty() ? InputError(fmt::format("method: {}", error.what())) : error;
    }
    if (spec.device_memory && place.engine == Engine::opencl) {
        const DeviceInfo& device = place.device().info();
        check_fits(fmt::format("sampler \"{}\"", spec.name), spec.device_memory(method.parameters, request, device),
                   device);
    }
    const PointSet set = spec.create(method.parameters, request, place.engine, place.device)->sample(0);
    SquarePoints square;
    for (std::size_t i = 0; i < set.size(); ++i) {
        const double x = set[i][0] * longest / width, y = set[i][1] * longest / height;
        if (x >= 1 || y >= 1) continue;
        square.push_back(static_cast<std::uint32_t>(x * 4294967296.0));
        square.push_back(static_cast<std::uint32_t>(y * 4294967296.0));
    }
    return square;
}

}

EvenTileGrid tile_grid(std::size_t points, std::uint32_t points_per_tile, double width, double height)
{
    const double tiles = static_cast<double>(points) / points_per_tile;
    const double rows = std::sqrt(tiles * height / width);
    if (rows > most_tiles_along_a_side || rows * width / height > most_tiles_along_a_side)
        throw InputError(
            fmt::format("{} points: are more than 65536 tiles of {} points along a side", points, points_per_tile));
    EvenTileGrid best;
    double least = INFINITY;
    const auto try_rows = [&](double count) {
        if (count < 1) return;
        for (const double columns : {std::floor(tiles / count), std::floor(tiles / count) + 1}) {
            if (columns < 1) continue;
            const double wrong =
                std::abs(std::log(columns * count / tiles)) + std::abs(std::log(columns / count * height / width));
            if (wrong >= least) continue;
            least = wrong;
            best = {static_cast<std::uint32_t>(columns), static_cast<std::uint32_t>(count)};
        }
    };
    for (int around = -1; around <= 2; ++around) try_rows(std::floor(rows) + around);
    return best;
}

SamplerChoice default_even_method()
{
    static const SamplerSpec spec = corner_tile_sampler();
    Parameters parameters(spec.parameters);
    parameters.set("colors", std::int64_t{3});
    parameters.set("points_per_tile", std::int64_t{32});
    return {&spec, parameters};
}

SquarePoints even_points(const EvenMethod& method, std::size_t points, int width, int height, std::uint64_t seed,
                         const DistributionPlace& place, Seam seam)
{
    if (const auto* tiles = std::get_if<PoissonTileSet>(&method))
        return tiling_points(*tiles, points, width, height, seed, place, seam);
    const SamplerChoice& sampler = std::get<SamplerChoice>(method);
    const auto built = plane_tile_set(sampler.spec->name, sampler.parameters, tile_set_seed);
    if (!built || sampler.parameters.number("density") < 1)
        return sampled_points(sampler, points, width, height, seed, place);
    if (sampler.spec->check) sampler.spec->check(sampler.parameters, {points, 2, tile_set_seed}, {sampler.spec->name});
    const CachedTileSet cached = cached_tile_set(*built, place.engine, place.device, cache_folder(), place.on_step);
    return tiling_points(cached.set, points, width, height, seed, place, seam);
}

PixelPlaces warp_points(const Density& density, const SquarePoints& points, const DistributionPlace& place)
{
    const WarpTable table(density);
    if (place.engine == Engine::reference) return reference::warp_points(table, points);
    Device& device = place.device();
    check_fits("warping", PointWarper::memory(table.width, table.height, points.size() / 2), device.info());
    return PointWarper(device, table).warp(points);
}

}
