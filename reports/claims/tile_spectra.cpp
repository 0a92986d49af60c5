#include "reports/claims/tile_spectra.hpp"

#include <algorithm>
#include <utility>

namespace poissonlab {
namespace {

bool is_of_the_papers(const ReportSeries& series)
{
    return !has_chains(series) && number_parameter(series, "joint_iterations").value_or(0) == 0 &&
           number_parameter(series, "density").value_or(1) == 1;
}

}

double points_per_tile(const ReportSeries& series) { return number_parameter(series, "points_per_tile").value_or(0); }

double set_size(const ReportSeries& series) { return *tiles_of_set(series); }

double mean_peak(const ReportSeries& series) { return series.stored->measures.lattice_peaks->mean_ratio; }

double speckle(const ReportSeries& series)
{
    const auto& numbers = series.stored->measures.numbers;
    const auto found = numbers.find("off_lattice_anisotropy");
    return found == numbers.end() ? 0 : found->second.value;
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

}
