#include "host/distribution/classes/class_points.hpp"

#include "analysis/measures/cell_grid.hpp"
#include "analysis/measures/distance_statistics.hpp"
#include "base/errors/errors.hpp"
#include "base/geometry/relative_radius.hpp"
#include "base/geometry/torus.hpp"
#include "base/programs/interrupt.hpp"
#include "base/regions/region_features.hpp"
#include "host/device/device_memory.hpp"
#include "host/distribution/classes/class_density.hpp"
#include "host/distribution/classes/class_pictures.hpp"
#include "host/distribution/classes/class_tiling.hpp"
#include "host/sampling/classes/class_cells.hpp"
#include "host/settings/keys/keys.hpp"
#include "host/settings/sampler_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace poissonlab {

// Looks at the cells around each point of the smaller set, ring after ring, until cells are farther away than the
// least distance so far.

namespace {

/// Calls visit(cell) for the cells that are `ring` cells away from a cell, around the torus; some twice where the torus
/// is no wider.
template <int D, typename Visit>
void for_each_in_ring(const std::array<int, D>& cell, int ring, int cells, const Visit& visit)
{
    std::array<int, D> offset;
    offset.fill(-ring);
    for (;;) {
        bool is_in_ring = false;
        std::size_t index = 0;
        for (int k = D - 1; k >= 0; --k) {
            is_in_ring = is_in_ring || std::abs(offset[k]) == ring;
            const int along = ((cell[k] + offset[k]) % cells + cells) % cells;
            index = index * static_cast<std::size_t>(cells) + static_cast<std::size_t>(along);
        }
        if (is_in_ring) visit(index);
        int k = 0;
        while (k < D && ++offset[k] > ring) offset[k++] = -ring;
        if (k == D) return;
    }
}

/// Squares in units of 2^-64, of coordinates that are rounded to multiples of 2^-32.
template <int D>
double least_between(const PointSet& few, const PointSet& many)
{
    const CellGrid<D> grid(many, CellGrid<D>::cells_of(many.size()));
    const auto fixed = [](double x) { return static_cast<std::uint32_t>(static_cast<std::uint64_t>(x * 0x1p32)); };
    std::uint64_t least = std::numeric_limits<std::uint64_t>::max();
    for (std::size_t i = 0; i < few.size(); ++i) {
        TorusPoint<D> from;
        std::array<int, D> cell;
        for (std::size_t k = 0; k < D; ++k) {
            from[k] = fixed(few[i][k]);
            cell[k] = std::min(static_cast<int>(few[i][k] * grid.cells), grid.cells - 1);
        }
        for (int ring = 0; 2 * ring <= grid.cells + 1; ++ring) {
            // Points of a ring are a ring less one cell away at least.
            const double away = (ring - 1) * 0x1p32 / grid.cells;
            if (ring > 1 && away * away >= static_cast<double>(least)) break;
            for_each_in_ring<D>(cell, ring, grid.cells, [&](std::size_t index) {
                for (std::size_t j = grid.starts[index]; j < grid.starts[index + 1]; ++j) {
                    TorusPoint<D> to;
                    for (int k = 0; k < D; ++k) to[k] = fixed(grid.position[k][j]);
                    least = std::min(least, squared_distance<D>(from, to));
                }
            });
        }
    }
    return std::sqrt(static_cast<double>(least)) * 0x1p-32;
}

}

double least_distance_between(const PointSet& a, const PointSet& b)
{
    if (a.size() == 0 || b.size() == 0) return std::numeric_limits<double>::infinity();
    const bool is_first_larger = a.size() > b.size();
    const PointSet &few = is_first_larger ? b : a, &many = is_first_larger ? a : b;
    return a.dimension == 2 ? least_between<2>(few, many) : least_between<3>(few, many);
}

namespace {

void append_columns(std::string& text, const CrossSpectra& spectra, std::size_t bin)
{
    text += fmt::format(",{:.9g}", spectra.power.back()[bin]);
    for (std::size_t i = 0; i + 1 < spectra.power.size(); ++i) text += fmt::format(",{:.9g}", spectra.power[i][bin]);
    for (const std::vector<double>& cross : spectra.cross) text += fmt::format(",{:.9g}", cross[bin]);
}

void append_names(std::string& text, const std::vector<std::uint32_t>& used, const std::string& end)
{
    text += ",all" + end;
    for (const std::uint32_t i : used) text += fmt::format(",class_{}{}", i, end);
    for (std::size_t i = 0; i < used.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) text += fmt::format(",cross_{}_{}{}", used[j], used[i], end);
}

/// Returns the matrix of the settings, or the one that follows from them and from the distances that classes have at a
/// relative radius of 1.
ClassDistances asked_distances(const ClassSettings& settings, const std::vector<double>& largest)
{
    const std::size_t classes = settings.classes();
    if (!settings.matrix.empty()) {
        ClassDistances given(classes);
        for (std::size_t i = 0; i < classes; ++i)
            for (std::size_t j = 0; j < classes; ++j) given.set(i, j, settings.matrix[i * classes + j]);
        return given;
    }
    if (!settings.distances.empty()) return wei_distances(settings.distances, settings.dimension);
    std::vector<double> distances;
    for (const double each : largest) distances.push_back(settings.relative_radius * each);
    return wei_distances(distances, settings.dimension);
}

/// Returns the distance of the densest packing of as many points of each class on the torus, at most its side.
std::vector<double> packing_distances(const ClassSettings& settings)
{
    std::vector<double> all;
    for (const std::size_t count : settings.points)
        all.push_back(std::min(1 / settings.relative_radius, max_min_distance(count, settings.dimension)));
    return all;
}

/// Scales all distances down until none is above that of the densest packing of a class: larger ones would shrink in
/// vain.
ClassDistances within_packings(const ClassDistances& distances, const ClassSettings& settings)
{
    double scale = 1;
    for (std::size_t i = 0; i < settings.points.size(); ++i)
        scale = std::min(scale, max_min_distance(settings.points[i], settings.dimension) / distances.at(i, i));
    return distances.scaled(scale);
}

double largest_of(const ClassDistances& distances)
{
    double largest = 0;
    for (std::size_t i = 0; i < distances.classes(); ++i)
        for (std::size_t j = 0; j <= i; ++j) largest = std::max(largest, distances.at(i, j));
    return largest;
}

/// The cells of densities in all features together, and in each of them at least.
constexpr std::size_t density_cells = 1 << 18, least_density_cells = 1 << 12;

/// Reads the densities of all classes, if there are any.
std::vector<DensityAt> densities_of(const ClassSettings& settings, const RegionLand& land)
{
    std::vector<DensityAt> all;
    const std::vector<std::string>& from = settings.densities_from;
    for (std::size_t i = 0; i < settings.densities.size(); ++i)
        all.push_back(distance_of_text(settings.densities[i],
                                       from.empty() ? "light" : from[std::min(i, from.size() - 1)], {0, 1},
                                       box_of(land.whole)));
    return all;
}

/// Returns the densities of all classes with points in a part of the land; the others have none.
std::vector<ClassDensity> densities_in(const ClassSettings& settings, const std::vector<DensityAt>& densities,
                                       const FixedRegion& region, const std::vector<std::size_t>& points,
                                       const ClassWork& work)
{
    const std::size_t cells =
        std::max(least_density_cells, density_cells / std::max<std::size_t>(1, work.features.size()));
    std::vector<ClassDensity> all;
    for (std::size_t i = 0; i < densities.size(); ++i)
        all.push_back(points[i] > 0 ? class_density(region, densities[i], name_of_input(settings.densities[i]), cells)
                                    : ClassDensity{});
    return all;
}

/// Calls visit(region, points of classes) for each part of the land.
template <typename Visit>
void for_each_part(const ClassSettings& settings, const ClassWork& work, const Visit& visit)
{
    if (work.features.empty()) return visit(work.land->rest, settings.points);
    for (const FeaturePart& feature : work.features) visit(feature.region, feature.points);
}

/// Returns the distance of the densest packing of each class where it is densest.
std::vector<double> packing_distances(const ClassSettings& settings, const std::vector<DensityAt>& densities,
                                      const ClassWork& work)
{
    std::vector<double> all(settings.classes(), box_of(work.land->whole).longest() / settings.relative_radius);
    for_each_part(settings, work, [&](const PlaneRegion& part, const std::vector<std::size_t>& points) {
        const FixedRegion region(part, 0, KeptAway{{}, {}, 0, 0, box_of(work.land->whole)});
        const std::vector<ClassDensity> read = densities_in(settings, densities, region, points, work);
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (points[i] == 0) continue;
            const double fullness = read.empty() ? 1 : read[i].fullness;
            all[i] = std::min(all[i], max_min_distance(points[i], 2) * std::sqrt(area_of(part) * fullness));
        }
    });
    return all;
}

/// Divides the request into features, with densities of the classes.
void add_parts(const ClassSettings& settings, const std::vector<DensityAt>& densities, const KeptAway& kept,
               ClassWork& work)
{
    ClassDartRequest& request = work.request;
    request.points.assign(settings.classes(), 0);
    for_each_part(settings, work, [&](const PlaneRegion& part, const std::vector<std::size_t>& points) {
        ClassPart made{std::make_shared<const FixedRegion>(part, 0, kept), {points.begin(), points.end()}, points, {}};
        for (ClassDensity& density : densities_in(settings, densities, *made.region, points, work))
            made.densities.push_back(std::move(density.cells));
        request.parts.push_back(std::move(made));
        for (std::size_t i = 0; i < points.size(); ++i) request.points[i] += points[i];
    });
    request.shares.assign(request.points.begin(), request.points.end());
}

/// Places the region on the torus, and converts distances to its units. They become longer by as much as rounding of
/// coordinates may shorten them.
void place_in_region(const ClassSettings& settings, ClassWork& work)
{
    work.land = region_land(settings.place);
    const RegionLand& land = *work.land;
    if (!settings.features.is_empty())
        work.features =
            feature_parts(settings.features, land.whole, land.obstacles.polygons, name_of_input(settings.place.region));
    std::vector<DensityAt> densities;
    try {
        densities = densities_of(settings, land);
    } catch (const InputError& error) {
        throw DensityError(error.what());
    }
    const bool follows = settings.distances.empty() && settings.matrix.empty();
    const auto distances = follows ? packing_distances(settings, densities, work) : std::vector<double>{};
    work.asked = asked_distances(settings, distances);
    DartSettings place = settings.place; // as for a saturated set at the largest distance
    place.points.reset();
    place.min_distance = largest_of(work.asked);
    if (!place.obstacle_distance) place.obstacle_distance = 0;
    const RegionDartRequest darts = region_dart_request(place, 0, work.land);
    const RegionBox& box = darts.kept.box;
    work.side = FixedRegion::torus_side(box);
    work.request.region = darts.region;
    work.request.distances = ClassDistances(work.asked.classes());
    for (std::size_t i = 0; i < work.asked.classes(); ++i)
        for (std::size_t j = 0; j <= i; ++j) {
            const double distance = work.asked.at(i, j);
            work.request.distances.set(i, j, std::min((distance + distance_rounding(distance, box)) / work.side, 0.5));
        }
    if (!settings.densities.empty() || !work.features.empty()) add_parts(settings, densities, darts.kept, work);
}

/// Saturated sets in regions have at most this number of points, because the cells that they begin with take memory.
constexpr double most_saturated_in_region = 1 << 24;

/// Throws InputError if there would be too many points. Full classes have about half as many points as a packing.
void check_count(const ClassWork& work)
{
    if (work.request.region && work.request.points.empty()) {
        double points = 0;
        for (std::size_t i = 0; i < work.asked.classes(); ++i)
            points += work.request.region->area() / std::pow(work.asked.at(i, i), 2);
        if (points > most_saturated_in_region)
            throw InputError(fmt::format("there would be some {:.2g} points in the region; at most {} are possible",
                                         points, most_saturated_in_region));
        return;
    }
    const std::size_t most = most_class_points(work.request), points = work.request.points.empty() ? most / 2 : most;
    if (points > static_cast<std::size_t>(max_points))
        throw InputError(fmt::format("there would be {} points; at most {} are possible", points, max_points));
}

/// Full classes have fewer points than were asked for.
void check_numbers(const ClassSettings& settings, const std::vector<std::size_t>& asked,
                   const std::vector<std::size_t>& counts, const std::string& where)
{
    for (std::size_t i = 0; i < asked.size(); ++i) {
        if (counts[i] == asked[i]) continue;
        double share = 1;
        for (std::size_t j = 0; j < counts.size(); ++j)
            if (asked[j] > 0) share = std::min(share, static_cast<double>(counts[j]) / static_cast<double>(asked[j]));
        const double scale = std::pow(share, 1.0 / settings.dimension);
        throw InputError(
            fmt::format("{}class {} is full with {} of {} points: no further one fits; {} can be reached", where, i,
                        counts[i], asked[i],
                        settings.distances.empty() && settings.matrix.empty()
                            ? fmt::format("a relative radius of about {:.3f}", 0.99 * scale * settings.relative_radius)
                            : fmt::format("distances of about {:.3f} times as much", 0.99 * scale)));
    }
}

void check_numbers(const ClassSettings& settings, const ClassSet& set)
{
    if (set.work.features.empty()) return check_numbers(settings, settings.points, set.points.counts(), "");
    std::size_t at = 0;
    for (std::size_t part = 0; part < set.work.features.size(); ++part) {
        const FeaturePart& feature = set.work.features[part];
        std::vector<std::size_t> counts(feature.points.size());
        for (; at < set.points.part_ends[part]; ++at) ++counts[set.points.classes[at]];
        check_numbers(settings, feature.points, counts,
                      fmt::format("{}: features[{}]: ", name_of_input(settings.place.region), feature.number));
    }
}

double radius_of(double least, std::size_t points, int dimension)
{
    return points < 2 ? 0 : relative_radius(least, points, dimension);
}

}

ClassSpectra averaged_spectra(const ClassSettings& settings, std::uint64_t seed, const DistributionPlace& place,
                              const ClassSet& first)
{
    std::vector<UsedSpectra> sets{{used_classes(first.points), class_spectra(first.points)}};
    const std::size_t bins = sets.front().spectra.bins();
    for (std::uint32_t number = 1; number < settings.sets; ++number) {
        stop_if_interrupted();
        if (place.on_step) place.on_step(fmt::format("spectra: set {} of {}", number + 1, settings.sets));
        const ClassSet set = first.tiles ? classes_by_tiles(first.tiles, settings, seed, place, number)
                                         : throw_classes(settings, seed, place, number);
        sets.push_back({used_classes(set.points), class_spectra(set.points, bins)});
    }
    return mean_spectra(sets);
}

std::string spectra_csv(const ClassSpectra& spectra)
{
    std::string text = "frequency";
    append_names(text, spectra.classes, "");
    if (spectra.sets > 1) append_names(text, spectra.classes, "_error");
    text += '\n';
    for (std::size_t k = 0; k < spectra.mean.bins(); ++k) {
        text += fmt::format("{}", k + 1);
        append_columns(text, spectra.mean, k);
        if (spectra.sets > 1) append_columns(text, spectra.error, k);
        text += '\n';
    }
    return text;
}

std::size_t ClassSettings::classes() const
{
    if (!matrix.empty()) return static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(matrix.size()))));
    return std::max({points.size(), distances.size(), features.names().size()});
}

ClassedPoints ClassSet::in_units() const
{
    if (!work.request.region) return points;
    ClassedPoints own = points;
    own.points = in_units_of(*work.request.region, points.points);
    return own;
}

std::vector<std::string> ClassSet::features() const
{
    if (!work.land || !work.land->whole.source) return {};
    const std::vector<RegionFeature>& features = work.land->whole.source->features;
    std::vector<std::string> ids;
    for (std::size_t part = 0; part < work.features.size(); ++part)
        ids.resize(points.part_ends[part], features[work.features[part].number].id);
    if (ids.empty() && features.size() > 1) ids = ids_of_features(features, in_units().points);
    return ids;
}

ClassedPoints ClassSet::as_in_files() const
{
    ClassedPoints own = in_units();
    if (work.land) own.points = poissonlab::as_in_files(work.land->whole, std::move(own.points));
    return own;
}

ClassWork class_work(const ClassSettings& settings, std::uint64_t seed, std::uint32_t number)
{
    ClassWork work{.request = {.dimension = settings.dimension,
                               .distances = {},
                               .shares = {settings.points.begin(), settings.points.end()},
                               .points = settings.points,
                               .factor = settings.factor,
                               .stream = stream_key(seed, Purpose::class_darts, number)},
                   .asked = {}};
    if (settings.has_region()) {
        place_in_region(settings, work);
    } else {
        work.asked = asked_distances(settings, packing_distances(settings));
        if (settings.factor < 1) work.asked = within_packings(work.asked, settings);
        work.request.distances = work.asked;
    }
    if (!settings.has_numbers())
        for (std::size_t i = 0; i < work.asked.classes(); ++i)
            work.request.shares.push_back(std::pow(work.asked.at(i, i), -settings.dimension));
    check_count(work);
    return work;
}

ClassSet throw_classes(const ClassSettings& settings, std::uint64_t seed, const DistributionPlace& place,
                       std::uint32_t number)
{
    if (settings.has_tiles()) return tiled_classes(settings, seed, place, number);
    ClassSet set{class_work(settings, seed, number), {}};
    const ClassDartRequest& request = set.work.request;
    if (place.engine == Engine::reference) {
        set.points = reference::throw_class_darts(request);
    } else {
        Device& device = place.device();
        check_fits("dart throwing", ClassDartThrower::memory(request), device.info());
        set.points = ClassDartThrower(device).throw_darts(request);
    }
    if (set.points.classes.empty())
        throw InputError(fmt::format("the region has no room for a point{}",
                                     settings.place.obstacles.empty() ? "" : " among the obstacles"));
    check_numbers(settings, set);
    return set;
}

double density_error(const ClassSet& set, std::size_t of)
{
    const std::vector<ClassPart>& parts = set.work.request.parts;
    if (parts.size() != 1 || parts[0].densities.empty()) return -1;
    return density_error(parts[0].densities[of], set.points.of_class(static_cast<std::uint32_t>(of)));
}

namespace {

/// Returns the points of a class in one part of a set.
PointSet points_in_part(const ClassedPoints& points, std::size_t part, std::size_t of)
{
    PointSet found{2, {}};
    for (std::size_t i = part == 0 ? 0 : points.part_ends[part - 1]; i < points.part_ends[part]; ++i)
        if (points.classes[i] == of)
            found.coordinates.insert(found.coordinates.end(), points.points[i].begin(), points.points[i].end());
    return found;
}

}

std::vector<std::string> density_notes(const ClassSet& set)
{
    constexpr double told = 0.01;
    const std::vector<ClassPart>& parts = set.work.request.parts;
    std::vector<std::string> notes;
    for (std::size_t i = 0; i < set.points.is_full.size(); ++i) {
        double largest = 0;
        std::size_t worst = 0;
        for (std::size_t part = 0; part < parts.size(); ++part) {
            if (parts[part].densities.empty()) continue;
            const PointSet points = points_in_part(set.points, part, i);
            const double error = density_error(parts[part].densities[i], points);
            if (points.size() == 0 || error <= std::max({told, 2.0 / static_cast<double>(points.size()), largest}))
                continue;
            largest = error;
            worst = part;
        }
        if (largest == 0) continue;
        notes.push_back(fmt::format(
            "class {} does not follow its density everywhere, as its distance leaves no room where it is densest: a "
            "sixteenth of the density{} has {:.2g} % of the points more or less than it should have",
            i, parts.size() > 1 ? fmt::format(" in features[{}]", set.work.features[worst].number) : "",
            100 * largest));
    }
    return notes;
}

ClassDistances least_distances(const ClassSet& set)
{
    const std::size_t classes = set.points.is_full.size();
    std::vector<PointSet> sets;
    for (std::uint32_t i = 0; i < classes; ++i) sets.push_back(set.points.of_class(i));
    ClassDistances least(classes);
    for (std::size_t i = 0; i < classes; ++i)
        for (std::size_t j = 0; j <= i; ++j)
            least.set(i, j, i == j ? min_toroidal_distance(sets[i]) : least_distance_between(sets[i], sets[j]));
    return least.scaled(set.work.side);
}

std::vector<DistributionNumber> class_numbers(const ClassSet& set)
{
    const ClassDistances least = least_distances(set);
    const std::vector<std::size_t> counts = set.points.counts();
    const std::size_t all = set.points.points.size();
    const int d = set.work.request.dimension;
    const double unit = std::pow(set.size(), 1.0 / d);
    const ClassDistances kept = set.kept();
    double least_of_all = INFINITY;
    std::vector<DistributionNumber> numbers;
    numbers.push_back({"points", "Points", static_cast<double>(all), "of all classes"});
    for (std::size_t i = 0; i < counts.size(); ++i) {
        numbers.push_back({fmt::format("points_{}", i), fmt::format("Points of class {}", i),
                           static_cast<double>(counts[i]),
                           set.points.is_full[i] ? "no further one fits" : "as asked for"});
        numbers.push_back({fmt::format("relative_radius_{}", i), fmt::format("Relative radius of class {}", i),
                           radius_of(least.at(i, i) / unit, counts[i], d), "of its points alone"});
        for (std::size_t j = 0; j <= i; ++j) least_of_all = std::min(least_of_all, least.at(i, j));
    }
    numbers.push_back({"relative_radius", "Relative radius", radius_of(least_of_all / unit, all, d), "of all points"});
    for (std::size_t i = 0; i < counts.size(); ++i)
        if (const double error = density_error(set, i); error >= 0)
            numbers.push_back({fmt::format("density_error_{}", i), fmt::format("Density error of class {}", i), error,
                               "the largest share of its points by which a sixteenth of its density has too many or "
                               "too few"});
    for (std::size_t i = 0; i < counts.size(); ++i)
        for (std::size_t j = 0; j <= i; ++j) {
            numbers.push_back({fmt::format("distance_{}_{}", j, i),
                               fmt::format("Distance {}, {}", j, i),
                               kept.at(i, j),
                               "that the two classes keep",
                               {},
                               true});
            if (std::isfinite(least.at(i, j)))
                numbers.push_back({fmt::format("least_{}_{}", j, i),
                                   fmt::format("Least distance {}, {}", j, i),
                                   least.at(i, j),
                                   "of points of the two classes",
                                   {},
                                   true});
        }
    return numbers;
}

DistributionTable distance_table(const ClassSet& set)
{
    const ClassDistances least = least_distances(set), kept = set.kept();
    DistributionTable table{
        "Distances that classes keep, and the least that there are", {"classes", "kept", "least"}, {}};
    for (std::size_t i = 0; i < least.classes(); ++i)
        for (std::size_t j = 0; j <= i; ++j)
            table.rows.push_back({fmt::format("{}, {}", j, i), fmt::format("{:.6g}", kept.at(i, j)),
                                  std::isfinite(least.at(i, j)) ? fmt::format("{:.6g}", least.at(i, j)) : "none"});
    return table;
}

}
