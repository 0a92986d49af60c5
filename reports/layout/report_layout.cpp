#include "reports/layout/report_layout.hpp"

#include "base/geometry/relative_radius.hpp"
#include "reports/words/number_format.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace poissonlab {

namespace fs = std::filesystem;

namespace {

// The last part of a folder's full name, also for "." and "results/".
std::string folder_name(const fs::path& folder)
{
    const auto full = fs::weakly_canonical(folder);
    return full.has_filename() ? full.filename().string() : full.parent_path().filename().string();
}

std::vector<fs::path> picture_roots(const std::vector<Run>& runs, const fs::path& out)
{
    if (runs.size() == 1 && fs::weakly_canonical(runs[0].folder) == fs::weakly_canonical(out)) return {out};
    std::vector<fs::path> roots;
    std::set<std::string> used;
    for (const auto& run : runs) {
        const auto base = folder_name(run.folder);
        auto name = base;
        for (int number = 2; !used.insert(name).second; ++number) name = base + "-" + std::to_string(number);
        roots.push_back(out / name);
    }
    return roots;
}

}

namespace {

ReportRun lay_out_run(const Run& run, const fs::path& root)
{
    ReportRun result;
    result.stored = &run;
    result.root = root;
    for (const auto& series : run.series) {
        ReportSeries entry;
        entry.run = &run;
        entry.stored = &series;
        entry.label = entry.full_label = with_formatted_points(series.label);
        entry.pictures = root / series.name;
        result.series.push_back(std::move(entry));
    }
    for (const auto& tiling : run.tilings) result.tilings.push_back({&run, &tiling, root / tiling.name});
    for (const auto& stored : run.constructions)
        result.constructions.push_back({&run, &stored, read_scene(run.folder / stored.file), root / stored.name});
    return result;
}

}

std::vector<ReportRun> lay_out(const std::vector<Run>& runs, const fs::path& out)
{
    const auto roots = picture_roots(runs, out);
    std::vector<ReportRun> result;
    std::map<std::string, int> uses;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        result.push_back(lay_out_run(runs[i], roots[i]));
        for (const auto& series : result.back().series) ++uses[series.label];
    }
    if (runs.size() == 1) return result;
    for (auto& run : result)
        for (auto& series : run.series)
            if (uses[series.label] > 1) series.full_label += " (" + run.root.filename().string() + ")";
    return result;
}

bool sizes_differ(const std::vector<ReportSeries>& series)
{
    std::vector<Curve> curves;
    for (const auto& entry : series) curves.push_back(entry.curve);
    return sizes_differ(curves);
}

std::vector<Curve> frequency_curves(const std::vector<ReportSeries>& series)
{
    std::vector<Curve> curves;
    for (std::size_t i = 0; i < series.size(); ++i) {
        if (!series[i].stored->has_spectrum()) continue;
        curves.push_back(series[i].curve);
        curves.back().index = i;
    }
    return curves;
}

namespace {

// What the key of a plot of all series calls a series: with its number of points where sizes differ.
std::string key_label(const ReportSeries& series, bool with_points)
{
    return with_points ? label_with_points(series.label, series.stored->points) : series.label;
}

}

std::vector<PairCorrelationCurve> pair_correlation_curves(const std::vector<ReportSeries>& series)
{
    const bool with_points = sizes_differ(series);
    std::vector<PairCorrelationCurve> curves;
    for (std::size_t i = 0; i < series.size(); ++i) {
        if (series[i].pair_correlation.empty()) continue;
        const double unit = max_min_distance(series[i].stored->points, series[i].run->dimension);
        std::optional<double> radius;
        if (series[i].stored->relative_radius) radius = series[i].stored->relative_radius->mean;
        curves.push_back({i, key_label(series[i], with_points), unit, radius, series[i].pair_correlation});
    }
    return curves;
}

namespace {

// What series that differ only in N have in common.
auto method_of(const ReportSeries& series)
{
    NamedTexts parameters = series.stored->parameters;
    std::erase_if(parameters, [](const auto& entry) { return entry.first == "points"; });
    return std::tuple(series.run, series.stored->sampler, parameters,
                      label_without_points(series.label, series.stored->points));
}

// The number of the first series of each series' method.
std::vector<std::size_t> first_of_method(const std::vector<ReportSeries>& series)
{
    std::map<decltype(method_of(series.front())), std::size_t> firsts;
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < series.size(); ++i)
        result.push_back(firsts.try_emplace(method_of(series[i]), i).first->second);
    return result;
}

}

std::vector<IntegrationCurve> integration_curves(const std::vector<ReportSeries>& series)
{
    const auto firsts = first_of_method(series);
    std::vector<IntegrationCurve> curves;
    std::map<std::pair<std::size_t, std::string>, std::size_t> places;
    for (std::size_t i = 0; i < series.size(); ++i)
        for (const auto& integral : series[i].stored->measures.integration) {
            const auto place = places.try_emplace({firsts[i], integral.integrand}, curves.size()).first->second;
            if (place == curves.size())
                curves.push_back({firsts[i],
                                  label_without_points(series[i].label, series[i].stored->points),
                                  integral.integrand,
                                  {}});
            curves[place].samples.push_back(
                {static_cast<double>(series[i].stored->points), integral.rms_error, integral.standard_error});
        }
    for (auto& curve : curves) std::ranges::sort(curve.samples, {}, &IntegrationSample::points);
    std::erase_if(curves,
                  [](const auto& curve) { return curve.samples.front().points == curve.samples.back().points; });
    std::map<std::size_t, std::size_t> numbers; // of the methods that are left
    for (auto& curve : curves) curve.index = numbers.try_emplace(curve.index, numbers.size()).first->second;
    return curves;
}

std::vector<RegionCurve> region_curves(const std::vector<ReportSeries>& series)
{
    std::vector<const Series*> stored;
    for (const auto& entry : series) stored.push_back(entry.stored);
    return region_curves(stored);
}

std::vector<IterationCurve> iteration_curves(const std::vector<ReportSeries>& series)
{
    const bool with_points = sizes_differ(series);
    std::vector<IterationCurve> curves;
    for (std::size_t i = 0; i < series.size(); ++i) {
        const auto& stored = *series[i].stored;
        if (!stored.iterations) continue;
        curves.push_back({i, key_label(series[i], with_points), series[i].run->dimension, &*stored.iterations});
    }
    return curves;
}

std::vector<ZonePlateCurve> zone_plate_curves(const std::vector<ReportSeries>& series)
{
    const bool with_points = sizes_differ(series);
    std::vector<ZonePlateCurve> curves;
    for (std::size_t i = 0; i < series.size(); ++i) {
        const auto& stored = *series[i].stored;
        if (!stored.zone_plate) continue;
        curves.push_back({i, key_label(series[i], with_points), stored.zone_plate->size, series[i].zone_plate});
    }
    return curves;
}

}
