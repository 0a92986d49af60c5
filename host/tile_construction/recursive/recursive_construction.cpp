#include "host/tile_construction/recursive/recursive_construction.hpp"

#include "base/geometry/relative_radius.hpp"
#include "host/sampling/classics/torus_grid.hpp"
#include "host/sampling/reference/relaxing_grid.hpp"
#include "host/sampling/relaxation_dart_throwing.hpp"
#include "host/tile_construction/recursive/tile_views.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <queue>
#include <utility>

namespace poissonlab {
namespace {

/// The number of points, this one with them, whose largest distance times 0.6 is no more than a squared distance in
/// units of 2^-64.
std::uint64_t points_at_distance(std::uint64_t squared)
{
    const double part = 0.6 * max_min_distance(1, 2), distance = static_cast<double>(squared) * 0x1p-64;
    return static_cast<std::uint64_t>(std::ceil(std::min(1e18, part * part / std::max(distance, 0x1p-64))));
}

/// Places in the plane: a quarter of the torus, from which nothing is seen the other way round.
TorusPosition in_a_quarter(const RecursivePlace& place) { return {place[0] >> 1, place[1] >> 1, 0}; }

/// The points of a tile that have no rank yet, the farthest ones first.
class OpenPoints
{
public:
    OpenPoints(const std::vector<RecursivePlace>& places, std::vector<bool> taken)
        : done_(std::move(taken)), grid_(places.size()), squared_(places.size(), farthest_of_all)
    {
        for (const RecursivePlace& place : places) grid_.add(plane_place(place));
    }

    /// Points near a place are no farther from what is there than from this.
    void come_near(const PlanePlace& place, std::int64_t reach)
    {
        grid_.visit_near(place, reach, [&](std::uint32_t i) {
            const std::uint64_t squared = squared_between(grid_[i], place);
            if (done_[i] || squared >= squared_[i]) return;
            squared_[i] = squared;
            farthest_.emplace(squared, ~i); // of equals the smallest number comes first
        });
    }

    /// Points that nothing came near wait as well.
    void begin()
    {
        for (std::uint32_t i = 0; i < squared_.size(); ++i)
            if (!done_[i] && squared_[i] == farthest_of_all) farthest_.emplace(farthest_of_all, ~i);
    }

    /// The squared distance of the farthest point, which must be there.
    std::uint64_t squared_farthest()
    {
        while (done_[~farthest_.top().second] || squared_[~farthest_.top().second] != farthest_.top().first)
            farthest_.pop();
        return farthest_.top().first;
    }

    std::uint32_t take()
    {
        squared_farthest();
        const std::uint32_t i = ~farthest_.top().second;
        done_[i] = true;
        return i;
    }

private:
    static constexpr std::uint64_t farthest_of_all = std::uint64_t{1} << 62; // half a side

    std::vector<bool> done_;
    PlaceGrid grid_;
    std::vector<std::uint64_t> squared_;
    std::priority_queue<std::pair<std::uint64_t, std::uint32_t>> farthest_;
};

}

std::vector<RecursivePlace> mended_order(std::vector<RankedPlace> points, std::uint32_t count)
{
    std::ranges::sort(points);
    TorusGrid grid(4 * std::size_t{count}, 2);
    std::vector<RecursivePlace> result;
    using Waiting = std::pair<std::uint64_t, std::size_t>; // the turn that it waits for, and which one waits
    std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>> waiting;
    std::size_t next = 0;
    while (result.size() < count && (next < points.size() || !waiting.empty())) {
        std::size_t i = 0;
        if (!waiting.empty() && (waiting.top().first <= result.size() + 1 || next == points.size())) {
            i = waiting.top().second;
            waiting.pop();
        } else {
            i = next++;
        }
        const TorusPosition place = in_a_quarter(points[i].place);
        const std::uint64_t squared = grid.squared_nearest(place); // of lengths that are half as long
        const std::uint64_t turn = squared > UINT64_MAX / 4 ? 1 : points_at_distance(4 * squared);
        if (turn > result.size() + 1 && (next < points.size() || (!waiting.empty() && waiting.top().first < turn))) {
            waiting.emplace(turn, i);
            continue;
        }
        grid.add(place);
        result.push_back(points[i].place);
    }
    return result;
}

std::array<std::vector<std::uint32_t>, even_wang_tiles>
farthest_orders(const RecursivePlaces& places, const std::array<std::vector<bool>, even_wang_tiles>& taken)
{
    std::vector<OpenPoints> tiles;
    for (std::size_t i = 0; i < even_wang_tiles; ++i) tiles.emplace_back(places[i], taken[i]);
    const auto come_near = [&](std::size_t tile, const RecursivePlace& place, std::int64_t reach) {
        visit_views(tile, place, reach,
                    [&](std::size_t by, const PlanePlace& seen) { tiles[by].come_near(seen, reach); });
    };
    const auto of_tile = static_cast<std::size_t>(std::ranges::count(taken[0], true));
    const auto first_reach = static_cast<std::int64_t>(3 * max_min_distance(of_tile, 2) * tile_side);
    for (std::size_t i = 0; i < even_wang_tiles; ++i)
        for (std::size_t k = 0; k < places[i].size(); ++k)
            if (taken[i][k]) come_near(i, places[i][k], first_reach);
    for (OpenPoints& tile : tiles) tile.begin();
    std::array<std::vector<std::uint32_t>, even_wang_tiles> orders;
    for (std::size_t rank = of_tile; rank < places[0].size(); ++rank) {
        std::uint64_t farthest = 0;
        for (OpenPoints& tile : tiles) farthest = std::max(farthest, tile.squared_farthest());
        const auto reach = static_cast<std::int64_t>(std::sqrt(static_cast<double>(farthest))) + 1;
        for (std::size_t i = 0; i < even_wang_tiles; ++i) {
            const std::uint32_t chosen = tiles[i].take();
            orders[i].push_back(chosen);
            come_near(i, places[i][chosen], reach);
        }
    }
    return orders;
}

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
