// kind = "mesh-set" measures points on a mesh, wherever they come from.
#include "base/files/whole_file.hpp"
#include "base/images/png_file.hpp"
#include "base/text/noun.hpp"
#include "host/distribution/surface_spectra/mesh_set.hpp"
#include "host/distribution/surface_spectra/mesh_set_charts.hpp"
#include "host/distribution/surfaces/surface_pairs.hpp"
#include "host/distribution/surfaces/surface_view.hpp"
#include "host/kinds/kinds.hpp"
#include "host/settings/sampler_table.hpp"
#include "results/curve_tables.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace poissonlab {
namespace {

/// Densities are called uneven below this p-value.
constexpr double uneven = 1e-3;

void mesh_set_keys(Keys& keys, MeshSetSettings& s)
{
    keys.file("set", s.set, "the points: a file of points with three coordinates, in the mesh's units")
        .otherwise("the points of the first method");
    keys.file("mesh", s.mesh, "the surface: a file of polygons, .obj, .ply, .off, .stl, .gltf or .glb", "a mesh")
        .required();
    keys.words(
            "methods", s.methods,
            {std::string(surface_methods[SurfaceMethod::elimination]),
             std::string(surface_methods[SurfaceMethod::lloyd]), std::string(surface_methods[SurfaceMethod::gaussian])},
            "methods that make as many points on the mesh, to be compared; random points and dart throwing are always "
            "compared")
        .otherwise("none");
    keys.integer("points", s.points, 2, max_points, "the number of points of methods")
        .excludes("set")
        .otherwise("as many as the set has");
    keys.integer(
        "eigenfunctions", s.eigenfunctions, 10, 200'000,
        "the approximate number of eigenfunctions; the spectrum ends at 1.6 times the square root of the number of "
        "points per area at the latest");
    keys.number("normal_angle", s.normal_angle, {1, 180},
                "the largest angle between the normals of two points whose distance counts (180 for all)")
        .unit("degrees");
    keys.number("tolerance", s.tolerance, {0, 1e100}, "the largest distance of a point from the mesh")
        .unit("units of the mesh")
        .otherwise("a tenth of the square root of the area per point");
    keys.text("classes", s.classes,
              "the column of a table or the property that has the class of each point: classes are compared by their "
              "nearest-neighbour distances")
        .otherwise("points have no classes");
    if (!keys.is_read()) return;
    if (!s.classes.empty() && s.set.empty()) throw keys.invalid("classes", "needs " + keys.name_of("set"));
    std::vector<std::string> sorted = s.methods;
    std::ranges::sort(sorted);
    if (std::ranges::adjacent_find(sorted) != sorted.end()) throw keys.invalid("methods", "must have each method once");
    if (s.set.empty() && (s.methods.empty() || !s.points))
        throw keys.problem(fmt::format("needs {}, or {} and {}", keys.name_of("set"), keys.name_of("methods"),
                                       keys.name_of("points")));
    keys.check("mesh", [&] { s.surface = surface_of(s); });
    keys.check(s.set.empty() ? "mesh" : "set", [&] { s.read = read_mesh_set(s); });
    for (const auto& file : files_beside_mesh(s.mesh)) keys.reads_too(file);
}

std::string mesh_set_label(const MeshSetSettings& s)
{
    return fmt::format("{} on {}",
                       s.set.empty() ? fmt::format("{}", fmt::join(s.methods, ", ")) : s.set.stem().string(),
                       name_of_input(s.mesh.string()));
}

std::vector<std::string> facts_of(const MeshWithPoints& points, const MeshSpectra& spectra)
{
    std::vector<std::string> facts{
        spectra.set.verdict.words(), fmt::format("{} points", points.points.size()),
        fmt::format("{} triangles", spectra.triangles),
        fmt::format("{} eigenfunctions, up to {:.3g} √(N / area)", spectra.eigenfunctions, spectra.reach)};
    if (spectra.set.counts.parts > 0 && spectra.set.counts.p_value < uneven)
        facts.push_back(
            fmt::format("The density varies more than that of random points: over {} parts of equal area, p "
                        "= {:.2g}",
                        spectra.set.counts.parts, spectra.set.counts.p_value));
    if (spectra.elements > spectra.triangles)
        facts.push_back(
            fmt::format("Triangles with edges longer than {} of the shortest wavelength were divided: there are {} now",
                        longest_edge_in_wavelengths, spectra.elements));
    const MeshPairs& pairs = spectra.set.pairs;
    if (pairs.sources < points.points.size())
        facts.push_back(fmt::format("Paths along the surface were followed from {} of the points", pairs.sources));
    if (pairs.reach < farthest_pair)
        facts.push_back(fmt::format("Paths along the surface end at {:.3g} distances of the densest packing, because "
                                    "{:.0f} triangles lie within",
                                    pairs.reach, most_path_triangles));
    for (const std::string& note : points.surface->notes()) facts.push_back(note);
    const MeshShape& shape = spectra.shape;
    if (shape.open_edges > 0) facts.emplace_back("The surface is open: eigenfunctions have no slope across its border");
    if (shape.parts > 1)
        facts.push_back(
            fmt::format("The mesh has {} parts, each with eigenfunctions of its own: only the counts show whether "
                        "each part has its share of the points",
                        shape.parts));
    if (shape.branching_edges > 0)
        facts.push_back(
            fmt::format("The surface branches at {} {} of more than two triangles; eigenfunctions continue into all "
                        "triangles there",
                        shape.branching_edges, noun(shape.branching_edges, "edge")));
    return facts;
}

DistributionNumbers numbers_of(const MeshWithPoints& points, const MeshSpectra& spectra, bool is_from_file)
{
    const MeshSetMeasures& set = spectra.set;
    DistributionNumbers numbers{
        {"points", "Points", static_cast<double>(points.points.size()), "on the mesh"},
        {"area", "Area", spectra.area, "of the mesh, in squares of its units"},
        {"eigenfunctions", "Eigenfunctions", static_cast<double>(spectra.eigenfunctions),
         "eigenfunctions of the mesh's Laplacian, by which the spectrum is measured"},
        {"spectrum_reach", "End of the spectrum", spectra.reach, "in units of √(N / area)"},
        {"least_distance", "Least distance", set.least,
         "of two points whose normals are near enough, straight through space, in units of the mesh"},
        {"mean_nearest", "Mean nearest distance", set.mean_nearest, "straight through space, in units of the mesh"}};
    if (set.pairs.least_along)
        numbers.push_back({"least_along", "Least distance along the surface", *set.pairs.least_along * set.pairs.unit,
                           "of any two points, in units of the mesh"});
    if (std::isfinite(set.pairs.nearest_along))
        numbers.push_back({"mean_nearest_along", "Mean nearest distance along the surface",
                           set.pairs.nearest_along * set.pairs.unit, "in units of the mesh"});
    if (is_from_file)
        numbers.push_back(
            {"off_mesh", "Largest distance from the mesh", points.farthest,
             fmt::format("before points were put on it, in its units; at most {:.4g} is accepted", points.tolerance)});
    const auto add = [&](const char* key, const char* title, const std::optional<double>& value, const char* meaning) {
        if (value && std::isfinite(*value)) numbers.push_back({key, title, *value, meaning, {}, true});
    };
    add("relative_radius", "Relative radius", set.relative_radius, "");
    add("mean_nearest_distance", "Mean nearest distance, relative", set.nearest_ratio, "");
    add("low_frequency_mean", "Mean power at low frequencies", set.low_frequency_mean, "");
    add("effective_nyquist", "Effective Nyquist frequency", set.effective_nyquist, "");
    add("anisotropy_above_chance", "Peaks above chance", set.above_chance, "");
    if (set.counts.parts > 0) add("counts_p_value", "Evenness of counts", set.counts.p_value, "");
    return numbers;
}

/// Adds the number of points of each class, and the nearest distances within and between classes.
void add_classes(const MeshWithPoints& points, const MeshSetSettings& settings, DistributionResult& result)
{
    const auto& [numbers, names] = points.classes;
    if (names.empty()) return;
    std::vector<std::vector<SurfacePoint>> by_class(names.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) by_class[numbers[i]].push_back(points.points[i]);
    for (std::size_t i = 0; i < names.size(); ++i)
        result.numbers.push_back({fmt::format("points_{}", i), fmt::format("Points of class {}", names[i]),
                                  static_cast<double>(by_class[i].size()), "in the order of the names of classes"});
    const std::vector<SurfacePair> pairs =
        surface_pairs(points.surface->surface, by_class, least_cosine(settings.normal_angle));
    append_pair_numbers(pairs, names, false, result.numbers);
    result.tables.push_back(pair_table(pairs, names, false));
}

DistributionResult measure_on_mesh(const MeshSetSettings& settings, std::uint64_t seed, const DistributionPlace& place,
                                   DistributionFiles& files)
{
    MeshWithPoints points = *read_mesh_set(settings);
    if (settings.set.empty())
        points.points = points_by_method(settings.methods.front(), *settings.points, points.surface, settings, seed);
    const std::string name = settings.set.empty() ? settings.methods.front() : "points";
    const MeshSpectra spectra = measure_mesh_set(points, settings, seed, place.on_step);
    DistributionResult result;
    result.facts = facts_of(points, spectra);
    result.numbers = numbers_of(points, spectra, !settings.set.empty());
    result.tables = {comparison_of(spectra, name, "on this mesh")};
    add_classes(points, settings, result);
    const std::size_t count = points.points.size();
    files.add_curves(
        "power", spectrum_chart(spectra, name, count, {"power", 0, 4, 0.5}, 1, &RadialBin::power),
        "Radially averaged power: the mean power of the mesh's eigenfunctions in rings of equal frequency; "
        "random points have 1, and blue noise has little on the left.",
        result);
    files.add_curves(
        "anisotropy",
        spectrum_chart(spectra, name, count, {"anisotropy (dB)", -20, 40, 5}, 0, &RadialBin::anisotropy_db),
        "Anisotropy: the variance of the power of the eigenfunctions in a ring. Random points have 0 dB, and peaks of "
        "a lattice rise above it.",
        result);
    const FixedSurface& surface = points.surface->surface;
    const SurfaceDots dots{std::isfinite(spectra.set.mean_nearest) ? spectra.set.mean_nearest : 0,
                           surface.open_edges == 0,
                           {points.classes.first.begin(), points.classes.first.end()}};
    write_png(files.add("points.png"), surface_view(surface, points.points, dots));
    result.pictures.push_back({"points.png", dots.classes.empty()
                                                 ? "The points on the mesh, from the front above and from behind above."
                                                 : "The points on the mesh, a colour for each class, from the "
                                                   "front above and from behind above."});
    add_pairs(spectra, name, files, result);
    write_whole_file(files.add("radial.csv", result), radial_csv(spectra.set.rings));
    return result;
}

}

DistributionTable comparison_of(const MeshSpectra& spectra, const std::string& name, const std::string& where)
{
    DistributionTable table{"The points compared with others " + where, {"", name}, {}};
    std::vector<const MeshSetMeasures*> sets{&spectra.set};
    for (const MethodSpectrum& method : spectra.methods) {
        table.columns.push_back(method.name);
        sets.push_back(&method.set);
    }
    table.columns.insert(table.columns.end(), {"random points", "dart throwing"});
    sets.insert(sets.end(), {&spectra.random, &spectra.darts});
    const auto add = [&](const std::string& measure,
                         const std::function<std::optional<double>(const MeshSetMeasures&)>& of) {
        const auto cell = [&](const MeshSetMeasures& set) {
            const auto value = of(set);
            return value && std::isfinite(*value) ? fmt::format("{:.3g}", *value) : std::string("–");
        };
        std::vector<std::string>& row = table.rows.emplace_back(1, measure);
        for (const MeshSetMeasures* set : sets) row.push_back(cell(*set));
    };
    add("Relative radius: the least distance over that of the densest packing in a plane of the same area",
        [](const MeshSetMeasures& set) { return set.relative_radius; });
    add("Mean nearest distance, over that of the densest packing",
        [](const MeshSetMeasures& set) { return set.nearest_ratio; });
    if (spectra.set.pairs.sources > 0)
        add("Mean nearest distance along the surface, over that of the densest packing",
            [](const MeshSetMeasures& set) { return set.pairs.nearest_along; });
    add("Mean power at frequencies up to √(N / area) / 4: random points have 1",
        [](const MeshSetMeasures& set) { return set.low_frequency_mean; });
    add("Effective Nyquist frequency, in units of √(N / area) / 2",
        [](const MeshSetMeasures& set) { return set.effective_nyquist; });
    add("Peaks above chance, dB: 0 where no ring stands out",
        [](const MeshSetMeasures& set) { return set.above_chance; });
    if (const std::size_t parts = spectra.set.counts.parts; parts > 0)
        add(fmt::format("Counts over {} parts of equal area: the probability that those of random points vary as much",
                        parts),
            [](const MeshSetMeasures& set) { return set.counts.p_value; });
    std::vector<std::string>& row = table.rows.emplace_back(1, "Blue noise");
    for (const MeshSetMeasures* set : sets) row.push_back(set->verdict.answer);
    return table;
}

Kind mesh_set_kind()
{
    return make_kind<MeshSetSettings>({"distribution", "mesh-set", "", "Points on a mesh, measured",
                                       "Measure points on a mesh, made here or elsewhere, by the mesh's eigenfunctions",
                                       false},
                                      mesh_set_keys, mesh_set_label, measure_on_mesh);
}

}
