// Pictures of isohedral tilings, and what is said of each.
#pragma once

#include "host/schemes/mark_canvas.hpp"
#include "host/schemes/scheme_settings.hpp"
#include "results/pictures/distribution_result.hpp"
#include "tiles/isohedral/isohedral_tile.hpp"

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace poissonlab {

/// Polygons of a tile with their colours, in the order in which they are drawn.
using TileParts = std::vector<std::pair<std::vector<PlanePoint>, std::string>>;

/// The part of a tiling that a picture shows, with the first tile in the middle.
struct TilingWindow
{
    double columns = 10, rows = 10; ///< in sides of a square as large as the tile
    PlanePoint right{1, 0};         ///< a vector of length 1 of the tiling, which points to the right in the picture

    std::string caption() const;
};
TilingWindow window_of(const IsohedralSettings& settings);

/// The places of a picture of a tile.
MarkPoint in_window(const TilingWindow& window, const IsohedralTile& tile, const PlanePoint& place);

MarkPicture tiling_picture(const IsohedralTile& tile, const TilingWindow& window,
                           const std::function<TileParts(const TilePlace& place)>& parts_of);

/// Adds facts and numbers of a tiling.
void describe(const IsohedralType& type, const IsohedralTile& tile, DistributionResult& result);

}
