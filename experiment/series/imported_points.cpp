#include "experiment/series/imported_points.hpp"

#include "base/files/xxh64_bytes.hpp"
#include "base/points/point_file.hpp"
#include "experiment/config/config.hpp"
#include "experiment/config/plan.hpp"
#include "experiment/crew/thread_limit.hpp"
#include "results/file_names.hpp"

#include <fmt/format.h>

#include <utility>

namespace poissonlab {
namespace {

/// Hands out sets that are there already.
class ImportedPoints : public Sampler
{
public:
    explicit ImportedPoints(std::shared_ptr<const std::vector<PointSet>> sets) : sets_(std::move(sets)) {}
    PointSet sample(std::uint32_t realization) override { return sets_->at(realization); }

private:
    std::shared_ptr<const std::vector<PointSet>> sets_;
};

/// Checks a set against the first one. `place` names it in messages.
void check_set(const PointSet& points, const std::string& place, const PointSet& first, const std::string& first_place)
{
    if (points.dimension != first.dimension)
        throw InputError(fmt::format("{}: has {}D points where {} has {}D ones", place, points.dimension, first_place,
                                     first.dimension));
    if (points.size() != first.size())
        throw InputError(fmt::format("{}: has {} points where {} has {}: realizations must have the same number", place,
                                     points.size(), first_place, first.size()));
}

/// All coordinates decide; the names of the files are written into what is stored.
UnitKey identity_of(const std::vector<PointSet>& sets, const std::vector<std::string>& paths)
{
    Xxh64 hash;
    for (const PointSet& set : sets) {
        const std::vector<double>& x = set.coordinates;
        hash.add(fmt::format("{} {} ", set.dimension, x.size()));
        hash.add({reinterpret_cast<const char*>(x.data()), x.size() * sizeof(double)});
    }
    UnitKey key("imported sets");
    for (const std::string& path : paths) key.add("path", path);
    return key.add("coordinates", hash.value());
}

void check_count(std::size_t sets, const std::string& place)
{
    if (sets > static_cast<std::size_t>(max_realizations))
        throw InputError(fmt::format("{}: there are more than {} realizations", place, max_realizations));
}

/// A folder name that is not one of the output folder's files.
std::string series_folder_name(const std::string& label)
{
    const std::string name = safe_name(label).substr(0, 100);
    const bool is_taken = name == "site" || name == file_names::results || name.ends_with(".html");
    return is_taken ? "points-" + name : name;
}

/// The experiment of sets that were checked. `paths` are the files that they come from.
Experiment experiment_of(std::shared_ptr<const std::vector<PointSet>> sets, const std::string& label,
                         const std::vector<std::string>& paths)
{
    SeriesTask task;
    task.label = label;
    task.name = series_folder_name(label);
    task.sampler = "file";
    if (!paths.empty()) task.parameters.set("path", paths);
    task.is_timed = false;
    task.realizations = static_cast<std::uint32_t>(sets->size());
    task.points = sets->front().size();
    task.identity = [sets, paths] { return identity_of(*sets, paths); };
    task.create = [sets] { return std::make_unique<ImportedPoints>(sets); };

    Experiment experiment;
    experiment.title = task.label;
    experiment.dimension = sets->front().dimension;
    experiment.realizations = task.realizations;
    experiment.series.push_back(std::move(task));
    experiment.workplace->machine = [](bool) {
        Machine machine;
        machine.threads = ThreadLimit::current();
        return machine;
    };
    return experiment;
}

}

Experiment import_points(const std::vector<std::filesystem::path>& files, const std::string& label,
                         std::optional<CoordinateRange> domain)
{
    auto sets = std::make_shared<std::vector<PointSet>>();
    std::vector<std::string> places;
    std::vector<std::string> paths;
    for (const auto& file : files) {
        if (std::filesystem::is_directory(file))
            throw InputError(file.string() + ": is a folder; files of points are needed");
        std::vector<PointSet> read = read_points(file, domain);
        for (std::size_t i = 0; i < read.size(); ++i) {
            places.push_back(read.size() == 1 ? file.string()
                                              : fmt::format("{}: realization {}", file.string(), i + 1));
            sets->push_back(std::move(read[i]));
            check_set(sets->back(), places.back(), sets->front(), places.front());
        }
        check_count(sets->size(), file.string());
        paths.push_back(file.string());
    }
    return experiment_of(sets, label.empty() ? files.front().stem().string() : label, paths);
}

Experiment import_sets(const std::vector<PointSet>& sets, const std::string& label)
{
    check_count(sets.size(), label);
    for (std::size_t i = 0; i < sets.size(); ++i)
        check_set(sets[i], fmt::format("{}: realization {}", label, i), sets.front(), label + ": realization 0");
    return experiment_of(std::make_shared<const std::vector<PointSet>>(sets), label, {});
}

}
