#include "host/distribution/surfaces/surface_instances.hpp"

#include "base/errors/errors.hpp"
#include "base/files/file_kind.hpp"
#include "base/random/random.hpp"
#include "host/distribution/gltf_files.hpp"
#include "host/distribution/surfaces/surface_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace poissonlab {
namespace {

/// This name stands for a cone of height 1, whose base has the radius 1/2.
constexpr auto cone_name = "cone";

/// Models are as far from their axes as this part of the mean spacing of their points.
constexpr double part_of_spacing = 0.35;

/// Turns have random numbers of their own: other uses of the purpose have smaller numbers here.
constexpr std::uint32_t stream_of_turns = 4;

/// The largest distance of a model from its y axis.
double radius_of(const TriangleMesh& model)
{
    double radius = 0;
    for (const MeshTriangle& triangle : model.triangles)
        for (const std::uint32_t corner : triangle)
            radius = std::max(radius, std::hypot(model.vertices[corner][0], model.vertices[corner][2]));
    return radius;
}

/// The rotation by an angle about y, and then that which takes y to `up` by the shortest way: x, y, z, w.
std::array<double, 4> upright(const MeshPoint& up, double angle)
{
    const double across = std::hypot(up[0], up[2]), half = std::atan2(across, up[1]) / 2;
    const double x = across > 0 ? up[2] / across * std::sin(half) : std::sin(half),
                 z = across > 0 ? -up[0] / across * std::sin(half) : 0, w = std::cos(half);
    const double s = std::sin(angle / 2), c = std::cos(angle / 2);
    return {x * c - z * s, w * s, x * s + z * c, w * c};
}

float linear_of(float byte)
{
    const float c = byte / 255;
    return c <= 0.04045F ? c / 12.92F : std::pow((c + 0.055F) / 1.055F, 2.4F);
}

}

void surface_model_keys(Keys& keys, SurfaceModels& models, std::size_t most_models)
{
    KeySpec spec{.value = {.key = "instances",
                           .kind = ParameterSpec::Kind::text,
                           .help = most_models > 1
                                       ? "the models that glTF repeats at the points of each class, y upwards: "
                                         "files of meshes or cone; one for all, or one of each class"
                                       : "the model that glTF repeats at each point, y upwards: a file of a "
                                         "mesh or cone"},
                 .count = most_models,
                 .is_file = true,
                 .own = most_models > 1 ? "a list of files of meshes, or cone, in quotes"
                                        : "a file of a mesh, or cone, in quotes"};
    keys.texts(std::move(spec), models.names,
               most_models > 1 ? "files of meshes, or cone" : "a file of a mesh, or cone")
        .otherwise("glTF has points");
    keys.number("instance_scale", models.scale, {1e-12, 1e12}, "what instances are multiplied by in size")
        .otherwise("one at which neighbours hardly overlap");
    if (keys.is_read() && models.scale && !models.are_given())
        throw keys.invalid("instance_scale", "needs " + keys.name_of("instances"));
}

void read_surface_models(const Keys& keys, SurfaceModels& models, std::size_t classes)
{
    if (!models.are_given()) {
        if (keys.is_given("instances")) throw keys.invalid("instances", "must be at least one model");
        return;
    }
    if (models.names.size() > 1 && models.names.size() != classes)
        throw keys.invalid("instances", fmt::format("must be one for all, or {}, one of each class", classes));
    models.read.clear();
    for (const std::string& name : models.names) {
        if (name == cone_name) {
            models.read.push_back(turned_model(1, {{.radius = 0.5, .height = 0}}, 0));
            continue;
        }
        if (const std::string lack = lack_of_file(name); !lack.empty())
            throw keys.invalid("instances", fmt::format("{}{}: must be a mesh, or {}",
                                                        models.names.size() > 1 ? name + ": " : "", lack, cone_name));
        keys.check("instances", [&] { models.read.push_back(read_triangle_mesh(name, MeshParts::all)); });
        if (!models.scale && radius_of(models.read.back()) == 0)
            throw keys.invalid("instances", fmt::format("{} has no width around its y axis: {} is needed", name,
                                                        keys.name_of("instance_scale")));
    }
}

void check_instance_count(const Keys& keys, const std::string& key, const SurfaceModels& models, double points)
{
    if (models.are_given() && points > static_cast<double>(most_surface_instances))
        throw keys.invalid(key,
                           fmt::format("makes some {:.4g} points: glTF has at most {} instances, whose numbers are "
                                       "exact",
                                       points, most_surface_instances));
}

void write_surface_instances(const std::filesystem::path& file, const FixedSurface& surface,
                             const std::vector<SurfacePoint>& points, const SurfaceClasses& classes,
                             const SurfaceModels& models, std::uint64_t seed)
{
    if (points.size() > most_surface_instances)
        throw InputError(fmt::format("{} instances: glTF has at most {}, whose numbers are exact", points.size(),
                                     most_surface_instances));
    const StreamKey key = stream_key(seed, Purpose::surface_candidates, stream_of_turns);
    const PointSet places = points_of(surface, points);
    std::vector<GltfInstances> groups(1);
    for (std::uint32_t i = 0; i < points.size(); ++i) {
        const std::size_t own = classes.empty() ? 0 : classes[i];
        groups.resize(std::max(groups.size(), own + 1));
        GltfInstances& group = groups[own];
        const double angle = 2 * std::numbers::pi * (philox({i, 0, 0, 0}, key)[0] * 0x1p-32);
        const std::array<double, 4> turn = upright(normal_of(surface.triangles[points[i].triangle]), angle);
        group.places.insert(group.places.end(), places[i].begin(), places[i].end());
        group.turns.insert(group.turns.end(), turn.begin(), turn.end());
        group.ids.push_back(static_cast<float>(i));
    }
    for (std::size_t own = 0; own < groups.size(); ++own) {
        GltfInstances& group = groups[own];
        group.model = &models.read[models.read.size() > 1 ? own : 0];
        group.name = classes.empty() ? "instances" : fmt::format("class_{}", own);
        if (!classes.empty()) group.of_class = static_cast<float>(own);
        const double spacing =
            std::sqrt(surface.area / static_cast<double>(std::max<std::size_t>(1, group.ids.size())));
        const auto scale =
            static_cast<float>(models.scale.value_or(part_of_spacing * spacing / radius_of(*group.model)));
        group.scales.assign(group.ids.size(), scale);
        if (!std::isnormal(scale))
            throw InputError("instances: the model's size, beside that of the mesh, needs a scale that floats do not "
                             "hold: instance_scale gives another");
        const std::array<float, 3> color = color_of_class(own);
        std::ranges::transform(color, group.color.begin(), linear_of);
    }
    write_instance_glb(file, std::move(groups));
}

void check_instance_files(const SurfaceModels& models, const std::vector<std::filesystem::path>& outs)
{
    if (models.are_given() && std::ranges::none_of(outs, [](const auto& out) { return out.extension() == ".glb"; }))
        throw InputError("--instances: needs a .glb file as --out: other files have no instances");
}

}
