#include "host/distribution/instances/instances.hpp"

#include "base/errors/errors.hpp"
#include "host/distribution/instances/instance_placer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace poissonlab {
namespace {

/// Points of the tiles around a window: the twin has all of them at once, some 60 bytes each.
constexpr double most_points_around = 1 << 25;

/// Throws InputError where a window is so thin that the tiles around it have far more points than it.
void check_box(const ObjectTileSet& tiles, const InstanceBox& box)
{
    const PoissonTileParameters& p = tiles.tiles().parameters;
    double points = p.points_per_tile;
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(p.dimension); ++axis)
        points *= std::floor(box.high[axis]) - std::floor(box.low[axis]) + 1;
    if (!box.is_empty() && !(points <= most_points_around))
        throw InputError(fmt::format("the tiles around the window have {:.0f} points: must be at most {:.0f}; a window "
                                     "that is less thin, or fewer instances in a unit",
                                     points, most_points_around));
}

}

Terrain::Terrain(const InstanceSettings& settings)
    : heights_(values_of_text(settings.terrain, "light", settings.terrain_area[2], settings.terrain_area[3])),
      area_(settings.terrain_area), scale_(settings.height)
{
    for (std::size_t i = 0; i < heights_.values.size(); ++i)
        if (!std::isfinite(heights_.values[i]))
            throw InputError(fmt::format("terrain {}: {}: height {}: must be finite",
                                         printable(shortened(settings.terrain)),
                                         pixel_name(heights_.width, heights_.height, i), heights_.values[i]));
}

double Terrain::at(double x, double y) const
{
    const auto part = [](double place, double low, double size, int pixels) {
        return std::clamp((place - low) / size * pixels - 0.5, 0.0, pixels - 1.0);
    };
    const double column = part(x, area_[0], area_[2], heights_.width);
    const double row = part(y, area_[1], area_[3], heights_.height);
    const int i = std::min(static_cast<int>(column), std::max(0, heights_.width - 2));
    const int k = std::min(static_cast<int>(row), std::max(0, heights_.height - 2));
    const int right = std::min(i + 1, heights_.width - 1), above = std::min(k + 1, heights_.height - 1);
    const double a = column - i, b = row - k;
    return scale_ * ((1 - b) * ((1 - a) * heights_.at(i, k) + a * heights_.at(right, k)) +
                     b * ((1 - a) * heights_.at(i, above) + a * heights_.at(right, above)));
}

std::optional<Terrain> terrain_of(const InstanceSettings& settings)
{
    if (settings.terrain.empty()) return std::nullopt;
    return Terrain(settings);
}

int instance_dimension(const InstanceSettings& settings) { return settings.scene == "asteroids" ? 3 : 2; }

double instance_radius(const ObjectTileSet& tiles, const InstanceSettings& settings)
{
    return tiles.radius() / tiles_a_unit(tiles, settings);
}

double tiles_a_unit(const ObjectTileSet& tiles, const InstanceSettings& settings)
{
    const double a_unit = settings.density / tiles.tiles().parameters.points_per_tile;
    return instance_dimension(settings) == 3 ? std::cbrt(a_unit) : std::sqrt(a_unit);
}

InstanceBox instance_box(const ObjectTileSet& tiles, const InstanceSettings& settings)
{
    const double unit = tiles_a_unit(tiles, settings);
    const auto& [left, bottom, width, height] = settings.window;
    const double reach = instance_dimension(settings) == 3 ? settings.ring[1] : std::numeric_limits<double>::infinity();
    const double half = settings.ring[2] / 2;
    return {
        {std::max(left, -reach) * unit - 0.5, std::max(bottom, -reach) * unit - 0.5, -half * unit - 0.5},
        {std::min(left + width, reach) * unit + 0.5, std::min(bottom + height, reach) * unit + 0.5, half * unit + 0.5}};
}

void check_models(const InstanceSettings& settings, const TileClasses& classes)
{
    if (settings.models < classes.count())
        throw InputError(fmt::format("models = {}: must be at least {}, one for each class of the tiles' points",
                                     settings.models, classes.count()));
}

void set_classes(std::vector<Instance>& instances, const TileClasses& classes, const InstanceSettings& settings)
{
    const auto count = static_cast<std::uint32_t>(classes.count());
    if (count == 0) return;
    for (Instance& instance : instances) {
        const std::uint32_t own = classes.class_of(instance.index);
        const std::uint32_t models = (settings.models - own + count - 1) / count;
        const std::uint64_t bits = pobjects_bits(instance.id, contract::instances::PURPOSE_MODEL);
        instance.of_class = own;
        instance.model = own + count * static_cast<std::uint32_t>(bits * models >> 32);
    }
}

std::vector<Instance> instances_in(const ObjectTileSet& tiles, const PoissonTiling& tiling,
                                   const InstanceSettings& settings, const DistributionPlace& place)
{
    check_models(settings, tiles.tiles().parameters.classes);
    const std::optional<Terrain> terrain = terrain_of(settings);
    check_box(tiles, instance_box(tiles, settings));
    std::vector<Instance> instances;
    if (place.engine == Engine::reference) {
        instances = reference::place_instances(tiles, tiling, settings);
    } else {
        Device& device = place.device();
        check_fits("placing instances", InstancePlacer::memory(tiles), device.info());
        instances = InstancePlacer(device, tiles).place(tiling, settings);
    }
    set_classes(instances, tiles.tiles().parameters.classes, settings);
    if (terrain)
        for (Instance& instance : instances)
            instance.position[2] = terrain->at(instance.position[0], instance.position[1]);
    return instances;
}

double expected_instances(const InstanceSettings& settings)
{
    const auto& [left, bottom, width, height] = settings.window;
    if (instance_dimension(settings) == 2) return settings.density * width * height;
    const auto& [inner, outer, thickness] = settings.ring;
    // The area of the window in a disk, by strips.
    const auto in_disk = [&](double radius) {
        constexpr int strips = 4096;
        double area = 0;
        const double low = std::max(left, -radius), high = std::min(left + width, radius);
        for (int i = 0; i < strips && low < high; ++i) {
            const double x = low + (i + 0.5) * (high - low) / strips;
            const double half = std::sqrt(std::max(0.0, radius * radius - x * x));
            area += std::max(0.0, std::min(bottom + height, half) - std::max(bottom, -half)) * (high - low) / strips;
        }
        return area;
    };
    return settings.density * (in_disk(outer) - in_disk(inner)) * thickness;
}

}
