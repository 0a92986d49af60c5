// The colours of regions and points in pictures of the construction of Poisson tiles.
//
// After Lagae, Tile-Based Methods in Computer Graphics, 2007, figures 4.4 and 4.18: regions have the colours
// of corners or edges, here pale, so that points show; regions between two corners are half and half.
#pragma once

#include "results/pictures/construction_result.hpp"

#include <string>
#include <vector>

namespace poissonlab {

/// A region's part of one colour.
struct ColoredPart
{
    std::vector<ShapeHalfSpace> bounds; ///< that cut it out of the region
    std::string fill;                   ///< "#rrggbb"
};

/// All parts of a piece's region.
std::vector<ColoredPart> colored_parts(const ScenePiece& piece, int dimension);

/// The colour of the lines around a piece's region: the piece's, but dark; grey if it has several.
std::string wire_color(const ScenePiece& piece);

/// The colour of points, and what it is called.
struct PointColor
{
    std::string fill;
    std::string name;
};

const PointColor& point_color(std::size_t point_class);

/// The regions of a panel.
TileRegions regions_of(const Scene& scene, const ScenePanel& panel);

/// A piece's region, as far as the panel shows it.
RegionShape shown_region(const Scene& scene, const ScenePanel& panel, const ScenePiece& piece);

}
