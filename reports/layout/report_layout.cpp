#include "reports/layout/report_layout.hpp"

#include "reports/words/number_format.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace poissonlab {

namespace fs = std::filesystem;

namespace {

/// The last part of a folder's full name, also for "." and "results/".
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
    for (const auto& stored : run.distributions) result.distributions.push_back({&run, &stored, root / stored.name});
    for (const auto& stored : run.schemes) result.schemes.push_back({&run, &stored, root / stored.name});
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

bool follows_density(const ReportSeries& series)
{
    if (series.stored->region && series.stored->region->has_density) return true;
    return std::ranges::any_of(series.stored->parameters, [](const auto& parameter) {
        return is_followed_density(parameter.first, parameter.second);
    });
}

}
