#include "app/commands/class_series.hpp"

#include "experiment/run/make_experiment.hpp"
#include "experiment/series/imported_points.hpp"
#include "host/distribution/classes/class_set.hpp"

#include <fmt/format.h>

#include <set>
#include <utility>

namespace poissonlab {
namespace {

/// The points of one class, as they are in the set.
PointSet points_of_class(const PointSet& all, const ClassSetPoints& read, std::size_t number)
{
    PointSet some{all.dimension, {}};
    for (std::size_t i = 0; i < all.size(); ++i)
        if (read.classes[i] == number) some.coordinates.insert(some.coordinates.end(), all[i].begin(), all[i].end());
    return some;
}

}

void add_class_series(Experiment& experiment, const std::string& keys)
{
    const std::string name = "analyze";
    Experiment with_classes = [&] {
        try {
            return make_experiment(
                parse_config("title = \"classes\"\n[[distribution]]\nkind = \"class-set\"\n" + keys, name), "", 0);
        } catch (const InputError& error) {
            if (error.place().file != name) throw;
            throw error.moved_to({name});
        }
    }();
    const auto& settings = with_classes.exhibits.front().settings.as<ClassSetSettings>();
    const auto read = read_class_set(settings);
    const PointSet all = experiment.series.front().create()->sample(0);
    if (all.size() != read->classes.size())
        throw InputError(fmt::format("{}: changed while it was read, from {} points to {}", settings.set.string(),
                                     all.size(), read->classes.size()));
    std::set<std::string> folders{experiment.series.front().name, with_classes.exhibits.front().name};
    for (std::size_t i = 0; i < read->names.size(); ++i) {
        const PointSet some = points_of_class(all, *read, i);
        if (some.size() < 2) {
            experiment.notes.push_back(fmt::format("class {} has one point and therefore no page", read->names[i]));
            continue;
        }
        std::string label = "class " + read->names[i];
        if (label == experiment.series.front().label) label += " alone";
        SeriesTask task = import_sets({some}, label).series.front();
        for (int number = 2; !folders.insert(task.name).second; ++number)
            task.name = fmt::format("{}-{}", series_folder_name(label), number);
        task.parameters = experiment.series.front().parameters;
        experiment.series.push_back(std::move(task));
    }
    experiment.exhibits = std::move(with_classes.exhibits);
    experiment.place = std::move(with_classes.place);
}

}
