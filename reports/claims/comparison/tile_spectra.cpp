#include "reports/claims/comparison/tile_spectra.hpp"

#include <cmath>

namespace poissonlab {
namespace {

bool is_of_the_papers(const ReportSeries& series)
{
    return !has_chains(series) && number_parameter(series, "joint_iterations").value_or(0) == 0 &&
           number_parameter(series, "density").value_or(1) == 1;
}

/// The share of all frequencies that are on the lattice.
std::optional<double> frequencies_on_lattice(const ReportSeries& series)
{
    const auto& peaks = series.stored->measures.lattice_peaks;
    if (!peaks) return std::nullopt;
    return std::pow(static_cast<double>(peaks->tiles), -series.run->dimension);
}

}

double points_per_tile(const ReportSeries& series) { return number_parameter(series, "points_per_tile").value_or(0); }

double set_size(const ReportSeries& series) { return *tiles_of_set(series); }

Estimate mean_peak(const ReportSeries& series)
{
    const LatticePeaks& peaks = *series.stored->measures.lattice_peaks;
    return {peaks.mean_ratio, peaks.mean_ratio_standard_error};
}

std::optional<Estimate> lattice_share(const ReportSeries& series)
{
    const Estimate* const found = estimate_of(series, "lattice_share");
    return found == nullptr ? std::nullopt : std::optional(*found);
}

std::optional<double> predicted_lattice_share(const ReportSeries& series)
{
    const auto q = frequencies_on_lattice(series);
    const auto& set = series.stored->tile_set;
    if (!q || !set || !set->shared_points) return std::nullopt;
    return *set->shared_points + *q * (1 - *set->shared_points);
}

std::optional<double> speckle(const ReportSeries& series)
{
    const Estimate* const found = estimate_of(series, "off_lattice_anisotropy");
    return found == nullptr ? std::nullopt : std::optional(found->value);
}

bool has_chains(const ReportSeries& series)
{
    const NamedTexts& given = series.stored->parameters;
    return std::ranges::find(given, std::pair<std::string, std::string>("border", "chain")) != given.end();
}

std::vector<SeriesPointer> tiling_spectra(const ClaimSeries& report, const std::string& sampler)
{
    auto found = report.all({.sampler = sampler, .points = usual_points, .needs = SeriesQuery::Needs::spectrum});
    std::erase_if(found, [](SeriesPointer series) {
        return !series->stored->measures.lattice_peaks || !tiles_of_set(*series) || series->stored->realizations < 2 ||
               !is_of_the_papers(*series);
    });
    return found;
}

std::vector<SeriesPointer> tiling_plates(const ClaimSeries& report, const std::string& sampler)
{
    auto found = report.all({.sampler = sampler, .points = plate_points, .needs = SeriesQuery::Needs::plate});
    std::erase_if(found, [](SeriesPointer series) { return !tiles_of_set(*series) || !is_of_the_papers(*series); });
    return found;
}

Finding TileSetFlag::if_several(std::initializer_list<SeriesPointer> series, Finding finding)
{
    if (std::ranges::all_of(series, [](SeriesPointer one) { return tile_sets_of(*one) > 1; })) return finding;
    has_single_ = true;
    return Finding::open;
}

std::string TileSetFlag::words() const
{
    return has_single_ ? "cases of one tile set (sets = 1) are open: errors between sets are not known" : "";
}

std::optional<Finding> has_weaker_plates(const ClaimSeries& report, const ReportSeries& first,
                                         const ReportSeries& second)
{
    const auto a = report.false_rings(first), b = report.false_rings(second);
    if (!a || !b) return std::nullopt;
    if (std::abs(a->strength - b->strength) <= std::max(a->bound, b->bound)) return Finding::open;
    return finding_if(a->strength < b->strength);
}

}
