#include "host/tile_construction/recursive/ranked_points.hpp"

#include "base/geometry/relative_radius.hpp"
#include "host/sampling/classics/torus_grid.hpp"
#include "host/tile_construction/recursive/tile_views.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
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

}
