// A region of the plane that is filled with the points of a Poisson disk tiling, in the region's own units.
//
// A tile is so many units wide that the proven minimum distance of the tile set becomes the one that is asked for. Tile
// (0, 0) begins at the origin of the region's coordinates, so that regions beside each other, of one seed and one
// scale, are parts of one endless set: what lies on either side of their border fits.
#pragma once

#include "base/regions/fixed_region.hpp"
#include "host/tile_points/tile_points.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace poissonlab {

/// The units of the region that a tile is wide at least, so that distances that are computed from written coordinates
/// are never below `min_distance`. Throws InputError, a line about the tile set, where it has no proven distance.
double tile_width_for(double min_distance, const PoissonTileSet& tiles, const RegionBox& box);

/// The minimum distance of points in the region's units, in tiles of this width: what tile_width_for() is given.
double min_distance_in(double tile_width, const PoissonTileSet& tiles, const RegionBox& box);

class TiledRegion
{
public:
    /// `tile_width` in units of the region. Throws InputError, a sentence, where so many tiles have no place in a
    /// tiling.
    TiledRegion(std::shared_ptr<const FixedRegion> region, double tile_width);

    /// All tiles whose points may lie in the region, also those of tiles with chains.
    const TileBlock& block() const { return block_; }

    double tile_width() const { return tile_width_; }
    const FixedRegion& region() const { return *region_; }

    /// Appends the coordinates of a point of the block, given as its integer position, and says so, unless it lies
    /// outside.
    bool append_if_inside(std::span<const std::uint32_t> units, std::vector<double>& coordinates) const;

private:
    std::shared_ptr<const FixedRegion> region_;
    double tile_width_;
    TileBlock block_;
};

/// The number of points that a region has with tiles of a width.
using PointsAtWidth = std::function<std::uint64_t(double tile_width)>;

/// A width of tiles with which the region has so many points: found by secants and halving, from `guess` on. Wider
/// tiles have fewer points, nearly. The number nearest to it where chance lets no width have exactly so many.
double tile_width_for_points(std::uint64_t points, double guess, const PointsAtWidth& points_at);

}
