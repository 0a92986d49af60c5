#include "experiment/series/region_notes.hpp"

#include "base/regions/region_source.hpp"

#include <algorithm>

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

}
