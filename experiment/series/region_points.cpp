#include "experiment/series/region_points.hpp"

#include "base/regions/region_source.hpp"
#include "experiment/series/imported_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace poissonlab {

std::vector<std::string> region_notes(const Experiment& experiment)
{
    std::vector<std::string> notes;
    const auto add = [&](const std::optional<RegionOptions>& options) {
        if (!options) return;
        for (const std::string& note : notes_of(options->region->own_polygons()))
            if (std::ranges::find(notes, note) == notes.end()) notes.push_back(note);
    };
    add(experiment.analysis.region);
    for (const SeriesTask& task : experiment.series) add(task.region);
    return notes;
}

Experiment import_region_points(const std::vector<std::filesystem::path>& files, const std::string& label,
                                const FramedRegion& region, const PointReading& asked)
{
    std::vector<PointSet> sets;
    std::vector<std::string> paths, notes;
    PointReading how = asked;
    how.domain = any_coordinates;
    how.degrees_sentence = degrees_sentence(region.own_polygons());
    how.told = [&](const std::string& sentence) { notes.push_back(sentence); };
    for (const auto& file : files)
        if (std::filesystem::is_directory(file))
            throw InputError(file.string() + ": is a folder; files of points are needed");
    for (const auto& file : without_further_parts(files, how.told)) {
        std::vector<PointSet> read = read_points(file, how);
        for (std::size_t i = 0; i < read.size(); ++i) // throws where some are outside
            region.framed(read[i],
                          read.size() == 1 ? file.string() : fmt::format("{}: realization {}", file.string(), i + 1));
        std::ranges::move(read, std::back_inserter(sets));
        paths.push_back(file.string());
    }
    Experiment experiment = import_sets(sets, label.empty() ? files.front().stem().string() : label);
    experiment.notes = notes;
    SeriesTask& task = experiment.series.front();
    task.parameters.set("path", paths);
    task.identity = [of_sets = task.identity, paths] {
        UnitKey key = of_sets();
        for (const std::string& path : paths) key.add("path", path);
        return key;
    };
    return experiment;
}

}
