#include "experiment/series/imported_points.hpp"

#include "base/crew/thread_limit.hpp"
#include "base/files/scratch_folder.hpp"
#include "base/files/xxh64_bytes.hpp"
#include "base/points/placed_file.hpp"
#include "base/points/point_stream.hpp"
#include "experiment/config/config.hpp"
#include "experiment/config/plan.hpp"
#include "results/file_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>
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

/// Dimension and size, which all sets must have in common.
struct SetShape
{
    int dimension = 2;
    std::uint64_t points = 0;

    explicit SetShape(const PointSet& set) : dimension(set.dimension), points(set.size()) {}
    explicit SetShape(const PointStrips& set) : dimension(set.dimension()), points(set.size()) {}
};

/// Checks a set against the first one. `place` names it in messages.
void check_set(const SetShape& set, const std::string& place, const SetShape& first, const std::string& first_place)
{
    if (set.dimension != first.dimension)
        throw InputError(fmt::format("{}: has {}D points where {} has {}D ones", place, set.dimension, first_place,
                                     first.dimension));
    if (set.points != first.points)
        throw InputError(fmt::format("{}: has {} points where {} has {}: realizations must have the same number of "
                                     "points; analyze sets of several methods one at a time, or as [[method]] tables "
                                     "of a config",
                                     place, set.points, first_place, first.points));
}

void add_bytes(Xxh64& hash, std::span<const double> x)
{
    hash.add({reinterpret_cast<const char*>(x.data()), x.size() * sizeof(double)});
}

/// Hashes of coordinates decide; the names of the files are written into what is stored.
UnitKey identity_of(const std::vector<std::uint64_t>& hashes, const std::vector<std::string>& paths)
{
    UnitKey key("imported sets");
    for (const std::string& path : paths) key.add("path", path);
    for (const std::uint64_t hash : hashes) key.add("coordinates", hash);
    return key;
}

/// A hash of all coordinates of all sets.
std::uint64_t hash_of(const std::vector<PointSet>& sets)
{
    Xxh64 hash;
    for (const PointSet& set : sets) {
        hash.add(fmt::format("{} {} ", set.dimension, set.coordinates.size()));
        add_bytes(hash, set.coordinates);
    }
    return hash.value();
}

void check_count(std::size_t sets, const std::string& place)
{
    if (sets > static_cast<std::size_t>(max_realizations))
        throw InputError(fmt::format("{}: there are more than {} realizations", place, max_realizations));
}

/// The experiment of sets that were checked, without what makes them. `paths` are the files that they come from.
Experiment experiment_of(const SetShape& shape, std::size_t sets, const std::string& label,
                         const std::vector<std::string>& paths)
{
    SeriesTask task;
    task.label = label;
    task.name = series_folder_name(label);
    task.sampler = find_sampler("file");
    if (!paths.empty()) task.parameters.set("path", paths);
    task.realizations = static_cast<std::uint32_t>(sets);
    task.request.points = shape.points;

    Experiment experiment;
    experiment.title = task.label;
    experiment.dimension = shape.dimension;
    experiment.realizations = task.realizations;
    experiment.series.push_back(std::move(task));
    experiment.workplace->machine = [](bool) {
        Machine machine;
        machine.threads = ThreadLimit::current();
        return machine;
    };
    return experiment;
}

Experiment experiment_of(const std::shared_ptr<const std::vector<PointSet>>& sets, const std::string& label,
                         const std::vector<std::string>& paths)
{
    Experiment experiment = experiment_of(SetShape(sets->front()), sets->size(), label, paths);
    experiment.series.front().identity = [sets, paths] { return identity_of({hash_of(*sets)}, paths); };
    experiment.series.front().create = [sets] { return std::make_unique<ImportedPoints>(sets); };
    return experiment;
}

/// A set on disk, and the folder that is removed with it.
struct KeptSet
{
    ScratchFolder folder;
    PointStrips strips;
    std::uint64_t hash = 0; ///< of all coordinates
};

/// The part of a path that is there already, in which a scratch folder can be made.
std::filesystem::path place_beside(const std::filesystem::path& path)
{
    std::filesystem::path place = std::filesystem::absolute(path);
    while (!std::filesystem::is_directory(place.parent_path()) && place.has_parent_path() && place != place.root_path())
        place = place.parent_path();
    return place;
}

std::shared_ptr<const KeptSet> keep_set(const std::filesystem::path& file, const PointReading& how,
                                        const std::filesystem::path& beside)
{
    ScratchFolder folder(beside);
    Xxh64 hash;
    PointStrips strips = read_into_strips(file, how, folder.path(),
                                          [&](std::span<const double> coordinates) { add_bytes(hash, coordinates); });
    return std::make_shared<const KeptSet>(KeptSet{std::move(folder), std::move(strips), hash.value()});
}

/// All files in pieces.
Experiment import_large(const std::vector<std::filesystem::path>& files, const std::string& label,
                        const PointReading& how, const std::filesystem::path& beside)
{
    const std::filesystem::path place = place_beside(beside);
    PointFileHead needed;
    for (const auto& file : files)
        if (const auto shape = known_shape(file, how)) {
            needed.points += shape->points;
            needed.dimension = shape->dimension;
        }
    check_room(place, needed);
    std::vector<std::shared_ptr<const PointStrips>> strips;
    std::vector<std::uint64_t> hashes;
    std::vector<std::string> paths;
    for (const auto& file : files) {
        const auto set = keep_set(file, how, place);
        hashes.push_back(set->hash);
        paths.push_back(file.string());
        strips.emplace_back(set, &set->strips);
        check_set(SetShape(*strips.back()), paths.back(), SetShape(*strips.front()), paths.front());
    }
    Experiment experiment = experiment_of(SetShape(*strips.front()), strips.size(), label, paths);
    experiment.series.front().identity = [hashes, paths] { return identity_of(hashes, paths); };
    experiment.series.front().strips = std::move(strips);
    return experiment;
}

/// Must, or should, the files be read in pieces? Not where each axis has a range of its own.
bool is_large(const std::vector<std::filesystem::path>& files, const PointReading& how, const LargeImports& large)
{
    if (large.beside.empty()) return false;
    if (how.domain && how.domain->dimension() > 0) return false;
    for (const auto& file : files)
        if (!can_be_streamed(file)) {
            if (!large.all) return false;
            throw InputError::at({file.string()},
                                 "only text, CSV, NumPy and HDF5, one set a file, can be read in pieces");
        }
    return large.all || std::ranges::any_of(files, [&](const std::filesystem::path& file) {
               return points_at_most(file, how) > most_points_in_memory;
           });
}

}

Experiment import_points(const std::vector<std::filesystem::path>& named, const std::string& label,
                         const PointReading& asked, const LargeImports& large)
{
    for (const auto& file : named)
        if (std::filesystem::is_directory(file))
            throw InputError(file.string() + ": is a folder; files of points are needed");
    const std::string name = label.empty() ? named.front().stem().string() : label;
    std::vector<std::string> paths, notes;
    PointReading how = asked;
    how.told = [&](const std::string& sentence) { notes.push_back(sentence); };
    const auto files = without_further_parts(named, how.told);
    if (is_large(files, how, large)) {
        Experiment experiment = import_large(files, name, how, large.beside);
        experiment.notes = notes;
        return experiment;
    }
    std::vector<double> sides;
    auto sets = std::make_shared<std::vector<PointSet>>();
    std::vector<std::string> places;
    for (const auto& file : files) {
        PointDomain domain;
        std::vector<PointSet> read = read_points_in_box(file, how, domain);
        const std::vector<double> own = domain.sides();
        if (sets->empty()) sides = own;
        if (periodic_box(own) != periodic_box(sides))
            throw InputError(
                fmt::format("{}: its domain has another shape than that of {}", file.string(), paths.front()));
        for (std::size_t i = 0; i < read.size(); ++i) {
            places.push_back(read.size() == 1 ? file.string()
                                              : fmt::format("{}: realization {}", file.string(), i + 1));
            sets->push_back(std::move(read[i]));
            check_set(SetShape(sets->back()), places.back(), SetShape(sets->front()), places.front());
        }
        check_count(sets->size(), file.string());
        paths.push_back(file.string());
    }
    Experiment experiment = experiment_of(sets, name, paths);
    experiment.notes = notes;
    if (!periodic_box(sides).is_unit()) experiment.analysis.box_sides = sides;
    return experiment;
}

void check_imported(const Experiment& experiment)
{
    if (experiment.series.front().strips.empty()) return;
    const auto fail = [](const char* key, const char* value) {
        throw InputError(fmt::format("analysis.{} = {}: sets that are read in pieces have none", key, value));
    };
    if (experiment.analysis.zone_plate) fail("zone_plate", "true");
    if (!experiment.analysis.box_sides.empty()) fail("box", "[..]");
    if (experiment.analysis.spectrum == PeriodogramMethod::exact) fail("spectrum", "\"exact\"");
}

Experiment import_sets(const std::vector<PointSet>& sets, const std::string& label)
{
    check_count(sets.size(), label);
    for (std::size_t i = 0; i < sets.size(); ++i)
        check_set(SetShape(sets[i]), fmt::format("{}: realization {}", label, i), SetShape(sets.front()),
                  label + ": realization 0");
    return experiment_of(std::make_shared<const std::vector<PointSet>>(sets), label, {});
}

}
