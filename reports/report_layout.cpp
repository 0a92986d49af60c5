#include "reports/report_layout.hpp"

#include "reports/number_format.hpp"

#include <map>
#include <set>

namespace poissonlab {

namespace fs = std::filesystem;

namespace {

// The last part of a folder's full name, also for "." and "results/".
std::string folder_name(const fs::path& folder)
{
    const auto full = fs::weakly_canonical(folder);
    return full.has_filename() ? full.filename().string() : full.parent_path().filename().string();
}

std::vector<fs::path> picture_roots(const std::vector<StoredRun>& runs, const fs::path& out)
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

std::vector<ReportSeries> lay_out(const std::vector<StoredRun>& runs, const fs::path& out)
{
    const auto roots = picture_roots(runs, out);
    std::map<std::string, int> uses;
    for (const auto& run : runs)
        for (const auto& series : run.series) ++uses[series.label];

    std::vector<ReportSeries> result;
    for (std::size_t i = 0; i < runs.size(); ++i)
        for (const auto& series : runs[i].series) {
            ReportSeries entry;
            entry.run = &runs[i];
            entry.stored = &series;
            const bool ambiguous = runs.size() > 1 && uses[series.label] > 1;
            entry.label = with_formatted_points(series.label);
            if (ambiguous) entry.label += " (" + roots[i].filename().string() + ")";
            entry.pictures = roots[i] / series.name;
            result.push_back(std::move(entry));
        }
    return result;
}

std::vector<Curve> frequency_curves(const std::vector<ReportSeries>& series)
{
    std::vector<Curve> curves;
    for (const auto& entry : series) curves.push_back(entry.curve);
    return curves;
}

std::vector<IterationCurve> iteration_curves(const std::vector<ReportSeries>& series)
{
    const bool with_points = sizes_differ(frequency_curves(series));
    std::vector<IterationCurve> curves;
    for (std::size_t i = 0; i < series.size(); ++i) {
        const auto& stored = *series[i].stored;
        if (!stored.iterations) continue;
        auto label = series[i].label;
        if (with_points) label = label_with_points(label, stored.points);
        curves.push_back({i, label, series[i].run->dimension, &*stored.iterations});
    }
    return curves;
}

std::vector<ZonePlateCurve> zone_plate_curves(const std::vector<ReportSeries>& series)
{
    const bool with_points = sizes_differ(frequency_curves(series));
    std::vector<ZonePlateCurve> curves;
    for (std::size_t i = 0; i < series.size(); ++i) {
        const auto& stored = *series[i].stored;
        if (!stored.zone_plate) continue;
        auto label = series[i].label;
        if (with_points) label = label_with_points(label, stored.points);
        curves.push_back({i, label, stored.zone_plate->size, series[i].zone_plate});
    }
    return curves;
}

}
