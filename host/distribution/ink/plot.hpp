// Marks on a sheet of paper, for pen plotters and cutters: circles or short strokes in SVG and DXF, in millimetres, in
// an order that makes the way between them short.
//
// From each mark the pen goes to the nearest end that is left, first to the one that is nearest to the upper left
// corner (the nearest-neighbour tour: Rosenkrantz, Stearns and Lewis, 1977).
#pragma once

#include "base/word_table.hpp"
#include "results/pictures/mark_picture.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace poissonlab {

/// A dot is drawn in one of these forms.
enum class DotForm
{
    circles,
    strokes, ///< a hundredth of a unit long, which a pen makes a dot of
};
inline constexpr WordTable<DotForm, 2> dot_forms{{{{DotForm::circles, "circles"}, {DotForm::strokes, "strokes"}}}};

/// The order in which marks are drawn.
enum class PenTravel
{
    nearest,
    as_made, ///< as the sampler made them
};
inline constexpr WordTable<PenTravel, 2> pen_travels{
    {{{PenTravel::nearest, "nearest"}, {PenTravel::as_made, "as-made"}}}};

/// A length on paper as it was typed: "200mm", "20 cm", "8in". Nothing for other texts.
std::optional<double> millimetres_of(std::string_view text);

struct PlotSheet
{
    double width = 0; ///< of the picture, in millimetres; 0: a pixel is a unit
    double pen = 0;   ///< in millimetres; 0: the pen is as wide as marks are
    DotForm dots = DotForm::circles;
    PenTravel travel = PenTravel::nearest;
};

/// Marks in the units of a sheet, from its upper left corner downwards.
struct Plot
{
    double width = 0, height = 0;
    PlotSheet sheet;
    MarkGroup marks;        ///< in the order of travel
    double way = 0;         ///< between marks
    double way_as_made = 0; ///< the same in the sampler's order
    double widest_hole = 0; ///< that the pen leaves in a dot
};

/// The plot of marks in a picture of this size in pixels, y upwards. Throws Interrupted.
Plot plot_of(const MarkGroup& marks, double width, double height, const PlotSheet& sheet);

/// The file for a plotter, and the entities CIRCLE and LINE of AutoCAD's release 12, y upwards.
std::string plot_svg(const Plot& plot);
std::string plot_dxf(const Plot& plot, const std::string& comment);

}
