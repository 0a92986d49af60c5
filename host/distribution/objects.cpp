#include "host/distribution/objects.hpp"

#include "base/errors/errors.hpp"
#include "tiles/poisson/proof/tile_certificate.hpp"

#include <cmath>

namespace poissonlab {

ObjectTileSet::ObjectTileSet(PoissonTileSet tiles) : tiles_(std::move(tiles))
{
    const std::uint64_t squared = tiles_.squared_min_distance;
    if (squared == 0) throw InputError("tiles that promise no minimum distance: objects would overlap");
    radius_ = std::sqrt(static_cast<double>(squared)) / tile_units / 2;
    const ptiles_tiling tiling = runtime_tiling(tiles_, {});
    sorted_.resize(pobjects_size(&tiling.set));
    pobjects_sort(&tiling.set, sorted_.data());
}

pobjects ObjectTileSet::distribution(const PoissonTiling& tiling) const
{
    const ptiles_tiling look_up = runtime_tiling(tiles_, tiling);
    return pobjects_open(&look_up, sorted_.data(), radius_);
}

std::vector<std::uint32_t> packed_numbers(const std::vector<std::uint16_t>& numbers)
{
    std::vector<std::uint32_t> words((numbers.size() + 1) / 2);
    for (std::size_t i = 0; i < numbers.size(); ++i)
        words[i / 2] |= static_cast<std::uint32_t>(numbers[i]) << (i % 2 * 16);
    return words;
}

contract::objects::ObjectTiles object_tiles(const ObjectTileSet& tiles, const PoissonTiling& tiling)
{
    const ptiles_tiling t = runtime_tiling(tiles.tiles(), tiling);
    return {t.set.kind, t.set.dimension, t.set.colors, t.set.tiles, t.set.points_per_tile, t.seed, t.period,
            t.set.low,  t.set.step,      t.set.below,  t.set.above};
}

NeededBuffers ObjectPainter::Buffers::needed(std::size_t numbers, std::size_t radii, std::size_t count)
{
    return {{words, (numbers + 1) / 2}, {shapes, radii}, {pixels, 4 * count}, {ids, count}};
}

ObjectPainter::ObjectPainter(Device device, const ObjectTileSet& tiles, const ObjectShapes& shapes,
                             std::size_t work_group_size)
    : device_(std::move(device)), tiles_(tiles),
      work_group_size_(work_group_size > 0 ? work_group_size : default_work_group_size),
      draw_(device_.kernel(kernel_program("objects.cl", {}), "draw_objects"))
{
    reserve(device_, buffers_.needed(tiles.sorted().size(), shapes.radii.size(), 0));
    buffers_.words.write(packed_numbers(tiles.sorted()));
    buffers_.shapes.write(shapes.radii);
}

DeviceMemory ObjectPainter::memory(const ObjectTileSet& tiles, const ObjectShapes& shapes, std::size_t pixels)
{
    return memory_of(Buffers{}.needed(tiles.sorted().size(), shapes.radii.size(), pixels));
}

ObjectPicture ObjectPainter::draw(const PoissonTiling& tiling, const ObjectScene& scene)
{
    const std::size_t count = std::size_t{scene.width} * scene.height;
    reserve(device_, buffers_.needed(0, 0, count));
    draw_.run(count, work_group_size_, scene, object_tiles(tiles_, tiling), buffers_.words, buffers_.shapes,
              buffers_.pixels, buffers_.ids);
    return {buffers_.pixels.read(0, 4 * count), buffers_.ids.read(0, count)};
}

}
