#include "host/distribution/surfaces/laid_tiles.hpp"

#include "base/errors/errors.hpp"
#include "base/programs/interrupt.hpp"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace poissonlab {
namespace {

/// Tiles that triangles meet, each counted: 3 gigabytes.
constexpr std::size_t most_pairs = std::size_t{1} << 28;

/// A tile with a triangle that points of it may lie in.
struct TileOfTriangle
{
    std::int32_t row, column;
    std::uint32_t triangle; ///< of the plane

    bool is_at(const TileOfTriangle& other) const { return row == other.row && column == other.column; }
    auto operator<=>(const TileOfTriangle&) const = default;
};

/// A point of a tile on a triangle.
struct LaidPoint
{
    std::uint32_t point, triangle;
    std::array<std::uint32_t, 2> shares;
};

struct Extent
{
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    void add(double value)
    {
        low = std::min(low, value);
        high = std::max(high, value);
    }
};

/// The horizontal extent of a triangle between two heights, in units of tiles; doubles round by far less than one.
Extent extent_between(const TextureTriangle& triangle, double low, double high)
{
    const auto unit = [](std::int64_t steps) { return static_cast<double>(steps) / (1 << step_bits); };
    Extent extent;
    for (std::size_t k = 0; k < 3; ++k) {
        const TexturePlace &a = triangle.corners[k], &b = triangle.corners[(k + 1) % 3];
        const double ax = unit(a[0]), ay = unit(a[1]), bx = unit(b[0]), by = unit(b[1]);
        if (ay >= low && ay <= high) extent.add(ax);
        for (const double y : {low, high})
            if ((ay < y) != (by < y)) extent.add(ax + (bx - ax) * ((y - ay) / (by - ay)));
    }
    return extent;
}

class TilesOverTriangles
{
public:
    TilesOverTriangles(const TexturePlane& plane, const PoissonTileSet& tiles, const PoissonTiling& tiling)
        : plane_(plane), tiles_(tiles), tiling_(runtime_tiling(tiles, tiling)), overhang_(overhang_of(tiles))
    {
        for (std::uint32_t t = 0; t < plane.triangles.size(); ++t) add_tiles_of(t);
        std::ranges::sort(pairs_);
        for (std::size_t i = 0; i < pairs_.size(); ++i)
            if (i == 0 || !pairs_[i].is_at(pairs_[i - 1])) first_.push_back(i);
        first_.push_back(pairs_.size());
    }

    std::size_t count() const { return first_.size() - 1; }
    const TileOfTriangle& tile(std::size_t number) const { return pairs_[first_[number]]; }

    /// The points of a tile that lie on triangles, in their order.
    std::vector<LaidPoint> points_of(std::size_t number) const;

    /// The numbers that a tile's points are stored as.
    const std::uint16_t* stored(std::size_t number) const
    {
        return ptiles_points(&tiling_.set, ptiles_tile(&tiling_, tile(number).column, tile(number).row, 0));
    }

    /// The position of a point, in units of tiles.
    TexturePlace position(std::size_t number, std::uint32_t point) const
    {
        const StoredScale scale = stored_scale(tiles_.parameters.border);
        const std::uint16_t* const at = stored(number) + 2 * point;
        return {std::int64_t{tile(number).column} * tile_units + scale.position(at[0]),
                std::int64_t{tile(number).row} * tile_units + scale.position(at[1])};
    }

    double level(std::size_t number, std::uint32_t point) const
    {
        const std::int32_t place[3] = {tile(number).column, tile(number).row, 0};
        return ptiles_point_at(&tiling_, place, point, stored(number) + 2 * point).level;
    }

private:
    std::int32_t first_tile(double unit) const
    {
        return static_cast<std::int32_t>(std::floor((unit - 1 - overhang_.above) / tile_units));
    }
    std::int32_t last_tile(double unit) const
    {
        return static_cast<std::int32_t>(std::floor((unit + 1 + overhang_.below) / tile_units));
    }

    void add_tiles_of(std::uint32_t number)
    {
        const TextureTriangle& triangle = plane_.triangles[number];
        Extent y;
        for (const TexturePlace& corner : triangle.corners) y.add(static_cast<double>(corner[1]) / (1 << step_bits));
        for (std::int32_t row = first_tile(y.low); row <= last_tile(y.high); ++row) {
            const double base = static_cast<double>(row) * tile_units;
            const Extent x =
                extent_between(triangle, base - overhang_.below - 1, base + tile_units + overhang_.above + 1);
            if (x.low > x.high) continue;
            for (std::int32_t column = first_tile(x.low); column <= last_tile(x.high); ++column)
                pairs_.push_back({row, column, number});
            if (pairs_.size() > most_pairs)
                throw InputError(fmt::format("triangles are so thin in texture coordinates that they meet more than {} "
                                             "tiles: fewer tiles help",
                                             most_pairs));
        }
    }

    const TexturePlane& plane_;
    const PoissonTileSet& tiles_;
    ptiles_tiling tiling_;
    Overhang overhang_;
    std::vector<TileOfTriangle> pairs_;
    std::vector<std::size_t> first_; ///< of each tile, its first pair; at the end the number of pairs
};

std::vector<LaidPoint> TilesOverTriangles::points_of(std::size_t number) const
{
    const std::uint32_t count = tiles_.parameters.points_per_tile;
    std::vector<TexturePlace> places(count);
    for (std::uint32_t p = 0; p < count; ++p) {
        const TexturePlace units = position(number, p);
        places[p] = {units[0] << step_bits, units[1] << step_bits};
    }
    std::vector<std::uint32_t> by_height(count);
    std::iota(by_height.begin(), by_height.end(), 0u);
    const auto height = [&](std::uint32_t p) { return places[p][1]; };
    std::ranges::sort(by_height, {}, height);

    std::vector<LaidPoint> laid;
    for (std::size_t i = first_[number]; i < first_[number + 1]; ++i) {
        const TextureTriangle& triangle = plane_.triangles[pairs_[i].triangle];
        const auto [low, high] = std::minmax({triangle.corners[0][1], triangle.corners[1][1], triangle.corners[2][1]});
        const auto end = std::ranges::upper_bound(by_height, high, {}, height);
        for (auto p = std::ranges::lower_bound(by_height, low, {}, height); p != end; ++p)
            if (const auto shares = triangle.shares_at(places[*p])) laid.push_back({*p, pairs_[i].triangle, *shares});
    }
    std::ranges::sort(laid, [](const LaidPoint& a, const LaidPoint& b) {
        return a.point != b.point ? a.point < b.point : a.triangle < b.triangle;
    });
    return laid;
}

SurfacePoint surface_point(const FixedSurface& surface, const TexturePlane& plane, const LaidPoint& laid)
{
    SurfacePoint point{};
    point.triangle = plane.triangles[laid.triangle].triangle;
    point.shares[0] = laid.shares[0];
    point.shares[1] = laid.shares[1];
    const MeshPlace place = place_on(surface.triangles[point.triangle], point.shares[0], point.shares[1]);
    for (std::size_t k = 0; k < 3; ++k) point.place[k] = static_cast<std::int32_t>(place[k]);
    return point;
}

}

LaidPoints lay_tiles(const FixedSurface& surface, const TexturePlane& plane, const PoissonTileSet& tiles,
                     const PoissonTiling& tiling)
{
    const TilesOverTriangles over(plane, tiles, tiling);
    std::vector<std::vector<LaidPoint>> of_tiles(over.count());
    tbb::parallel_for(std::size_t{0}, over.count(), [&](std::size_t tile) {
        stop_if_interrupted();
        of_tiles[tile] = over.points_of(tile);
    });
    LaidPoints result;
    const double unit = 1 / (plane.tiles_per_unit * tile_units);
    for (std::size_t tile = 0; tile < over.count(); ++tile)
        for (std::size_t i = 0; i < of_tiles[tile].size(); ++i) {
            const LaidPoint& laid = of_tiles[tile][i];
            const TexturePlace at = over.position(tile, laid.point);
            result.points.push_back(surface_point(surface, plane, laid));
            result.texture.push_back({static_cast<double>(at[0]) * unit, static_cast<double>(at[1]) * unit});
            result.levels.push_back(over.level(tile, laid.point));
            if (i > 0 && of_tiles[tile][i - 1].point == laid.point) ++result.repetitions;
        }
    return result;
}

std::uint64_t count_laid_points(const TexturePlane& plane, const PoissonTileSet& tiles, const PoissonTiling& tiling)
{
    const TilesOverTriangles over(plane, tiles, tiling);
    return tbb::parallel_reduce(
        tbb::blocked_range<std::size_t>(0, over.count()), std::uint64_t{0},
        [&](const tbb::blocked_range<std::size_t>& range, std::uint64_t sum) {
            stop_if_interrupted();
            for (std::size_t tile = range.begin(); tile != range.end(); ++tile) sum += over.points_of(tile).size();
            return sum;
        },
        std::plus<>());
}

}
