#include "host/distribution/surface_spectra/mesh_set.hpp"

#include "base/errors/errors.hpp"
#include "base/points/point_file.hpp"
#include "host/distribution/surfaces/given_points.hpp"
#include "host/distribution/surfaces/surface_neighbours.hpp"
#include "host/sampling/surfaces/surface_elimination.hpp"
#include "results/series.hpp"

#include <fmt/format.h>

#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

namespace poissonlab {
namespace {

/// Points may be off the mesh by this part of the square root of the area per point.
constexpr double off_mesh = 0.1;

/// Lattices have their first peaks below this frequency: those of squares at 1, those of triangles at 1.07.
constexpr double reach_of_lattices = 1.2;

/// Curves have about this number of rings for each unit sqrt(N / area).
constexpr double rings_of_curve = 40;

/// Random points that pairs are compared with. Sixteen for each point add a 32nd to the variance of counts of pairs.
constexpr std::size_t random_for_each = 16, least_random = 4096, most_random = 1 << 18;

MeshPoint mesh_point(std::span<const double> place) { return {place[0], place[1], place[2]}; }

/// Reads the class of each point of the set.
ClassNumbers classes_in(const MeshSetSettings& settings, std::size_t points)
{
    std::vector<std::string> class_of_point;
    PointReading how;
    how.domain = any_coordinates;
    how.classes = {settings.classes, [&](std::string_view name) { class_of_point.emplace_back(name); }};
    read_points(settings.set, how);
    if (class_of_point.size() != points)
        throw InputError(settings.set.string() + ": has no classes; only text, tables, PLY and GeoJSON can have them");
    return number_classes(class_of_point, settings.set.string());
}

/// Locates a set on the mesh whose triangles are small.
std::vector<MeshPosition> positions_of(const TriangleTree& tree, const PointSet& places)
{
    std::vector<MeshPosition> positions;
    for (std::size_t i = 0; i < places.size(); ++i) positions.push_back(tree.nearest(mesh_point(places[i])));
    return positions;
}

/// Answers by the rule of the plane, since the measures are those of the plane.
BlueNoiseVerdict verdict_of(const MeshSetMeasures& set, std::size_t points, bool reaches_lattices)
{
    Series series;
    series.points = points;
    series.realizations = 1;
    series.spectrum_size = reaches_lattices ? size_asked_for(points, 2) : 1;
    auto& numbers = series.measures.numbers;
    numbers["mean_nearest_distance"] = {set.nearest_ratio, {}};
    if (set.low_frequency_mean) numbers["low_frequency_mean"] = {*set.low_frequency_mean, {}};
    if (set.effective_nyquist) numbers["effective_nyquist"] = {*set.effective_nyquist, {}};
    if (set.above_chance) numbers["anisotropy_above_chance"] = {*set.above_chance, {}};
    if (reaches_lattices) series.measures.peak_anisotropy = peak_anisotropy(set.rings);
    return *blue_noise_verdict(series, 2);
}

/// The methods of the settings but for the one whose points are measured.
std::vector<std::string> methods_beside(const MeshSetSettings& settings)
{
    return {settings.methods.begin() + (settings.set.empty() ? 1 : 0), settings.methods.end()};
}

/// Measures a set whose powers are known.
class MeshSetMeasurement
{
public:
    MeshSetMeasurement(const FixedSurface& surface, const TriangleMesh& mesh, const EigenfunctionPowers& found,
                       double highest, const PairGround& ground, std::uint64_t seed)
        : surface_(surface), mesh_(mesh), found_(found), highest_(highest), ground_(ground), seed_(seed)
    {}

    MeshSetMeasures measure(const std::vector<SurfacePoint>& points, const std::vector<MeshPosition>& positions,
                            std::size_t number) const
    {
        MeshSetMeasures set;
        set.rings = eigenfunction_rings(found_.eigenvalues, found_.powers[number], surface_.area, highest_);
        const SurfaceDistances distances = surface_distances(surface_, points, ground_.least_cosine, surface_.area);
        set.least = distances.least;
        set.mean_nearest = distances.mean_nearest;
        set.counts = counts_over_parts(mesh_, positions);
        set.pairs = pairs_on_mesh(ground_, points, parts_of(set.counts, positions), seed_);
        complete_measures(set, points.size(), surface_.area,
                          frequency_of(highest_) * std::sqrt(surface_.area / static_cast<double>(points.size())));
        return set;
    }

private:
    static PartsOfPoints parts_of(const CountsOverParts& counts, const std::vector<MeshPosition>& positions)
    {
        PartsOfPoints parts{{}, counts.parts};
        if (counts.parts == 0) return parts;
        for (const MeshPosition& position : positions) parts.of_point.push_back(counts.part_of[position.triangle]);
        return parts;
    }

    const FixedSurface& surface_;
    const TriangleMesh& mesh_; ///< whose triangles are small
    const EigenfunctionPowers& found_;
    double highest_;
    const PairGround& ground_;
    std::uint64_t seed_;
};

/// Says how long eigenfunctions take: until the second word by what others took, then by what these took.
class EigenfunctionForecast
{
public:
    EigenfunctionForecast(double functions, std::size_t vertices)
        : vertices_(vertices), all_(static_cast<std::size_t>(functions)),
          seconds_each_(seconds_a_vertex * static_cast<double>(vertices) / tbb::this_task_arena::max_concurrency())
    {}

    std::string first() const
    {
        return fmt::format("some {} eigenfunctions of {} vertices: about {}", all_, vertices_, words_for(all_));
    }

    /// Eigenvalues are counted before the first functions are found, so that time counts from these on.
    std::string after(std::size_t done, std::size_t all)
    {
        const auto now = std::chrono::steady_clock::now();
        if (begun_ == 0) {
            begun_ = done;
            begin_ = now;
        } else if (done > begun_) {
            seconds_each_ = std::chrono::duration<double>(now - begin_).count() / static_cast<double>(done - begun_);
        }
        return fmt::format("{} of {} eigenfunctions of {} vertices, about {} left", done, all, vertices_,
                           words_for(all - done));
    }

private:
    /// Seconds of a core. Measured on tori of 12,700 and of 51,200 vertices: 0.7 and 1.2 millionths.
    static constexpr double seconds_a_vertex = 1e-6;

    std::string words_for(std::size_t functions) const
    {
        const double seconds = seconds_each_ * static_cast<double>(functions), minute = 60;
        return seconds < 2 * minute ? fmt::format("{:.0f} s", std::ceil(seconds))
                                    : fmt::format("{:.0f} min", seconds / minute);
    }

    std::size_t vertices_, all_;
    double seconds_each_;
    std::size_t begun_ = 0; ///< functions that had been found at the first word
    std::chrono::steady_clock::time_point begin_{};
};

/// The set that is measured may have been made by a method that is beside it, with the run's seed.
std::uint64_t seed_beside(std::uint64_t seed)
{
    const StreamKey key = stream_key(seed, Purpose::surface_candidates, 5);
    return std::uint64_t{key[1]} << 32 | key[0];
}

}

void complete_measures(MeshSetMeasures& set, std::size_t points, double area, double reach)
{
    const double packed = std::sqrt(2 / std::numbers::sqrt3 * area / static_cast<double>(points));
    set.relative_radius = set.least / packed;
    set.nearest_ratio = set.mean_nearest / packed;
    const FrequencyRange low = low_frequency_range(points, 2);
    if (!set.rings.empty() && reach > low_frequency_end) set.low_frequency_mean = mean_power_in(set.rings, low);
    set.effective_nyquist = effective_nyquist_frequency(set.rings, points, 2);
    const bool reaches_lattices = reach >= reach_of_lattices;
    if (reaches_lattices) set.above_chance = anisotropy_above_chance_db(set.rings, 1);
    set.verdict = verdict_of(set, points, reaches_lattices);
}

double curve_width(std::size_t points)
{
    return std::max(1.0, std::round(std::sqrt(static_cast<double>(points)) / rings_of_curve));
}

std::shared_ptr<const SurfaceMesh> surface_of(const MeshSetSettings& settings)
{
    MeshPointSettings of_mesh;
    of_mesh.mesh = settings.mesh;
    return surface_mesh(of_mesh);
}

std::shared_ptr<const MeshWithPoints> read_mesh_set(const MeshSetSettings& settings)
{
    if (settings.read) return settings.read;
    MeshWithPoints read;
    read.surface = settings.surface ? settings.surface : surface_of(settings);
    const FixedSurface& surface = read.surface->surface;
    constexpr double most_area =
        1e120; // its square, which the matrices need, is a double, and so is that of its inverse
    if (!(surface.area >= 1 / most_area && surface.area <= most_area))
        throw InputError(
            fmt::format("{}: the mesh has an area of {:.3g}: must be from 1e-120 to 1e+120; choose another "
                        "unit of length",
                        settings.mesh.string(), surface.area));
    read.mesh = triangles_of(surface);
    if (settings.set.empty()) return std::make_shared<const MeshWithPoints>(std::move(read));
    const PointSet places = points_in_space(settings.set);
    if (places.size() < 2) throw InputError(settings.set.string() + ": has one point; a spectrum needs at least two");
    read.tolerance =
        settings.tolerance.value_or(off_mesh * std::sqrt(surface.area / static_cast<double>(places.size())));
    GivenPoints given = points_on_surface(surface, places, read.tolerance, settings.set);
    read.points = std::move(given.points);
    read.farthest = given.farthest;
    if (!settings.classes.empty()) read.classes = classes_in(settings, places.size());
    return std::make_shared<const MeshWithPoints>(std::move(read));
}

std::vector<SurfacePoint> points_by_method(const std::string& method, std::size_t count,
                                           const std::shared_ptr<const SurfaceMesh>& mesh,
                                           const MeshSetSettings& settings, std::uint64_t seed)
{
    MeshPointSettings of_method;
    of_method.read = mesh;
    of_method.method = *surface_methods.find(method);
    of_method.points = count;
    of_method.normal_angle = settings.normal_angle;
    return make_surface_set(of_method, seed, {.engine = Engine::reference, .device = {}}).points;
}

MeshSpectra measure_mesh_set(const MeshWithPoints& points, const MeshSetSettings& settings, std::uint64_t seed,
                             const std::function<void(const std::string& what)>& on_step)
{
    const FixedSurface& surface = points.surface->surface;
    const std::size_t count = points.points.size();
    const double density = std::sqrt(static_cast<double>(count) / surface.area);
    MeshSpectra spectra;
    spectra.area = surface.area;
    spectra.shape = shape_of(points.mesh);
    spectra.triangles = points.mesh.triangles.size();
    spectra.reach =
        std::min(farthest_spectrum, frequency_of_eigenfunctions(settings.eigenfunctions, surface.area) / density);
    const double highest = eigenvalue_of(spectra.reach * density);
    const double longest = longest_edge_in_wavelengths / frequency_of(highest);
    // Equilateral triangles are the fewest, and there are two of them for each vertex.
    check_room_for_eigenfunctions(std::max(static_cast<double>(points.mesh.vertices.size()),
                                           surface.area / (std::numbers::sqrt3 / 2 * longest * longest)));
    const TriangleMesh mesh = with_edges_up_to(points.mesh, longest);
    check_room_for_eigenfunctions(static_cast<double>(mesh.vertices.size()));
    spectra.elements = mesh.triangles.size();

    const auto made = [&](const std::string& method) {
        if (on_step) on_step(method + " on the mesh, to compare with");
        return points_by_method(method, count, points.surface, settings, seed_beside(seed));
    };
    const auto random = surface_candidates(surface, count, stream_key(seed, Purpose::surface_candidates, 1));
    const TriangleTree tree(mesh);
    std::vector<std::vector<SurfacePoint>> compared{points.points, random, made("darts")};
    for (const std::string& method : methods_beside(settings)) compared.push_back(made(method));
    std::vector<std::vector<MeshPosition>> sets;
    for (const auto& of : compared) sets.push_back(positions_of(tree, points_of(surface, of)));
    EigenfunctionForecast forecast(eigenfunctions_up_to(frequency_of(highest), surface.area), mesh.vertices.size());
    if (on_step) on_step(forecast.first());
    const EigenfunctionPowers found = eigenfunction_powers(mesh, highest, sets, [&](std::size_t done, std::size_t all) {
        if (on_step) on_step(forecast.after(done, all));
    });
    spectra.eigenfunctions = found.eigenvalues.size();
    const PairGround ground{surface, points.mesh,
                            surface_candidates(surface, std::clamp(random_for_each * count, least_random, most_random),
                                               stream_key(seed, Purpose::surface_candidates, 2)),
                            least_cosine(settings.normal_angle)};
    const MeshSetMeasurement measurement(surface, mesh, found, highest, ground, seed);
    const double width = curve_width(count);
    const auto curve = [&](std::size_t number) {
        return eigenfunction_rings(found.eigenvalues, found.powers[number], surface.area, highest, width);
    };
    const auto measures = [&](std::size_t number) {
        if (on_step) on_step(fmt::format("pairs of points along the mesh, set {} of {}", number + 1, compared.size()));
        return measurement.measure(compared[number], sets[number], number);
    };
    spectra.set = measures(0);
    spectra.random = measures(1);
    spectra.darts = measures(2);
    const std::vector<std::string> others = methods_beside(settings);
    for (std::size_t i = 0; i < others.size(); ++i)
        spectra.methods.push_back({others[i], measures(3 + i), curve(3 + i)});
    spectra.set_curve = curve(0);
    spectra.random_curve = curve(1);
    spectra.darts_curve = curve(2);
    return spectra;
}

}
