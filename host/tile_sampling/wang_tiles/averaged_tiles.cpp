#include "host/tile_sampling/wang_tiles/averaged_tiles.hpp"

#include "base/geometry/convex_cell.hpp"
#include "base/random/random.hpp"
#include "kernels/common/tile_sampling/averaged_tiles.h"
#include "tiles/poisson/tile_regions.hpp"
#include "tiles/tilings/tiling.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace poissonlab {
namespace {

constexpr WangColors two_colors{2, 2};

/// The smallest squared distance of points of a tile from those of another one, so many tiles away.
std::int64_t squared_between(const std::vector<WangPoint>& points, const std::vector<WangPoint>& others, int x, int y)
{
    std::int64_t smallest = std::numeric_limits<std::int64_t>::max();
    for (const WangPoint& p : points)
        for (const WangPoint& q : others) {
            if (&p == &q && x == 0 && y == 0) continue;
            const std::int64_t dx = q[0] + x * tile_units - p[0], dy = q[1] + y * tile_units - p[1];
            smallest = std::min(smallest, dx * dx + dy * dy);
        }
    return smallest;
}

WangPoint rounded_centroid(const ConvexCell& cell)
{
    const auto [x, y] = cell.centroid();
    return {static_cast<std::int32_t>(std::nearbyint(x)), static_cast<std::int32_t>(std::nearbyint(y))};
}

/// Tells whether no point outside of a rectangle around `centre` can reach into the cell.
bool is_known_from(const ConvexCell& cell, const WangPoint& centre, const std::array<std::int32_t, 2>& low,
                   const std::array<std::int32_t, 2>& high)
{
    return std::ranges::all_of(cell.vertices(), [&](const ConvexCell::Vertex& v) {
        double inside = 1e300;
        for (std::size_t k = 0; k < 2; ++k) {
            const double at = centre[k] + v[k];
            inside = std::min({inside, at - low[k], high[k] - at});
        }
        return inside >= std::sqrt(v[0] * v[0] + v[1] * v[1]);
    });
}

/// Cuts by the points of a tile so many tiles away.
void cut_by(ConvexCell& cell, const WangPoint& centre, const std::vector<WangPoint>& points, int x, int y)
{
    for (const WangPoint& point : points)
        cell.cut(point[0] + x * tile_units - centre[0], point[1] + y * tile_units - centre[1]);
}

/// The cell among the points of its own tile.
ConvexCell cell_in_tile(const std::vector<WangPoint>& tile, std::size_t number)
{
    const WangPoint& centre = tile[number];
    ConvexCell cell(contract::averaged_tiles::CELL_REACH);
    for (std::size_t i = 0; i < tile.size(); ++i)
        if (i != number) cell.cut(tile[i][0] - centre[0], tile[i][1] - centre[1]);
    return cell;
}

/// A sum of displacements.
struct Sum
{
    std::int64_t x = 0, y = 0, count = 0;

    void add(const WangPoint& displacement)
    {
        x += displacement[0];
        y += displacement[1];
        ++count;
    }

    WangPoint mean() const
    {
        const auto part = [&](std::int64_t sum) {
            return static_cast<std::int32_t>(std::nearbyint(static_cast<double>(sum) / static_cast<double>(count)));
        };
        return {part(x), part(y)};
    }
};

/// The sum over the 4 x 4 x 2 choices for the three tiles in the quadrant of a point. False: in one of them the cell
/// depends on other tiles as well.
bool sum_over_quadrant(const WangPoints& points, std::size_t tile, std::size_t number, const ConvexCell& own, Sum& sum)
{
    const WangPoint& centre = points.tiles[tile][number];
    std::array<int, 2> sign{};
    std::array<std::int32_t, 2> low{}, high{};
    for (std::size_t k = 0; k < 2; ++k) {
        sign[k] = centre[k] < tile_units / 2 ? -1 : 1;
        low[k] = sign[k] < 0 ? -tile_units : 0;
        high[k] = low[k] + 2 * tile_units;
    }
    for (const std::size_t at_x : tiles_beside(tile, true, sign[0])) {
        ConvexCell with_x = own;
        cut_by(with_x, centre, points.tiles[at_x], sign[0], 0);
        for (const std::size_t at_y : tiles_beside(tile, false, sign[1])) {
            ConvexCell with_both = with_x;
            cut_by(with_both, centre, points.tiles[at_y], 0, sign[1]);
            for (const std::size_t corner : tiles_between(at_x, at_y, sign[0], sign[1])) {
                ConvexCell cell = with_both;
                cut_by(cell, centre, points.tiles[corner], sign[0], sign[1]);
                if (!is_known_from(cell, centre, low, high)) return false;
                sum.add(rounded_centroid(cell));
            }
        }
    }
    return true;
}

/// The sum over all 4,096 surroundings: sides first, then what fits between them.
Sum sum_over_all(const WangPoints& points, std::size_t tile, std::size_t number, const ConvexCell& own)
{
    const WangPoint& centre = points.tiles[tile][number];
    Sum sum;
    const auto corner = [&](const ConvexCell& cell, std::size_t at_x, std::size_t at_y, int x, int y,
                            const auto& next) {
        for (const std::size_t between : tiles_between(at_x, at_y, x, y)) {
            ConvexCell cut = cell;
            cut_by(cut, centre, points.tiles[between], x, y);
            next(cut);
        }
    };
    for (const std::size_t east : tiles_beside(tile, true, 1))
        for (const std::size_t north : tiles_beside(tile, false, 1))
            for (const std::size_t west : tiles_beside(tile, true, -1))
                for (const std::size_t south : tiles_beside(tile, false, -1)) {
                    ConvexCell sides = own;
                    cut_by(sides, centre, points.tiles[east], 1, 0);
                    cut_by(sides, centre, points.tiles[north], 0, 1);
                    cut_by(sides, centre, points.tiles[west], -1, 0);
                    cut_by(sides, centre, points.tiles[south], 0, -1);
                    corner(sides, east, north, 1, 1, [&](const ConvexCell& a) {
                        corner(a, west, north, -1, 1, [&](const ConvexCell& b) {
                            corner(b, west, south, -1, -1, [&](const ConvexCell& c) {
                                corner(c, east, south, 1, -1,
                                       [&](const ConvexCell& cell) { sum.add(rounded_centroid(cell)); });
                            });
                        });
                    });
                }
    return sum;
}

}

std::int64_t squared_distance_within(const WangPoints& points)
{
    std::int64_t smallest = std::numeric_limits<std::int64_t>::max();
    for (const auto& tile : points.tiles) smallest = std::min(smallest, squared_between(tile, tile, 0, 0));
    return smallest;
}

std::int64_t squared_distance_across(const WangPoints& points)
{
    std::int64_t smallest = std::numeric_limits<std::int64_t>::max();
    for (std::size_t tile = 0; tile < wang_point_tiles; ++tile)
        for (std::size_t other = 0; other < wang_point_tiles; ++other)
            for (const auto& [x, y] : {std::pair{1, 0}, std::pair{0, 1}, std::pair{1, 1}, std::pair{1, -1}})
                if (may_lie_beside(tile, other, x, y))
                    smallest = std::min(smallest, squared_between(points.tiles[tile], points.tiles[other], x, y));
    return smallest;
}

PointSet wang_torus(const WangPoints& points, std::uint64_t seed, std::uint32_t side)
{
    const Tiling tiling(DirectAlgorithm::wang_one_hash, two_colors, HashKind::xxh64, seed, {side, side, 0});
    PointSet set{2, {}};
    const double size = static_cast<double>(side) * tile_units;
    for (std::int64_t y = 0; y < side; ++y)
        for (std::int64_t x = 0; x < side; ++x)
            for (const WangPoint& point : points.tiles[even_wang_tile(wang_tile(tiling.tile(x, y), two_colors))])
                for (std::size_t k = 0; k < 2; ++k)
                    set.coordinates.push_back(static_cast<double>((k == 0 ? x : y) * tile_units + point[k]) / size);
    return set;
}

std::vector<std::size_t> tiles_beside(std::size_t tile, bool along_x, int sign)
{
    std::vector<std::size_t> tiles;
    for (std::size_t other = 0; other < wang_point_tiles; ++other)
        if (may_lie_beside(tile, other, along_x ? sign : 0, along_x ? 0 : sign)) tiles.push_back(other);
    return tiles;
}

std::vector<std::size_t> tiles_between(std::size_t at_x, std::size_t at_y, int x, int y)
{
    std::vector<std::size_t> tiles;
    for (std::size_t other = 0; other < wang_point_tiles; ++other)
        if (may_lie_beside(at_x, other, 0, y) && may_lie_beside(at_y, other, x, 0)) tiles.push_back(other);
    return tiles;
}

WangPoint mean_displacement(const WangPoints& points, std::size_t tile, std::size_t number)
{
    const ConvexCell own = cell_in_tile(points.tiles[tile], number);
    Sum sum;
    if (sum_over_quadrant(points, tile, number, own, sum)) return sum.mean();
    return sum_over_all(points, tile, number, own).mean();
}

std::array<std::size_t, 9> random_surrounding(std::size_t tile, std::uint32_t iteration, std::uint64_t seed)
{
    const StreamKey stream = stream_key(seed, Purpose::wang_surroundings, 0);
    const auto sides = philox({static_cast<std::uint32_t>(tile), iteration, 0, 0}, stream);
    const auto corners = philox({static_cast<std::uint32_t>(tile), iteration, 1, 0}, stream);
    const auto chosen = [](const std::vector<std::size_t>& tiles, std::uint32_t random) {
        return tiles[random % tiles.size()];
    };
    const std::size_t east = chosen(tiles_beside(tile, true, 1), sides[0]);
    const std::size_t north = chosen(tiles_beside(tile, false, 1), sides[1]);
    const std::size_t west = chosen(tiles_beside(tile, true, -1), sides[2]);
    const std::size_t south = chosen(tiles_beside(tile, false, -1), sides[3]);
    return {chosen(tiles_between(west, south, -1, -1), corners[0]),
            south,
            chosen(tiles_between(east, south, 1, -1), corners[1]),
            west,
            tile,
            east,
            chosen(tiles_between(west, north, -1, 1), corners[2]),
            north,
            chosen(tiles_between(east, north, 1, 1), corners[3])};
}

WangPoint moved_in_tile(const WangPoint& point, const WangPoint& by)
{
    return {std::clamp(point[0] + by[0], 0, tile_units - 1), std::clamp(point[1] + by[1], 0, tile_units - 1)};
}

WangPoints moved_tiles(const WangPoints& points,
                       const std::function<WangPoint(std::size_t tile, std::size_t number)>& displacement)
{
    WangPoints result = points;
    for (std::size_t tile = 0; tile < wang_point_tiles; ++tile)
        tbb::parallel_for(std::size_t{0}, points.tiles[tile].size(), [&](std::size_t i) {
            result.tiles[tile][i] = moved_in_tile(points.tiles[tile][i], displacement(tile, i));
        });
    return result;
}

WangPoints start_averaged_tiles(std::uint32_t points_per_tile, std::uint64_t seed)
{
    const StreamKey stream = stream_key(seed, Purpose::wang_starts, 0);
    WangPoints points;
    for (std::uint32_t tile = 0; tile < wang_point_tiles; ++tile)
        for (std::uint32_t i = 0; i < points_per_tile; ++i) {
            const auto words = philox({tile, i, 0, 0}, stream);
            constexpr std::int32_t quarter = tile_units / 4;
            points.tiles[tile].push_back({quarter + static_cast<std::int32_t>(words[0] >> 17),
                                          quarter + static_cast<std::int32_t>(words[1] >> 17)});
        }
    return points;
}

WangPoint centroid_displacement(const WangPoints& points, std::span<const std::size_t, 9> tiles, std::size_t point)
{
    const WangPoint& centre = points.tiles[tiles[4]][point];
    ConvexCell cell = cell_in_tile(points.tiles[tiles[4]], point);
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x)
            if (x != 0 || y != 0)
                cut_by(cell, centre, points.tiles[tiles[static_cast<std::size_t>(3 * (y + 1) + x + 1)]], x, y);
    return rounded_centroid(cell);
}

WangPoints average_once(const WangPoints& points, AveragedVariant variant, std::uint32_t iteration, std::uint64_t seed)
{
    if (variant == AveragedVariant::exact)
        return moved_tiles(points, [&](std::size_t tile, std::size_t i) { return mean_displacement(points, tile, i); });
    WangPoints result = points;
    for (std::size_t tile = 0; tile < wang_point_tiles; ++tile) {
        const auto around = random_surrounding(tile, iteration, seed);
        std::vector<WangPoint> next;
        for (std::size_t i = 0; i < result.tiles[tile].size(); ++i)
            next.push_back(moved_in_tile(result.tiles[tile][i], centroid_displacement(result, around, i)));
        result.tiles[tile] = next;
    }
    return result;
}

}
