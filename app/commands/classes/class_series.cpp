#include "app/commands/class_series.hpp"

#include "experiment/run/make_experiment.hpp"
#include "experiment/series/imported_points.hpp"
#include "host/distribution/classes/class_set.hpp"

#include <fmt/format.h>

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
    const auto read = read_class_set(with_classes.exhibits.front().settings.as<ClassSetSettings>());
    const PointSet all = experiment.series.front().create()->sample(0);
    for (std::size_t i = 0; i < read->names.size(); ++i) {
        const PointSet some = points_of_class(all, *read, i);
        if (some.size() < 2) {
            experiment.notes.push_back(fmt::format("class {} has one point and therefore no page", read->names[i]));
            continue;
        }
        SeriesTask task = import_sets({some}, read->names[i]).series.front();
        task.name = fmt::format("class-{}-{}", i, safe_name(read->names[i])); // a plain name could be that of the set
        task.parameters = experiment.series.front().parameters;
        experiment.series.push_back(std::move(task));
    }
    experiment.exhibits = std::move(with_classes.exhibits);
    experiment.place = std::move(with_classes.place);
}

}
