#include "reports/layout/series_curves.hpp"

#include "base/geometry/relative_radius.hpp"
#include "results/curve_tables.hpp"
#include "results/periodograms.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

namespace poissonlab {

namespace {

/// The label that series have in common that differ only in N.
auto method_of(const NamedSeries& named)
{
    const ReportSeries& series = *named.series;
    NamedTexts parameters = series.stored->parameters;
    std::erase_if(parameters, [](const auto& entry) { return entry.first == "points"; });
    return std::tuple(series.run, series.stored->sampler, parameters,
                      label_without_points(named.label, series.stored->points));
}

/// The number of the first series of each series' method.
std::vector<std::size_t> first_of_method(const SeriesList& series)
{
    std::map<decltype(method_of(series.front())), std::size_t> firsts;
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < series.size(); ++i)
        result.push_back(firsts.try_emplace(method_of(series[i]), i).first->second);
    return result;
}

}

SeriesList series_of(const ReportRun& run)
{
    SeriesList list;
    for (const auto& series : run.series) list.push_back({&series, series.label});
    return list;
}

LengthUnit common_unit(const SeriesList& series)
{
    if (series.empty()) return LengthUnit::absolute;
    const auto points = [](const NamedSeries& entry) { return entry.series->stored->points; };
    const auto dimension = [](const NamedSeries& entry) { return entry.series->run->dimension; };
    const auto [fewest, most] = std::ranges::minmax(series, {}, points);
    const auto [flattest, deepest] = std::ranges::minmax(series, {}, dimension);
    const bool differ = dimension(flattest) != dimension(deepest) || 10 * points(most) > 11 * points(fewest);
    return differ ? LengthUnit::spacing : LengthUnit::absolute;
}

SeriesList with_points_in_names(SeriesList series)
{
    if (common_unit(series) == LengthUnit::spacing)
        for (auto& entry : series) entry.label = label_with_points(entry.label, entry.series->stored->points);
    return series;
}

Curve read_curve(const Run& run, const Series& stored)
{
    Curve curve;
    curve.points = stored.points;
    curve.dimension = run.dimension;
    if (stored.has_spectrum()) curve.bins = read_radial_table(run.folder / stored.radial_file);
    curve.background_db = stored.background_anisotropy_db;
    curve.periodograms = periodograms_of(stored);
    if (stored.min_distance && stored.min_distance->mean > 0) curve.principal_frequency = 1 / stored.min_distance->mean;
    if (stored.spectrum_size > 0)
        curve.max_frequency = spectrum_reach(stored);
    else if (stored.has_spectrum())
        curve.max_frequency = curve.bins.back().frequency;
    return curve;
}

std::vector<NumberedCurve> frequency_curves(const SeriesList& series)
{
    std::vector<NumberedCurve> curves;
    for (std::size_t i = 0; i < series.size(); ++i)
        if (series[i].series->stored->has_spectrum()) curves.push_back({i, series[i].label, &series[i].series->curve});
    return curves;
}

std::vector<NumberedCurve> principal_curves(const SeriesList& series)
{
    auto curves = frequency_curves(series);
    std::erase_if(curves, [](const NumberedCurve& curve) { return !curve.curve->has_principal_in_sight(); });
    return curves;
}

std::vector<PairCorrelationCurve> pair_correlation_curves(const SeriesList& series)
{
    std::vector<PairCorrelationCurve> curves;
    for (std::size_t i = 0; i < series.size(); ++i) {
        const ReportSeries& entry = *series[i].series;
        if (entry.pair_correlation.empty()) continue;
        const double unit = max_min_distance(entry.stored->points, entry.run->dimension);
        curves.push_back({i, series[i].label, unit, &entry.pair_correlation});
    }
    return curves;
}

std::vector<NumberVarianceCurve> number_variance_curves(const SeriesList& series)
{
    std::vector<NumberVarianceCurve> curves;
    for (std::size_t i = 0; i < series.size(); ++i) {
        const ReportSeries& entry = *series[i].series;
        if (!entry.number_variance.empty())
            curves.push_back({i, series[i].label, entry.stored->points, entry.run->dimension, &entry.number_variance});
    }
    return curves;
}

bool has_own_energy(const ReportSeries& series)
{
    return series.stored->sampler == "gaussian-blue-noise" || series.stored->sampler == "target-spectrum";
}

std::vector<IterationCurve> iteration_curves(const SeriesList& series)
{
    std::vector<IterationCurve> curves;
    for (std::size_t i = 0; i < series.size(); ++i)
        if (const auto& iterations = series[i].series->stored->iterations)
            curves.push_back({.index = i,
                              .label = series[i].label,
                              .dimension = series[i].series->run->dimension,
                              .stored = &*iterations,
                              .is_own_energy = has_own_energy(*series[i].series)});
    return curves;
}

std::vector<IterationCurve> energy_curves(const SeriesList& series, bool are_own)
{
    std::vector<IterationCurve> curves = iteration_curves(series);
    std::erase_if(curves, [&](const IterationCurve& curve) {
        const auto& energies = curve.stored->energy.mean;
        const bool has_none = std::ranges::all_of(energies, [](double energy) { return energy == 0; });
        return has_none || curve.is_own_energy != are_own;
    });
    return curves;
}

std::vector<ZonePlateCurve> zone_plate_curves(const SeriesList& series)
{
    std::vector<ZonePlateCurve> curves;
    for (std::size_t i = 0; i < series.size(); ++i)
        if (const auto& plate = series[i].series->stored->zone_plate)
            curves.push_back({i, series[i].label, plate->size, &series[i].series->zone_plate});
    return curves;
}

std::vector<IntegrationCurve> integration_curves(const SeriesList& series)
{
    const auto firsts = first_of_method(series);
    std::vector<IntegrationCurve> curves;
    std::map<std::pair<std::size_t, std::string>, std::size_t> places;
    for (std::size_t i = 0; i < series.size(); ++i) {
        const Series& stored = *series[i].series->stored;
        for (const auto& integral : stored.measures.integration) {
            const auto place = places.try_emplace({firsts[i], integral.integrand}, curves.size()).first->second;
            if (place == curves.size())
                curves.push_back(
                    {firsts[i], label_without_points(series[i].label, stored.points), integral.integrand, {}});
            curves[place].samples.push_back(
                {static_cast<double>(stored.points), integral.rms_error, integral.standard_error});
        }
    }
    for (auto& curve : curves) std::ranges::sort(curve.samples, {}, &IntegrationSample::points);
    std::erase_if(curves,
                  [](const auto& curve) { return curve.samples.front().points == curve.samples.back().points; });
    std::map<std::size_t, std::size_t> numbers; // of the methods that are left
    for (auto& curve : curves) curve.index = numbers.try_emplace(curve.index, numbers.size()).first->second;
    return curves;
}

}
