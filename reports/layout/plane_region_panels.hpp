// The pictures of points in a region of the plane: their curves beside those of random points.
#pragma once

#include "analysis/regions/region_curve_row.hpp"
#include "reports/layout/panel.hpp"

#include <filesystem>
#include <vector>

namespace poissonlab {

/// The sets that curves are of.
struct RegionSets
{
    double intensity = 0;     ///< points per square of the region's units
    std::size_t envelope = 0; ///< random sets beside them
    bool has_density = false;
    double covariance_error = 0;
    std::filesystem::path file; ///< of the curves
};

/// Curves of a series, or of another set, in the colour of that index.
std::vector<Panel> region_curve_panels(const std::vector<RegionCurveRow>& rows, const RegionSets& sets,
                                       std::size_t index);

}
