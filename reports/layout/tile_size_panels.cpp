// The plots of tile sets over their number of points a tile.
#include "reports/layout/overlay_panels.hpp"
#include "reports/plots/tile_size_curves.hpp"

namespace poissonlab {
namespace {

std::vector<const Series*> stored_series(const SeriesList& series)
{
    std::vector<const Series*> stored;
    for (const auto& entry : series) stored.push_back(entry.series->stored);
    return stored;
}

}

std::vector<Panel> region_panels(const SeriesList& series)
{
    const auto curves = region_curves(stored_series(series));
    if (curves.empty()) return {};
    return {{"region-points", region_points_plot(curves), "Points in the regions of tiles",
             "over the number of points a tile"}};
}

std::vector<Panel> tile_radius_panels(const SeriesList& series)
{
    const auto curves = tile_radius_curves(stored_series(series));
    if (curves.empty()) return {};
    return {{"tile-radius", tile_radius_plot(curves), "Relative radius within tiles (dots) and of tilings (lines)",
             "over the number of points a tile"}};
}

}
