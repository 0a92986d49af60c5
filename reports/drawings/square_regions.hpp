// The modified Poisson disk tile regions of a unit square, wherever it lies in a drawing: a quarter of an
// octagon in each corner, a strip along each edge, and the interior.
//
// After Lagae, Tile-Based Methods in Computer Graphics, 2007, figures 4.3 and 4.31: the octagon around a
// corner has its vertices at (+-reach, +-width) and (+-width, +-reach), strips go from `reach` to 1 -
// `reach`. Corners are numbered counterclockwise from the lower left (south-west), edge i goes from corner i
// to the next: south, east, north, west.
//
// The colours of regions and points in pictures of the construction of Poisson tiles.
//
// After Lagae, Tile-Based Methods in Computer Graphics, 2007, figures 4.4 and 4.18: regions have the colours
// of corners or edges, here pale, so that points show; regions between two corners are half and half.
#pragma once

#include "reports/drawings/drawing.hpp"
#include "results/pictures/construction_result.hpp"
#include "tiles/tilings/tile_index.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace poissonlab {

/// A unit square in a drawing, as a parallelogram.
struct DrawnSquare
{
    DrawingPoint corner; ///< the lower left
    DrawingPoint right;  ///< from there to the lower right
    DrawingPoint up;     ///< from there to the upper left

    DrawingPoint at(double x, double y) const
    {
        return {corner[0] + x * right[0] + y * up[0], corner[1] + x * right[1] + y * up[1]};
    }

    /// The place `along` an edge from its first corner and `inwards` from it.
    DrawingPoint beside_edge(std::size_t edge, double along, double inwards) const;

    std::vector<DrawingPoint> outline() const { return {at(0, 0), at(1, 0), at(1, 1), at(0, 1)}; }
};

/// Sizes of regions, in units of the square's side, with width <= reach <= 1/2.
struct RegionSizes
{
    double reach = 0; ///< of octagons along the edges
    double width = 0; ///< of strips, on each side of the edge
};

/// A tile's colours in the order of the corners.
constexpr std::array<Color, 4> corner_colors(const CornerTile& tile)
{
    return {tile.south_west, tile.south_east, tile.north_east, tile.north_west};
}

/// A tile's colours in the order of the edges.
constexpr std::array<Color, 4> edge_colors(const WangTile& tile)
{
    return {tile.south, tile.east, tile.north, tile.west};
}

Shape corner_region(const DrawnSquare& square, RegionSizes sizes, std::size_t corner, const std::string& color);
Shape edge_region(const DrawnSquare& square, RegionSizes sizes, std::size_t edge, const std::string& color);

/// The half of an edge region on the side of the edge's first or second corner.
Shape half_edge_region(const DrawnSquare& square, RegionSizes sizes, std::size_t edge, bool second,
                       const std::string& color);

/// The colour of a corner's half of an edge region: the corner's, but paler.
std::string edge_tint(const std::string& color);

/// Appends thin grey lines around the interior and the edge regions, all there are apart from the square's
/// own outline, which they touch.
void add_region_outlines(std::vector<Shape>& shapes, const DrawnSquare& square, RegionSizes sizes);

/// Sorts shapes by their fills, so that shapes that do not overlap take few paths of an SVG.
void group_by_fill(std::vector<Shape>& shapes);

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
