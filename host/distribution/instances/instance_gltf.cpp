#include "host/distribution/gltf_files.hpp"
#include "host/distribution/instances/instance_files.hpp"
#include "host/distribution/instances/instance_view.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace poissonlab {
namespace {

/// A ball, of corners on a sphere.
TriangleMesh ball_model(double radius)
{
    constexpr int rows = 6;
    std::vector<ModelRing> rings;
    for (int row = 1; row < rows; ++row) {
        const double angle = std::numbers::pi * row / rows;
        rings.push_back({radius * std::sin(angle), radius * std::cos(angle)});
    }
    return turned_model(radius, rings, -radius);
}

TriangleMesh stand_in_mesh(const InstanceSettings& settings, std::uint32_t model, double radius)
{
    if (settings.scene == "asteroids") return ball_model(radius);
    return turned_model(radius * height_of_stand_in(settings, model), {{radius, 0}}, 0);
}

}

void write_instances_glb(const std::filesystem::path& file, const std::vector<Instance>& instances,
                         const InstanceSettings& settings, double radius)
{
    std::vector<GltfInstances> groups(settings.models);
    std::vector<TriangleMesh> models(settings.models);
    for (std::size_t i = 0; i < instances.size(); ++i) {
        const Instance& instance = instances[i];
        GltfInstances& group = groups[instance.model];
        const auto [x, y, z] = instance.position;
        const auto [qw, qx, qy, qz] = orientation_of(instance);
        for (const double c : {x, z, -y}) group.places.push_back(c);
        for (const double c : {qx, qz, -qy, qw}) group.turns.push_back(static_cast<float>(c));
        group.scales.push_back(static_cast<float>(instance.scale));
        group.ids.push_back(static_cast<float>(i));
        if (instance.of_class) group.of_class = static_cast<float>(*instance.of_class);
    }
    for (std::uint32_t model = 0; model < settings.models; ++model) {
        GltfInstances& group = groups[model];
        if (group.ids.empty()) continue;
        models[model] = stand_in_mesh(settings, model, radius);
        group.model = &models[model];
        group.name = fmt::format("model_{}", model);
        const auto color = color_of_model(settings, model);
        for (std::size_t i = 0; i < 3; ++i) group.color[i] = static_cast<float>(color[i]);
    }
    write_instance_glb(file, std::move(groups));
}

}
