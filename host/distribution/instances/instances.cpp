#include "host/distribution/instances/instances.hpp"

#include "base/errors/errors.hpp"
#include "base/programs/interrupt.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace poissonlab {
namespace {

enum InstancePurpose : std::uint32_t
{
    model_purpose = 100,
    turn_purpose = 101,
    tilt_purpose = 102,
    tilt_direction_purpose = 103,
    scale_purpose = 104, ///< and five after it
};

constexpr double smallest_scale = 0.001;

/// Tiles a unit: D 7.6.2.2, where the text has its inverse.
double tiles_a_unit(const ObjectTileSet& tiles, const InstanceSettings& settings)
{
    const double a_unit = settings.density / tiles.tiles().parameters.points_per_tile;
    return instance_dimension(settings) == 3 ? std::cbrt(a_unit) : std::sqrt(a_unit);
}

double scale_of(const SpreadChoice& spread, std::uint32_t id)
{
    using Kind = SpreadChoice::Kind;
    double scale = spread.a;
    if (spread.kind == Kind::uniform) scale += (spread.b - spread.a) * pobjects_uniform(id, scale_purpose);
    if (spread.kind == Kind::normal) scale += spread.b * pobjects_normal(id, scale_purpose);
    return std::clamp(scale, smallest_scale, 1.0);
}

bool is_in_scene(const InstanceSettings& settings, double x, double y)
{
    const auto& [left, bottom, width, height] = settings.window;
    if (x < left || x >= left + width || y < bottom || y >= bottom + height) return false;
    const auto& [inner, outer, thickness] = settings.ring;
    const double squared = x * x + y * y;
    return instance_dimension(settings) == 2 || (squared >= inner * inner && squared < outer * outer);
}

Instance instance_at(const ptiles_point& point, const InstanceSettings& settings, double unit)
{
    Instance instance;
    const std::uint32_t id = point.id;
    for (std::size_t axis = 0; axis < 3; ++axis) instance.position[axis] = point.position[axis] / unit;
    instance.model =
        static_cast<std::uint32_t>(std::uint64_t{pobjects_bits(id, model_purpose)} * settings.models >> 32);
    instance.turn = 2 * std::numbers::pi * pobjects_uniform(id, turn_purpose);
    instance.scale = scale_of(settings.scale, id);
    instance.tilt = settings.tilt * pobjects_uniform(id, tilt_purpose);
    instance.tilt_direction = 2 * std::numbers::pi * pobjects_uniform(id, tilt_direction_purpose);
    std::copy_n(point.tile, 3, instance.tile.begin());
    instance.index = point.index;
    instance.id = id;
    return instance;
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

std::vector<Instance> instances_in(const ObjectTileSet& tiles, const PoissonTiling& tiling,
                                   const InstanceSettings& settings)
{
    const double unit = tiles_a_unit(tiles, settings);
    const int dimension = instance_dimension(settings);
    const auto& [left, bottom, width, height] = settings.window;
    const double reach = dimension == 3 ? settings.ring[1] : std::numeric_limits<double>::infinity();
    const double half = settings.ring[2] / 2;
    const std::optional<Terrain> terrain = terrain_of(settings);
    const ptiles_tiling look_up = runtime_tiling(tiles.tiles(), tiling);
    // Half a tile more to each side: positions in units decide what is in the window, the same for all windows.
    const double low[3] = {std::max(left, -reach) * unit - 0.5, std::max(bottom, -reach) * unit - 0.5,
                           -half * unit - 0.5};
    const double high[3] = {std::min(left + width, reach) * unit + 0.5, std::min(bottom + height, reach) * unit + 0.5,
                            half * unit + 0.5};
    std::vector<Instance> instances;
    if (low[0] >= high[0] || low[1] >= high[1]) return instances;
    std::vector<ptiles_point> points(ptiles_in_window(&look_up, low, high, nullptr, 0, 1));
    ptiles_in_window(&look_up, low, high, points.data(), points.size(), 1);
    stop_if_interrupted();
    for (const ptiles_point& point : points) {
        Instance instance = instance_at(point, settings, unit);
        auto& [x, y, z] = instance.position;
        if (!is_in_scene(settings, x, y) || (dimension == 3 && (z < -half || z >= half))) continue;
        if (terrain) z = terrain->at(x, y);
        instances.push_back(instance);
    }
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
