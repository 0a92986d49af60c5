#include "host/distribution/instances/instance_placer.hpp"

#include "base/programs/interrupt.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace poissonlab {
namespace {

using namespace contract::instances;

static_assert(SCALE_CONSTANT == static_cast<int>(SpreadChoice::Kind::constant));
static_assert(SCALE_UNIFORM == static_cast<int>(SpreadChoice::Kind::uniform));
static_assert(SCALE_NORMAL == static_cast<int>(SpreadChoice::Kind::normal));

/// Points that are placed at a time: Ctrl-C waits for these.
constexpr std::size_t placed_at_once = std::size_t{1} << 17;

/// Tiles whose points are placed at a time.
std::size_t tiles_at_once(const PoissonTileSet& tiles)
{
    return std::max<std::size_t>(1, placed_at_once / tiles.parameters.points_per_tile);
}

InstanceScene placed_scene(const ObjectTileSet& tiles, const InstanceSettings& settings)
{
    const auto& [left, bottom, width, height] = settings.window;
    const auto& [inner, outer, thickness] = settings.ring;
    return {tiles_a_unit(tiles, settings),
            left,
            bottom,
            width,
            height,
            inner,
            outer,
            thickness,
            settings.scale.a,
            settings.scale.b,
            settings.tilt,
            static_cast<std::uint32_t>(settings.scale.kind),
            settings.models};
}

/// The tiles that have points in the box: those around it as well, where points lie outside of their tiles.
struct TilesOfBox
{
    std::array<std::int32_t, 3> first{};
    std::array<std::uint64_t, 3> size{1, 1, 1};

    std::uint64_t count() const { return size[0] * size[1] * size[2]; }
};

TilesOfBox tiles_of_box(const InstanceBox& box, const ptiles_set& set)
{
    TilesOfBox tiles;
    for (std::size_t axis = 0; axis < set.dimension; ++axis) {
        const double low = std::floor(box.low[axis] - set.above / 65536.0);
        const double high = std::floor(box.high[axis] + set.below / 65536.0);
        tiles.first[axis] = static_cast<std::int32_t>(low);
        tiles.size[axis] = static_cast<std::uint64_t>(high - low) + 1;
    }
    return tiles;
}

Instance placed(const PlacedInstance& p)
{
    Instance instance;
    std::ranges::copy(p.position, instance.position.begin());
    instance.model = p.model;
    instance.turn = p.turn;
    instance.scale = p.scale;
    instance.tilt = p.tilt;
    instance.tilt_direction = p.tilt_direction;
    std::ranges::copy(p.tile, instance.tile.begin());
    instance.index = p.index;
    instance.id = p.id;
    return instance;
}

}

NeededBuffers InstancePlacer::Buffers::needed(const PoissonTileSet& tiles)
{
    return {{words, (tiles.points.size() + 1) / 2},
            {instances, tiles_at_once(tiles) * tiles.parameters.points_per_tile}};
}

InstancePlacer::InstancePlacer(Device device, const ObjectTileSet& tiles, std::size_t work_group_size)
    : device_(std::move(device)), tiles_(tiles),
      work_group_size_(work_group_size > 0 ? work_group_size : default_work_group_size),
      place_(device_.kernel(kernel_program("instances.cl", {}), "place_instances"))
{
    reserve(device_, buffers_.needed(tiles.tiles()));
    buffers_.words.write(packed_numbers(tiles.tiles().points));
}

DeviceMemory InstancePlacer::memory(const ObjectTileSet& tiles) { return memory_of(Buffers{}.needed(tiles.tiles())); }

std::vector<Instance> InstancePlacer::place(const PoissonTiling& tiling, const InstanceSettings& settings)
{
    const InstanceBox box = instance_box(tiles_, settings);
    std::vector<Instance> instances;
    if (box.is_empty()) return instances;
    const InstanceScene scene = placed_scene(tiles_, settings);
    const contract::objects::ObjectTiles tiles = object_tiles(tiles_, tiling);
    const TilesOfBox all = tiles_of_box(box, runtime_tiling(tiles_.tiles(), tiling).set);
    const std::uint64_t at_once = tiles_at_once(tiles_.tiles());
    for (std::uint64_t begin = 0; begin < all.count(); begin += at_once) {
        stop_if_interrupted();
        const auto count = static_cast<std::uint32_t>(std::min(at_once, all.count() - begin));
        const InstanceTiles block{begin,
                                  count,
                                  static_cast<std::uint32_t>(all.size[0]),
                                  static_cast<std::uint32_t>(all.size[1]),
                                  all.first[0],
                                  all.first[1],
                                  all.first[2]};
        const std::size_t points = std::size_t{count} * tiles.points_per_tile;
        place_.run(points, work_group_size_, scene, tiles, block, buffers_.words, buffers_.instances);
        for (const PlacedInstance& instance : buffers_.instances.read(0, points))
            if (instance.is_inside != 0) instances.push_back(placed(instance));
    }
    return instances;
}

}
