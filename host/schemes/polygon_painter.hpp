// Draws tiles of tilings by polygons: with straight edges or curves, arcs where tiles match, and letters of edges.
#pragma once

#include "host/schemes/mark_canvas.hpp"
#include "host/schemes/scheme_settings.hpp"
#include "tiles/prototiles/polygon_tiling.hpp"

#include <array>
#include <span>

namespace poissonlab {

/// The part of a tiling that a picture shows. Places are taken as exact differences from `middle`, and so are right
/// however far from the origin they are.
struct PolygonView
{
    RingPlace middle;
    std::array<double, 2> shift{}; ///< of the middle, from the picture's lower left corner, in units of the picture
    double unit = 1;               ///< length, in the tiling, of the picture's unit
};

class PolygonPainter
{
public:
    PolygonPainter(MarkCanvas& canvas, const PolygonTiling& tiling, const PolygonStyle& style, PolygonView view)
        : canvas_(canvas), tiling_(tiling), style_(style), view_(view)
    {}

    /// Fills all tiles first, then draws outlines over them, and then what else they have.
    void paint(std::span<const PlacedTile> tiles);

    MarkPoint at(const RingPlace& place) const;

    /// The outline of a tile, its edges as the style has them.
    std::vector<MarkPoint> outline(const PlacedTile& tile) const;

private:
    /// A vertex of an outline, and the letter of the edge from it to the next one.
    struct Vertex
    {
        MarkPoint place;
        char letter = 0;
    };

    std::string color_of(const PlacedTile& tile) const;
    std::vector<Vertex> vertices_of(const PlacedTile& tile) const;
    MarkPoint shifted(const PlacedTile& tile, const ShiftedPlace& vertex) const;
    const PlaneCurve& curve_of(char small_letter) const;
    void paint_arcs(const PlacedTile& tile);
    void paint_letters(const PlacedTile& tile);

    MarkCanvas& canvas_;
    const PolygonTiling& tiling_;
    const PolygonStyle& style_;
    PolygonView view_;
};

/// The side of a square as large as the first prototile, for tiles that are `scale` times as large as prototiles: the
/// unit of pictures.
double picture_unit(const PolygonTiling& tiling, double scale);

/// The low and high corner of a box around tiles, in units of their view.
std::array<MarkPoint, 2> box_around(const PolygonPainter& painter, std::span<const PlacedTile> tiles);

/// Returns the smallest box that holds a box and a point.
std::array<MarkPoint, 2> box_with(std::array<MarkPoint, 2> box, const MarkPoint& point);

/// Pixels of a unit in a picture of this width.
double pixels_a_unit(double width);

}
