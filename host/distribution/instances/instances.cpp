#include "host/distribution/instances/instances.hpp"

#include "base/errors/errors.hpp"
#include "base/programs/interrupt.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

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

constexpr double most_terrain_height = 1e6; ///< so that differences of places are exact enough to be drawn

}

Terrain::Terrain(const InstanceSettings& settings)
    : heights_(values_of_text(settings.terrain, "light", settings.terrain_area[2], settings.terrain_area[3])),
      area_(settings.terrain_area), scale_(settings.height)
{
    for (std::size_t i = 0; i < heights_.values.size(); ++i) {
        const double height = heights_.values[i];
        const auto refuse = [&](double value, const std::string& allowed) {
            throw InputError(fmt::format("terrain {}: {}: height {}: must be {}",
                                         printable(shortened(settings.terrain)),
                                         pixel_name(heights_.width, heights_.height, i), value, allowed));
        };
        if (!std::isfinite(height)) refuse(height, "finite");
        if (std::abs(scale_ * height) > most_terrain_height)
            refuse(scale_ * height, fmt::format("at most {:.0f} up or down", most_terrain_height));
    }
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
        throw invalid_value(
            {}, "models", fmt::format("{}", settings.models),
            fmt::format("must be at least {}, one for each class of the tiles' points", classes.count()));
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
