#include "host/distribution/ranked_sets.hpp"

#include "base/errors/errors.hpp"
#include "base/random/random.hpp"
#include "tiles/poisson/tile_lookup.hpp"
#include "tiles/poisson/tile_set_file.hpp"

#include <fmt/format.h>

#include <array>

namespace poissonlab {
namespace {

std::variant<PoissonTileSet, MonotilePointsFile> read_ranked_set(const std::filesystem::path& file)
{
    if (is_monotile_points_file(file)) return read_monotile_points(file);
    PoissonTileSet tiles = read_tile_set(file);
    if (tiles.parameters.dimension != 2)
        throw InputError(fmt::format("{}: are tiles in space; must be in the plane", file.string()));
    if (tiles.ranks.empty())
        throw InputError(fmt::format("{}: are tiles without ranks (tiles build --ranked)", file.string()));
    return tiles;
}

std::vector<LeveledPoint> tile_points(const PoissonTileSet& tiles, double width, double height, std::uint64_t seed)
{
    const PoissonTiling tiling{stream_key(seed, Purpose::tile_choice, 0)[0], 0};
    const ptiles_tiling look_up = runtime_tiling(tiles, tiling);
    const double low[3] = {0, 0, 0}, high[3] = {width, height, 0};
    std::vector<ptiles_point> all(ptiles_in_window(&look_up, low, high, nullptr, 0, 1));
    ptiles_in_window(&look_up, low, high, all.data(), all.size(), 1);
    std::vector<LeveledPoint> points;
    for (const ptiles_point& p : all) points.push_back({p.position[0], p.position[1], p.level});
    return points;
}

std::vector<LeveledPoint> monotile_points(const MonotilePointsFile& file, double width, double height,
                                          std::uint64_t seed)
{
    constexpr auto longest = static_cast<double>(farthest_monotile_corner);
    if (width > longest || height > longest)
        throw InputError(fmt::format("a picture of {:.0f} by {:.0f} edges: must be at most {:.0f} along each axis",
                                     width, height, longest));
    const auto key = stream_key(seed, Purpose::tile_choice, 0);
    const std::array<std::int64_t, 2> origin{static_cast<std::int32_t>(key[0]), static_cast<std::int32_t>(key[1])};
    std::vector<LeveledPoint> points;
    for (const pmono_point& p : file.in_window(key[0], origin, {0, 0}, {width, height}))
        points.push_back({p.position[0], p.position[1], p.level});
    return points;
}

}

RankedSet::RankedSet(const std::filesystem::path& file) : set_(read_ranked_set(file)) {}

double RankedSet::density() const
{
    if (const auto* monotile = std::get_if<MonotilePointsFile>(&set_)) return monotile->density();
    return std::get<PoissonTileSet>(set_).parameters.points_per_tile;
}

double RankedSet::relative_radius() const
{
    if (const auto* monotile = std::get_if<MonotilePointsFile>(&set_)) return monotile->relative_radius();
    const PoissonTileSet& tiles = std::get<PoissonTileSet>(set_);
    return relative_radius_of(tiles.squared_min_distance, tiles.parameters);
}

std::vector<LeveledPoint> RankedSet::points(double width, double height, std::uint64_t seed) const
{
    if (const auto* monotile = std::get_if<MonotilePointsFile>(&set_))
        return monotile_points(*monotile, width, height, seed);
    return tile_points(std::get<PoissonTileSet>(set_), width, height, seed);
}

}
