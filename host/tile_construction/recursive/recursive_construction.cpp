#include "host/tile_construction/recursive/recursive_construction.hpp"

#include "base/geometry/relative_radius.hpp"
#include "host/sampling/reference/relaxing_grid.hpp"
#include "host/sampling/relaxation_dart_throwing.hpp"
#include "host/tile_construction/recursive/ranked_points.hpp"
#include "host/tile_construction/recursive/self_similarity.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace poissonlab {

std::vector<RankedDart> throw_darts_around(std::uint32_t points, const std::vector<ForcedDart>& forced,
                                           double free_distance, const StreamKey& stream)
{
    RelaxationDartThrowingRequest request;
    request.points = points;
    RadiusLevels levels(request);
    reference::Darts<2> darts(stream);
    std::vector<TorusPoint<2>> places;
    std::vector<RankedDart> result;
    reference::RelaxingGrid<2> grid(places, points);
    grid.fit(2 * levels.radius());
    std::uint64_t squared = levels.squared_min_distance();
    const std::uint64_t squared_free = squared_threshold(free_distance);
    auto next_forced = forced.begin();
    const auto take = [&](const RankedDart& dart) {
        places.push_back(dart.place);
        grid.insert(static_cast<std::uint32_t>(places.size() - 1));
        result.push_back(dart);
    };
    const auto is_forbidden = [&](const TorusPoint<2>& dart) {
        if (!forced.empty() && squared_distance<2>(dart, {0, 0}) < squared_free) return true;
        return std::any_of(next_forced, forced.end(), [&](const ForcedDart& later) {
            return squared_distance<2>(dart, later.dart.place) < later.dart.squared_distance;
        });
    };
    std::uint64_t failures = 0;
    while (result.size() < points) {
        if (next_forced != forced.end() && next_forced->rank == result.size()) {
            take((next_forced++)->dart);
            continue;
        }
        const TorusPoint<2> dart = darts.next();
        if (!is_forbidden(dart) && !grid.conflicts(dart, squared)) {
            take({dart, squared});
            failures = 0;
        } else if (++failures == request.attempts) {
            levels.reduce();
            squared = levels.squared_min_distance();
            grid.fit(2 * levels.radius());
            failures = 0;
        }
    }
    return result;
}

std::vector<ForcedDart> darts_near_corner(const std::vector<RankedDart>& darts, double distance)
{
    const std::uint64_t squared = squared_threshold(distance);
    std::vector<ForcedDart> near;
    for (std::uint32_t i = 0; i < darts.size(); ++i)
        if (squared_distance<2>(darts[i].place, {0, 0}) < squared) near.push_back({i, darts[i]});
    return near;
}

namespace {

constexpr double kept_corner = 2.5; ///< spacings around a corner whose points all sets get

/// Cutting takes some points away or adds some: so many more are thrown.
std::uint32_t points_thrown(std::uint32_t points_per_tile) { return points_per_tile + points_per_tile / 16 + 16; }

std::vector<RankedPlace> in_order(const std::vector<RankedDart>& darts)
{
    std::vector<RankedPlace> places;
    for (const RankedDart& dart : darts) places.push_back({static_cast<std::uint32_t>(places.size()), dart.place});
    return places;
}

/// The sets for two colours of horizontal edges, two of vertical ones, and the middles of tiles.
std::vector<std::vector<RankedPlace>> source_sets(std::uint32_t points, double spacing, std::uint64_t seed)
{
    const auto stream = [&](std::size_t set) {
        return stream_key(seed, Purpose::recursive_tile_darts, static_cast<std::uint32_t>(set));
    };
    const auto corner = darts_near_corner(throw_darts_around(points, {}, 0, stream(0)), kept_corner * spacing);
    std::vector<std::vector<RankedPlace>> sets(4 + even_wang_tiles);
    tbb::parallel_for(std::size_t{0}, sets.size(), [&](std::size_t i) {
        sets[i] = in_order(throw_darts_around(points, corner, shared_corner * spacing, stream(i + 1)));
    });
    return sets;
}

/// Tiles with ranks for their own points, then for the others.
void add_sub_points(RecursiveTiles& tiles, std::uint32_t points)
{
    const RecursivePlaces own = places_of_links(tiles, points);
    RecursivePlaces all;
    std::array<std::vector<bool>, even_wang_tiles> taken;
    for (std::size_t i = 0; i < even_wang_tiles; ++i) {
        all[i] = places_in_cells(own, tiles[i].children);
        taken[i].resize(all[i].size());
        for (const RecursiveLink link : tiles[i].links) taken[i][link.cell() * points + link.point()] = true;
    }
    const auto orders = farthest_orders(all, taken);
    for (std::size_t i = 0; i < even_wang_tiles; ++i)
        for (const std::uint32_t number : orders[i])
            tiles[i].links.push_back(RecursiveLink::to(number / points, number % points));
}

}

std::array<std::vector<RankedPlace>, even_wang_tiles> merged_recursive_tiles(std::uint32_t points_per_tile,
                                                                             std::uint64_t seed)
{
    const double spacing = max_min_distance(points_per_tile, 2);
    const auto sets = source_sets(points_thrown(points_per_tile), spacing, seed);
    std::array<std::vector<RankedPlace>, even_wang_tiles> tiles;
    tbb::parallel_for(std::size_t{0}, even_wang_tiles, [&](std::size_t i) {
        const WangTile colors = wang_colors_of(i);
        std::vector<RankedPlace> tile = sets[4 + i];
        tile = with_edge(tile, sets[colors.north], TileSide::north, spacing);
        tile = with_edge(tile, sets[2 + colors.east], TileSide::east, spacing);
        tile = with_edge(tile, sets[colors.south], TileSide::south, spacing);
        tiles[i] = with_edge(tile, sets[2 + colors.west], TileSide::west, spacing);
    });
    return tiles;
}

RecursiveTileSet build_recursive_tiles(std::uint32_t points_per_tile, std::uint64_t seed,
                                       const std::function<void(const std::string& what)>& on_step)
{
    const auto begin = [&](const char* what) {
        if (on_step) on_step(std::string("recursive Wang tiles: ") + what);
    };
    begin("sets of darts, and cuts along edges");
    const auto merged = merged_recursive_tiles(points_per_tile, seed);
    begin("divisions");
    RecursivePlaces places;
    for (std::size_t i = 0; i < even_wang_tiles; ++i) places[i] = mended_order(merged[i], points_per_tile);
    const auto cells = random_divisions(seed);
    const TileLinks own = own_points(places, cells);
    RecursiveTiles tiles;
    for (std::size_t i = 0; i < even_wang_tiles; ++i) tiles[i] = {cells[i], own[i]};
    begin("order of sub-points");
    add_sub_points(tiles, points_per_tile);
    return {points_per_tile, seed, std::move(tiles)};
}

}
