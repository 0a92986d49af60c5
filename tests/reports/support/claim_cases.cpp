#include "tests/reports/support/claim_cases.hpp"

#include <algorithm>
#include <cmath>

namespace poissonlab::test {

ReportSeries& full_darts(MadeUpReport& report, int dimension)
{
    return report.add("dart-throwing", {{"stop", "saturation"}}, 16384, dimension);
}

ReportSeries& darts(MadeUpReport& report, const std::string& rho, std::size_t points, int dimension)
{
    return report.add("dart-throwing", {{"relative_radius", rho}}, points, dimension);
}

ReportSeries& jones(MadeUpReport& report, std::size_t points)
{
    return report.add("voronoi-darts", {{"relative_radius", "0.75"}}, points);
}

ReportSeries& relaxation(MadeUpReport& report, const std::string& factor, const std::string& attempts,
                         std::size_t points, int dimension)
{
    return report.add("relaxation-dart-throwing",
                      {{"initial_radius", "0.15"}, {"factor", factor}, {"attempts", attempts}}, points, dimension);
}

ReportSeries& lloyd(MadeUpReport& report, int iterations, std::size_t points, int dimension)
{
    return report.add("lloyd",
                      {{"iterations", std::to_string(iterations)}, {"start", "dart-throwing (relative_radius = 0.7)"}},
                      points, dimension);
}

void set_number(ReportSeries& series, const std::string& key, double value, double error)
{
    stored_of(series).measures.numbers[key] = {value, error};
}

void set_number(ReportSeries& series, const std::string& key, double value)
{
    set_number(series, key, value, value / 1000);
}

void set_oscillation(ReportSeries& series, double value, double error)
{
    stored_of(series).measures.oscillation = Oscillation{value, 100, 300, error};
}

ReportSeries& with_target(MadeUpReport& report, const std::string& target, double nyquist)
{
    ReportSeries& series =
        report.add("target-spectrum", {{"target", target}, {"frequency", target == "step" ? "0.55" : "0.7"}});
    MadeUpReport::set_curve(series, {});
    set_number(series, "effective_nyquist", nyquist);
    return series;
}

ReportSeries& tiles(MadeUpReport& report, const std::string& kind, int set, int points_per_tile, double mean_peak,
                    double speckle)
{
    auto& series = report.add(kind + "-tiles", {{kind == "template" ? "tiles" : "colors", std::to_string(set)},
                                                {"points_per_tile", std::to_string(points_per_tile)},
                                                {"sets", "3"}});
    MadeUpReport::set_curve(series, {});
    const int side = static_cast<int>(std::lround(std::sqrt(16384.0 / points_per_tile)));
    MadeUpReport::set_peaks(series, side, mean_peak);
    set_number(series, "off_lattice_anisotropy", speckle);
    const double q = 1.0 / side / side, share = mean_peak * q / (mean_peak * q + 1 - q);
    set_number(series, "lattice_share", share, share / 20);
    return series;
}

void have_one_set(ReportSeries& series)
{
    for (auto& [key, value] : stored_of(series).parameters)
        if (key == "sets") value = "1";
}

void set_seconds(ReportSeries& series, double seconds) { stored_of(series).sample_seconds = {seconds}; }

/// Radii from `start` to `end`, there after so many of 128 iterations.
std::vector<double> relaxed(double start, double end, int settled, int iterations)
{
    std::vector<double> radii;
    for (int i = 0; i <= iterations; ++i)
        radii.push_back(start + (end - start) * std::min(1.0, static_cast<double>(i) / settled));
    return radii;
}

std::vector<ClaimCase> all_claim_cases()
{
    std::vector<ClaimCase> all;
    for (const auto& cases :
         {cases_of_tilings(), cases_of_applications(), cases_of_textures(), cases_of_untiled_sets(), cases_of_lloyd(),
          cases_of_early_tiles(), cases_of_edge_tiles(), cases_of_template_tiles(), cases_of_corner_tiles(),
          cases_of_accelerated_darts(), cases_of_spheres(), cases_of_recommendations(), cases_of_later_papers()})
        all.insert(all.end(), cases.begin(), cases.end());
    return all;
}

}
