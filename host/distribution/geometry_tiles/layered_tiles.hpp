// Tile sets with plants, and the layered depth images of their tiles by direction and level.
#pragma once

#include "base/images/png_file.hpp"
#include "host/distribution/geometry_tiles/layered_depth.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <tuple>
#include <vector>

namespace poissonlab {

/// Each pixel of a picture is the mean of so many samples along each axis.
inline constexpr int field_samples = 2;

struct FieldSettings
{
    std::array<std::uint32_t, 2> field{64, 64}; ///< tiles along x and y
    std::array<double, 3> eye{32, 0.5, 1.5};    ///< x and y in tiles, and the height above the ground
    double heading = 90;                        ///< in which the camera looks, degrees from x towards y
    double pitch = 10;                          ///< down from the horizon, degrees
    double angle_of_view = 55;                  ///< along the picture's width, degrees
    std::uint32_t pixels = 960;                 ///< the picture's width; its height is 9/16 of it
    std::uint32_t resolution = 256;             ///< pixels of a tile's side at level 0
    std::uint32_t levels = 7;
    std::uint32_t directions = 8;
    double sample_size = 1; ///< largest side of a sample in pixels of the picture
    double haze = 150;      ///< distance in tiles at which half of a colour is haze
};

/// A tile set with plants, all that fields need of it.
struct PlantTileSet
{
    PlantTileSet(PoissonTileSet set, double disk_radius, const PlantLooks& looks, std::vector<PlantModel> plant_models);

    PoissonTileSet tiles;
    double radius; ///< of plants, in tiles
    std::vector<PlantModel> models;
    std::vector<std::vector<Plant>> plants; ///< of each tile
    double height = 0;                      ///< of the highest plant, in tiles
};

/// Sampled pictures of tiles, made when they are asked for.
class LayeredTiles
{
public:
    using Key = std::tuple<std::uint32_t, std::uint32_t, int>; ///< tile, direction, level

    LayeredTiles(const PlantTileSet& set, const FieldSettings& settings) : set_(set), settings_(settings) {}

    DepthView view(std::uint32_t direction) const;

    /// Makes images, and those of finer levels on the way, which it does not keep. Throws InputError where they have no
    /// room in memory.
    void make(const std::vector<Key>& keys);

    /// The images of the first tile as they are seen from their directions: a row for each level.
    PngPixels sheet() const;

    const LayeredDepthImage& at(const Key& key) const { return images_.at(key); }
    const std::map<Key, LayeredDepthImage>& all() const { return images_; }

private:
    void check_room(const std::vector<Key>& keys) const;

    const PlantTileSet& set_;
    const FieldSettings& settings_;
    std::map<Key, LayeredDepthImage> images_;
};

}
