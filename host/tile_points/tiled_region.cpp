#include "host/tile_points/tiled_region.hpp"

#include "base/errors/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace poissonlab {
namespace {

/// Blocks have up to 65,536 tiles along an axis, one of which lies on either side of the region.
constexpr double most_tiles = 65'534;

/// The proven distance in tiles.
double proven_distance(const PoissonTileSet& tiles)
{
    if (tiles.squared_min_distance == 0)
        throw InputError("the tile set has no proven minimum distance, from which the scale follows");
    return std::sqrt(static_cast<double>(tiles.squared_min_distance)) / units_per_tile;
}

/// Widths are looked at no further when they are so near to each other.
constexpr double same_width = 1e-13;

constexpr int most_widths = 100;

}

double tile_width_for(double min_distance, const PoissonTileSet& tiles, const RegionBox& box)
{
    return (min_distance + distance_rounding(min_distance, box)) / proven_distance(tiles);
}

double min_distance_in(double tile_width, const PoissonTileSet& tiles, const RegionBox& box)
{
    const double distance = tile_width * proven_distance(tiles);
    return distance - 2 * distance_rounding(distance, box);
}

TiledRegion::TiledRegion(std::shared_ptr<const FixedRegion> region, double tile_width)
    : region_(std::move(region)), tile_width_(tile_width)
{
    const RegionBox& box = region_->box();
    for (std::size_t k = 0; k < 2; ++k) {
        const double first = std::floor(box.low[k] / tile_width), last = std::floor(box.high[k] / tile_width);
        constexpr double most = std::numeric_limits<std::int32_t>::max() - 2;
        if (!(std::abs(first) < most && std::abs(last) < most))
            throw InputError(
                fmt::format("with tiles of {:.4g} units it lies {:.3g} tiles from 0: must be less than 2^31",
                            tile_width, std::max(std::abs(first), std::abs(last))));
        if (last - first + 1 > most_tiles)
            throw InputError(fmt::format("takes {:.0f} tiles of {:.4g} units along an axis: must be at most {}",
                                         last - first + 1, tile_width, most_tiles));
        block_.lowest[k] = static_cast<std::int32_t>(first) - 1;
        block_.size[k] = static_cast<std::uint32_t>(last - first) + 3;
    }
}

/// Positions below the block are large ones, modulo 2^32, far from the region.
bool TiledRegion::append_if_inside(std::span<const std::uint32_t> units, std::vector<double>& coordinates) const
{
    std::array<double, 2> place;
    for (std::size_t k = 0; k < 2; ++k) {
        const std::int64_t whole = std::int64_t{block_.lowest[k]} * units_per_tile + units[k];
        place[k] = tile_width_ / units_per_tile * static_cast<double>(whole);
    }
    if (!region_->contains_place(place)) return false;
    coordinates.insert(coordinates.end(), place.begin(), place.end());
    return true;
}

double tile_width_for_points(std::uint64_t points, double guess, const PointsAtWidth& points_at)
{
    double narrow = 0, wide = std::numeric_limits<double>::infinity(); // with too many points, with too few
    double best = guess, width = guess;
    double best_gap = std::numeric_limits<double>::infinity();
    for (int i = 0; i < most_widths; ++i) {
        const std::uint64_t found = points_at(width);
        const double gap = std::abs(static_cast<double>(found) - static_cast<double>(points));
        if (gap < best_gap) {
            best_gap = gap;
            best = width;
        }
        if (found == points) break;
        (found > points ? narrow : wide) = width;
        if (wide - narrow < same_width * narrow) break;
        const double ratio = static_cast<double>(found) / static_cast<double>(points);
        width *= std::clamp(std::sqrt(ratio), 0.5, 2.0);
        if (!(width > narrow && width < wide) || i % 3 == 2)
            width = narrow == 0 ? wide / 2 : std::isinf(wide) ? narrow * 2 : std::sqrt(narrow) * std::sqrt(wide);
    }
    return best;
}

}
