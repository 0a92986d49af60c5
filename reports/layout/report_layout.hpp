// Which series a report shows, under what name, and where its pictures go.
//
// Series whose points follow a density.
#pragma once

#include "analysis/measures/number_variance.hpp"
#include "analysis/measures/pair_correlation.hpp"
#include "analysis/regions/region_curve_row.hpp"
#include "analysis/zone_plate/zone_plate_error.hpp"
#include "reports/layout/distribution_pictures.hpp"
#include "reports/layout/panel.hpp"
#include "reports/layout/tiling_pictures.hpp"
#include "reports/plots/curves.hpp"
#include "results/run.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace poissonlab {

/// The picture of the zone plate that others are compared with, in the report's folder.
inline constexpr auto zone_plate_reference_picture = "zone-plate-reference.png";

/// One series of the report: what is stored, and what was read for its page.
struct ReportSeries
{
    const Run* run = nullptr; ///< the runs outlive this
    const Series* stored = nullptr;
    std::string label;              ///< as stored, numbers of points formatted
    std::string full_label;         ///< the same, with the run's folder where several runs use that label
    std::filesystem::path pictures; ///< folder of its pictures and its page
    Curve curve;
    std::vector<PairCorrelationBin> pair_correlation; ///< empty for sets of one point
    std::vector<NumberVarianceBin> number_variance;   ///< empty for sets of a few points
    std::vector<RegionCurveRow> region_curves;        ///< empty for sets on the torus
    IterationRecords iterations;                      ///< empty for methods without any
    std::vector<ErrorBin> zone_plate;                 ///< empty for series without the sampling test
    std::vector<Panel> panels;                        ///< its pictures, in the order of its page
};

/// One run of the report.
struct ReportRun
{
    const Run* stored = nullptr;
    std::filesystem::path root; ///< folder of its page, and of the plots of all its series
    std::vector<ReportSeries> series;
    std::vector<ReportTiling> tilings;
    std::vector<ReportConstruction> constructions; ///< with what they show, which lay_out() reads
    std::vector<ReportDistribution> distributions;
    std::vector<ReportDistribution> schemes;
    std::vector<Panel> overlays;    ///< plots of all series
    std::vector<Panel> integration; ///< errors of integrals against N, one an integrand
    std::vector<Panel> regions;     ///< points in regions of tiles, where sets differ in size: one plot
    std::vector<Panel> tile_radii;  ///< relative radii within tiles and of tilings, where sets differ in size: one plot
};

/// The runs in order, as they are stored. With one run that lies in `out`, its pictures go to out and
/// out/<series>, else to out/<name of the run's folder> and below; equal folder names are told apart by a number.
std::vector<ReportRun> lay_out(const std::vector<Run>& runs, const std::filesystem::path& out);

/// True where points follow a density that is not the same everywhere: their distances, their spectrum and their
/// directions are those of the density, and say nothing of how even they are.
bool follows_density(const ReportSeries& series);

}
