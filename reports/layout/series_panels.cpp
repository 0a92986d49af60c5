#include "reports/layout/series_panels.hpp"

#include "base/errors/errors.hpp"
#include "base/text/noun.hpp"
#include "reports/words/number_format.hpp"
#include "results/stored_points.hpp"

#include <fmt/format.h>

namespace poissonlab {

namespace {

PointSet first_realization(const ReportSeries& series)
{
    const auto file = series.run->folder / series.stored->point_files.front();
    auto sets = read_stored_points(*series.stored, file);
    const std::size_t points = series.stored->points_of_first();
    if (sets.empty() || sets.front().size() != points || sets.front().dimension != series.run->dimension)
        throw InputError(file.string() + ": must hold " + std::to_string(points) + " points with " +
                         std::to_string(series.run->dimension) + " coordinates, as results.json says");
    return std::move(sets.front());
}

Panel points_panel(const ReportSeries& series, const PointSet& points)
{
    const auto view = choose_points_view(points, series.stored->box ? series.stored->box->box() : PeriodicBox{});
    const auto side = format_significant(view.window, 2);
    auto caption = view.shown() == view.total
                       ? fmt::format("All {} {}", format_count(view.total), noun(view.total, "point"))
                       : fmt::format("{} of {} points", format_count(view.shown()), format_count(view.total));
    std::string guide =
        "A good set looks even but not regular. Clumps and holes waste samples; rows and repetition appear in sampled "
        "pictures as patterns that are not there.";
    if (points.dimension == 3) {
        caption += fmt::format(": a slab of the {}, z below {}, seen along z", series.stored->box ? "box" : "cube",
                               format_significant(view.depth, 2));
        guide += " Of a cube a slab is shown, as thick as the largest possible minimum distance: points that lie above "
                 "each other may touch.";
    }
    if (view.window < 1)
        caption += series.stored->box ? fmt::format(": {} of each side, at the lower left", side)
                                      : fmt::format(": the window of {0} × {0} at the lower left", side);
    return {.stem = "points",
            .picture = view,
            .title = "Points",
            .caption = caption + first_of_several(series) + ".",
            .guide = guide,
            .thumbnail = Thumbnail{"points", "Points"},
            .image_class = "ink framed"};
}

Panel cells_panel(const ReportSeries& series, const PointSet& points)
{
    const auto view = choose_cells_view(points);
    auto caption = fmt::format("Neighbours of {} {}", format_count(view.cells.size()), noun(view.cells.size(), "cell"));
    if (view.window < 1)
        caption += fmt::format(" in the window of {0} × {0} at the lower left", format_significant(view.window, 2));
    caption += series.stored->measures.voronoi ? "; shares are of all cells of the set" : "; shares are of these cells";
    return {
        .stem = "cells",
        .picture = view,
        .title = "Voronoi cells",
        .caption = caption + first_of_several(series) + ".",
        .guide =
            "The Voronoi cell of a point consists of all places that are nearer to it than to any other point. In a "
            "hexagonal lattice every cell has 6 neighbours. Cells with 5 and 7 neighbours break up rows: a good set "
            "has many of them, evenly mixed and in about equal numbers. Long chains of them are boundaries between "
            "parts in which points lie in rows.",
        .image_class = "framed"};
}

}

std::string first_of_several(const ReportSeries& series)
{
    const int realizations = series.stored->realizations;
    return realizations > 1 ? fmt::format(" (first of {} realizations)", realizations) : std::string();
}

RunPlots run_plots(const ReportRun& run)
{
    const auto series = series_of(run);
    const auto frequencies = frequency_curves(series);
    RunPlots plots{power_plot(frequencies, LengthUnit::absolute),
                   structure_factor_plot(frequencies, LengthUnit::absolute),
                   anisotropy_plot(frequencies, LengthUnit::absolute),
                   pair_correlation_plot(pair_correlation_curves(series), packing_distance),
                   number_variance_plot(number_variance_curves(series)),
                   {},
                   {},
                   {},
                   {}};
    if (const auto curves = iteration_curves(series); !curves.empty()) {
        plots.radius = relative_radius_plot(curves);
    }
    if (const auto curves = energy_curves(series, false); !curves.empty()) plots.energy = energy_plot(curves);
    if (const auto curves = energy_curves(series, true); !curves.empty()) plots.own_energy = energy_plot(curves);
    if (const auto curves = zone_plate_curves(series); !curves.empty()) plots.plate = zone_plate_plot(curves);
    return plots;
}

std::vector<Panel> series_panels(const ReportRun& run, std::size_t index, const RunPlots& plots)
{
    const ReportSeries& series = run.series[index];
    const bool has_points = !series.stored->point_files.empty(); // sets that were read in pieces are not stored
    const PointSet points = has_points ? first_realization(series) : PointSet{};
    const bool is_in_region = series.stored->region && !series.stored->region->picture_file.empty();
    std::vector<Panel> panels;
    if (has_points) panels.push_back(is_in_region ? region_points_panel(series) : points_panel(series, points));
    add_spectrum_panel(series, panels);
    add_curve_panels(series, index, plots, panels);
    add_autocorrelation_panel(series, panels);
    add_folded_density_panel(series, panels);
    add_region_panels(series, index, panels);
    if (has_points && points.dimension == 2 && !series.stored->region && !series.stored->box)
        panels.push_back(cells_panel(series, points));
    add_space_panels(series, panels);
    add_iteration_panels(series, index, plots, panels);
    add_zone_plate_panels(run, index, plots, panels);
    return panels;
}

}
