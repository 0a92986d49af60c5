// The plain C++ twin of kernels/instances.cl: a loop over the points of a window.
#include "host/distribution/instances/instances.hpp"

#include "base/programs/interrupt.hpp"
#include "kernels/common/fields/instances.h"

#include <algorithm>
#include <numbers>

namespace poissonlab::reference {
namespace {

using namespace contract::instances;

double scale_of(const SpreadChoice& spread, std::uint32_t id)
{
    using Kind = SpreadChoice::Kind;
    double scale = spread.a;
    if (spread.kind == Kind::uniform) scale += (spread.b - spread.a) * pobjects_uniform(id, PURPOSE_SCALE);
    if (spread.kind == Kind::normal) scale += spread.b * pobjects_normal(id, PURPOSE_SCALE);
    return std::clamp(scale, LEAST_SCALE, 1.0);
}

bool is_in_scene(const InstanceSettings& settings, const std::array<double, 3>& position)
{
    const auto& [left, bottom, width, height] = settings.window;
    const auto& [x, y, z] = position;
    if (x < left || x >= left + width || y < bottom || y >= bottom + height) return false;
    if (instance_dimension(settings) == 2) return true;
    const auto& [inner, outer, thickness] = settings.ring;
    const double squared = x * x + y * y;
    return squared >= inner * inner && squared < outer * outer && z >= -thickness / 2 && z < thickness / 2;
}

Instance instance_at(const ptiles_point& point, const InstanceSettings& settings, double unit)
{
    Instance instance;
    const std::uint32_t id = point.id;
    for (std::size_t axis = 0; axis < 3; ++axis) instance.position[axis] = point.position[axis] / unit;
    instance.model =
        static_cast<std::uint32_t>(std::uint64_t{pobjects_bits(id, PURPOSE_MODEL)} * settings.models >> 32);
    instance.turn = 2 * std::numbers::pi * pobjects_uniform(id, PURPOSE_INSTANCE_TURN);
    instance.scale = scale_of(settings.scale, id);
    instance.tilt = settings.tilt * pobjects_uniform(id, PURPOSE_TILT);
    instance.tilt_direction = 2 * std::numbers::pi * pobjects_uniform(id, PURPOSE_TILT_DIRECTION);
    std::copy_n(point.tile, 3, instance.tile.begin());
    instance.index = point.index;
    instance.id = id;
    return instance;
}

}

std::vector<Instance> place_instances(const ObjectTileSet& tiles, const PoissonTiling& tiling,
                                      const InstanceSettings& settings)
{
    const InstanceBox box = instance_box(tiles, settings);
    std::vector<Instance> instances;
    if (box.is_empty()) return instances;
    const ptiles_tiling look_up = runtime_tiling(tiles.tiles(), tiling);
    std::vector<ptiles_point> points(ptiles_in_window(&look_up, box.low.data(), box.high.data(), nullptr, 0, 1));
    ptiles_in_window(&look_up, box.low.data(), box.high.data(), points.data(), points.size(), 1);
    stop_if_interrupted();
    const double unit = tiles_a_unit(tiles, settings);
    for (const ptiles_point& point : points) {
        const Instance instance = instance_at(point, settings, unit);
        if (is_in_scene(settings, instance.position)) instances.push_back(instance);
    }
    return instances;
}

}
