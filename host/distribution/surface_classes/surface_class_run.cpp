// kind = "surface-classes": points of several classes on the triangles of a mesh, each and all together even.
//
// Wei, Multi-class blue noise sampling, SIGGRAPH 2010; Cline et al., Dart throwing on surfaces, EGSR 2009.
#include "host/distribution/surface_classes/surface_class_run.hpp"

#include "base/errors/errors.hpp"
#include "base/images/png_file.hpp"
#include "base/points/point_file.hpp"
#include "host/distribution/classes/class_files.hpp"
#include "host/distribution/classes/class_lists.hpp"
#include "host/distribution/surface_classes/surface_class_set.hpp"
#include "host/distribution/surfaces/surface_files.hpp"

#include <fmt/format.h>

#include <fmt/ranges.h>
#include <numeric>

namespace poissonlab {
namespace {

/// Says what is wrong with densities at their key, and what else is wrong with the set at the key of its distances.
void check_set(const Keys& keys, SurfaceClassSettings& s)
{
    const ClassSettings& classes = s.classes;
    keys.check("mesh", [&] { s.read = surface_class_mesh(s); });
    std::string wrong_density;
    keys.check(!classes.matrix.empty()      ? "matrix"
               : !classes.distances.empty() ? "distances"
                                            : "points",
               [&] {
                   try {
                       surface_class_work(s, 0);
                   } catch (const SurfaceDensityError& error) {
                       wrong_density = error.what();
                   }
               });
    if (!wrong_density.empty()) keys.check("densities", [&] { throw InputError(wrong_density); });
}

void surface_class_keys(Keys& keys, SurfaceClassSettings& s)
{
    ClassSettings& classes = s.classes;
    keys.file("mesh", s.mesh, "the surface: a file of polygons, .obj, .ply, .off, .stl, .gltf or .glb", "a mesh")
        .required();
    class_list_keys(keys, classes, {1e-12, 1e12}, "units of the mesh");
    keys.number("factor", classes.factor, {0.5, 0.9999},
                "what all distances are multiplied by where a class has no room for its points: relaxation")
        .otherwise("distances stay");
    class_density_keys(
        keys, classes,
        "the density of each class, in any unit: a formula in x, y and z in the mesh's units; the name of a "
        "number of its vertices, such as red or quality; or a picture over its texture coordinates");
    keys.word("distance", s.metric, surface_metrics, surface_metric_help);
    keys.number("normal_angle", s.normal_angle, {1, 180},
                "the largest angle between normals of points that keep a distance; 180: all do")
        .unit("degrees");
    keys.flag(
        "faces", s.faces,
        "whether files of points (PLY, CSV) have the face, the barycentric coordinates, and the numbers that the mesh "
        "has at its vertices: normals, colours, texture coordinates and others");
    surface_model_keys(keys, s.instances, most_classes);
    if (!keys.is_read()) return;
    check_class_lists(keys, classes);
    if (s.metric == SurfaceMetric::surface) {
        if (keys.is_given("normal_angle"))
            throw keys.invalid("normal_angle",
                               fmt::format("cannot be combined with {} surface", keys.name_of("distance")));
        s.normal_angle = 180;
    }
    if (keys.is_given("factor") && classes.points.empty())
        throw keys.invalid("factor", "needs " + keys.name_of("points"));
    if (!classes.densities.empty() && classes.points.empty())
        throw keys.invalid("densities", "needs " + keys.name_of("points"));
    if (keys.is_given("densities_from") && classes.densities.empty())
        throw keys.invalid("densities_from", "needs " + keys.name_of("densities"));
    const auto check_count = [&](const char* key, std::size_t count, std::size_t least) {
        if (count > least && count != classes.classes())
            throw keys.invalid(key, fmt::format("must be {}, one of each class", classes.classes()));
    };
    check_count("densities", classes.densities.size(), 0);
    check_count("densities_from", classes.densities_from.size(), 1);
    check_set(keys, s);
    read_surface_models(keys, s.instances, classes.classes());
    check_instance_count(
        keys, "points", s.instances,
        static_cast<double>(std::accumulate(classes.points.begin(), classes.points.end(), std::size_t{0})));
    for (const auto& file : files_beside_mesh(s.mesh)) keys.reads_too(file);
    for (const std::string& model : s.instances.names)
        for (const auto& file : files_beside_mesh(model)) keys.reads_too(file);
}

std::string surface_class_label(const SurfaceClassSettings& s)
{
    const std::string mesh = name_of_input(s.mesh.string());
    return s.classes.points.empty() ? fmt::format("{} classes on {}, saturated", s.classes.classes(), mesh)
                                    : fmt::format("{} classes on {}, {} points", s.classes.classes(), mesh,
                                                  fmt::join(s.classes.points, ", "));
}

DistributionResult make_surface_classes(const SurfaceClassSettings& settings, std::uint64_t seed,
                                        const DistributionPlace& place, DistributionFiles& files)
{
    const SurfaceClassSet set = throw_surface_classes(settings, seed, place);
    const ClassSurfaceDarts& darts = set.darts;
    DistributionResult result;
    result.facts = {
        fmt::format("{} classes", darts.is_full.size()), fmt::format("{} points", darts.points.size()),
        settings.classes.points.empty() ? "saturated: no further point of any class fits"
        : settings.classes.factor == 1.0
            ? "as many of each class as asked for"
            : fmt::format("distances multiplied by {} until there is room for all", settings.classes.factor),
        settings.classes.matrix.empty() ? "distances of pairs by Wei's matrix" : "distances of pairs as given",
        fmt::format("{} triangles", set.surface().triangles.size())};
    if (set.metric == SurfaceMetric::surface) result.facts.emplace_back("distances along the surface");
    for (const std::string& note : set.work.mesh->notes()) result.facts.push_back(note);
    write_png(files.add("points.png"), surface_view(set.surface(), darts.points, dots_of(set)));
    result.pictures.push_back({"points.png",
                               "The points on their surface, a colour for each class: left from the front "
                               "above, right from behind above."});
    write_surface_points(files.add("points.ply", result), set.surface(), darts.points, darts.classes, "",
                         settings.faces ? &set.work.mesh->mesh : nullptr);
    if (settings.instances.are_given())
        write_surface_instances(files.add("instances.glb", result), set.surface(), darts.points, darts.classes,
                                settings.instances, seed);
    write_points(files.add("points.npy", result), points_of(set.surface(), darts.points));
    write_points(files.add("normals.npy", result), normals_of(set.surface(), darts.points));
    write_class_numbers(files.add("classes.npy", result), darts.classes);
    const std::vector<SurfacePair> pairs = pairs_of(set);
    result.numbers = surface_class_numbers(set, pairs);
    result.tables.push_back(pair_table(pairs, class_numbers_as_names(set), set.metric == SurfaceMetric::surface));
    return result;
}

}

Kind surface_class_kind()
{
    return make_kind<SurfaceClassSettings>(
        {"distribution", "surface-classes", "distribute surface-classes", "Classes of points on a surface",
         "Throw darts of several classes on the triangles of a mesh, each and all together even"},
        surface_class_keys, surface_class_label, make_surface_classes);
}

}
