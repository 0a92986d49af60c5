// Pictures of objects that the procedural object distribution function places: runtime/object_distribution.h.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, section 7.6, figures 7.7 to 7.16.
#pragma once

#include "host/device/needed_buffers.hpp"
#include "tiles/objects/object_lookup.hpp"

#include "kernels/common/fields/object_looks.h"

#include <cstdint>
#include <vector>

namespace poissonlab {

using contract::objects::ObjectScene;

/// A picture, row by row from the top.
struct ObjectPicture
{
    std::vector<std::uint8_t> pixels; ///< red, green, blue, and the number of samples in disks
    std::vector<std::uint32_t> ids;   ///< of the objects nearest to the first samples, 0 where there is none
};

/// The tiles of a set, sorted for pobjects_at(); their proven minimum distance.
class ObjectTileSet
{
public:
    /// Throws InputError for tiles without a minimum distance.
    explicit ObjectTileSet(PoissonTileSet tiles);

    const PoissonTileSet& tiles() const { return tiles_; }
    const std::vector<std::uint16_t>& sorted() const { return sorted_; }

    /// The radius of disks, in tiles.
    double radius() const { return radius_; }

    /// The distribution for look-ups on the host; this must outlive it.
    pobjects distribution(const PoissonTiling& tiling) const;

private:
    PoissonTileSet tiles_;
    std::vector<std::uint16_t> sorted_;
    double radius_ = 0;
};

/// The shapes that layers name by their numbers: SHAPE_STEPS radii each.
struct ObjectShapes
{
    std::vector<float> radii;

    std::uint32_t size() const { return static_cast<std::uint32_t>(radii.size() / contract::objects::SHAPE_STEPS); }
};

namespace reference {
/// Looks at all points of all tiles around.
ObjectPicture draw_objects(const ObjectTileSet& tiles, const PoissonTiling& tiling, const ObjectScene& scene,
                           const ObjectShapes& shapes);
}

/// Draws by kernels/objects.cl: the same objects, and colours that differ by rounding at most. Tiles and shapes are
/// copied to the device once.
class ObjectPainter
{
public:
    /// `work_group_size` 0: the default. The tile set must outlive this.
    ObjectPainter(Device device, const ObjectTileSet& tiles, const ObjectShapes& shapes,
                  std::size_t work_group_size = 0);

    /// The memory for so many pixels.
    static DeviceMemory memory(const ObjectTileSet& tiles, const ObjectShapes& shapes, std::size_t pixels);

    ObjectPicture draw(const PoissonTiling& tiling, const ObjectScene& scene);

private:
    struct Buffers
    {
        Buffer<std::uint32_t> words, ids;
        Buffer<float> shapes;
        Buffer<std::uint8_t> pixels;

        NeededBuffers needed(std::size_t numbers, std::size_t radii, std::size_t count);
    };

    Device device_;
    const ObjectTileSet& tiles_;
    std::size_t work_group_size_;
    Buffers buffers_;
    Kernel draw_;
};

/// Numbers of 16 bits, two a word, as kernels take those of points.
std::vector<std::uint32_t> packed_numbers(const std::vector<std::uint16_t>& numbers);

/// The tiling as the kernel takes it.
contract::objects::ObjectTiles object_tiles(const ObjectTileSet& tiles, const PoissonTiling& tiling);

}
