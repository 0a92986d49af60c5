// Which series a report shows, under what name, and where its pictures go.
#pragma once

#include "reports/drawings/cells_image.hpp"
#include "reports/drawings/points_image.hpp"
#include "reports/layout/construction_pictures.hpp"
#include "reports/layout/tiling_pictures.hpp"
#include "reports/plots/curves.hpp"
#include "reports/plots/integration_curves.hpp"
#include "reports/plots/iteration_curves.hpp"
#include "reports/plots/pair_correlation_curves.hpp"
#include "reports/plots/region_curves.hpp"
#include "reports/plots/zone_plate_curves.hpp"
#include "results/run.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

/// Files of the plots of all series, in the report's folder, without extension.
inline constexpr auto power_overlay = "radial-all";
inline constexpr auto principal_overlay = "radial-principal-all";
inline constexpr auto anisotropy_overlay = "anisotropy-all";
inline constexpr auto pair_correlation_overlay = "pair-correlation-all";
inline constexpr auto radius_overlay = "relative-radius-all";
inline constexpr auto energy_overlay = "energy-all";
inline constexpr auto zone_plate_overlay = "zone-plate-error-all";

/// Files of the plots of integration errors against N: this and the integrand's name.
inline constexpr auto integration_prefix = "integration-";

/// File of the plot of points in regions of tiles, without extension.
inline constexpr auto region_plot = "region-points";

/// The picture of the zone plate that others are compared with, in the report's folder.
inline constexpr auto zone_plate_reference_picture = "zone-plate-reference.png";

/// One series of the report: what is stored, and what was read or drawn for its page.
struct ReportSeries
{
    const Run* run = nullptr; ///< the runs outlive this
    const Series* stored = nullptr;
    std::string label;              ///< as stored, numbers of points formatted
    std::string full_label;         ///< the same, with the run's folder where several runs use that label
    std::filesystem::path pictures; ///< folder of its pictures and its page
    Curve curve;
    std::vector<PairCorrelationBin> pair_correlation; ///< empty for sets of one point
    std::vector<ErrorBin> zone_plate;                 ///< empty for series without the sampling test
    PointsView view;
    std::optional<CellsView> cells; ///< 2D only
};

/// One run of the report.
struct ReportRun
{
    const Run* stored = nullptr;
    std::filesystem::path root; ///< folder of its page, and of the plots of all its series
    std::vector<ReportSeries> series;
    std::vector<ReportTiling> tilings;
    std::vector<ReportConstruction> constructions; ///< with what they show, which lay_out() reads
};

/// The runs in order, as they are stored. With one run that lies in `out`, its pictures go to out and
/// out/<series>, else to out/<name of the run's folder> and below; equal folder names are told apart by a number.
std::vector<ReportRun> lay_out(const std::vector<Run>& runs, const std::filesystem::path& out);

/// Whether the sets of some series are larger than those of others by more than a tenth, or of another
/// dimension; keys then say how many points a series has.
bool sizes_differ(const std::vector<ReportSeries>& series);

/// The curves of the series that have a spectrum, once they are read.
std::vector<Curve> frequency_curves(const std::vector<ReportSeries>& series);

/// The pair correlations of the series that have one; labels as for iterations.
std::vector<PairCorrelationCurve> pair_correlation_curves(const std::vector<ReportSeries>& series);

/// The errors of integrals against N: series that differ only in N are one curve. Empty where no curve has two
/// sizes.
std::vector<IntegrationCurve> integration_curves(const std::vector<ReportSeries>& series);

/// The points in regions of tiles over the number of points a tile.
std::vector<RegionCurve> region_curves(const std::vector<ReportSeries>& series);

/// The iterations of the series that have some, which the series must outlive; labels say how many points a
/// series has where sizes differ.
std::vector<IterationCurve> iteration_curves(const std::vector<ReportSeries>& series);

/// The errors of the series that have sampled the zone plate; labels as for iterations.
std::vector<ZonePlateCurve> zone_plate_curves(const std::vector<ReportSeries>& series);

}
