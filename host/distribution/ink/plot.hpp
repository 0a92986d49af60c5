// Marks on a sheet of paper, for pen plotters and cutters: circles or short strokes in SVG and DXF, in millimetres, in
// an order that makes the way between them short.
//
// From each mark the pen goes to the nearest end that is left, first to the one that is nearest to the upper left
// corner (the nearest-neighbour tour: Rosenkrantz, Stearns and Lewis, 1977).
#pragma once

#include "host/settings/distributions/distribution_config.hpp"
#include "results/pictures/mark_picture.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace poissonlab {

/// A length on paper as it was typed: "200mm", "20 cm", "8in". Nothing for other texts.
std::optional<double> millimetres_of(std::string_view text);

/// Marks in the units of a sheet, from its upper left corner downwards.
struct Plot
{
    double width = 0, height = 0;
    PlotSheet sheet;
    MarkGroup marks;        ///< in the order of travel
    double way = 0;         ///< between marks
    double way_as_made = 0; ///< the same in the sampler's order
    double widest_hole = 0; ///< that the pen leaves in a dot
    std::size_t narrow = 0; ///< how many marks are narrower than the pen
};

/// The plot of marks in a picture of this size in pixels, y upwards, in the middle of a sheet that is wider by a margin
/// of so many pixels on each side. Throws Interrupted.
Plot plot_of(const MarkGroup& marks, double width, double height, double margin, const PlotSheet& sheet);

/// Tells a person at the plotter the size of the sheet and the way of the pen between marks.
std::string plot_words(const Plot& plot);

/// The file for a plotter, and the entities CIRCLE and LINE of AutoCAD's release 12, y upwards.
std::string plot_svg(const Plot& plot);
std::string plot_dxf(const Plot& plot, const std::string& comment);

}
