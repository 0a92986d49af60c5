// Fields of tiles with plants over a terrain, seen in perspective: as a whole, and by layered depth images of tiles.
//
// Cohen and others 2003, section 4: "render the visible tiles in back to front order. Each tile is selected from the
// appropriate hierarchy level and from the appropriate viewing direction based on its distance and orientation to the
// camera. Each sample point within each tile is splatted to the screen in back to front order". The order of samples is
// that of McMillan: for a parallel projection, pixels that are farther from where the camera is seen come first.
//
// Plants stand upright on the terrain at their feet; the samples of a plant are lifted together.
#pragma once

#include "base/images/png_file.hpp"
#include "host/distribution/geometry_tiles/layered_depth.hpp"
#include "host/distribution/instances/instances.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
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

    /// Makes images, and those of finer levels on the way, which it does not keep.
    void make(const std::vector<Key>& keys);

    const LayeredDepthImage& at(const Key& key) const { return images_.at(key); }
    const std::map<Key, LayeredDepthImage>& all() const { return images_; }

private:
    const PlantTileSet& set_;
    const FieldSettings& settings_;
    std::map<Key, LayeredDepthImage> images_;
};

/// A tile of the field that the camera may see.
struct FieldTile
{
    std::int32_t x = 0, y = 0;
    std::uint32_t tile = 0, direction = 0;
    int level = 0;
    double distance = 0;            ///< of its middle from the camera
    std::array<double, 2> ground{}; ///< its lowest and highest corner of cells of the ground
};

/// The numbers of a picture's bands of distances from the camera: [4^k, 2 * 4^k) tiles and so on.
struct FieldCost
{
    std::uint64_t tiles = 0, samples = 0, triangles = 0;
};

class PlantField
{
public:
    /// The terrain has units of tiles.
    PlantField(const PlantTileSet& set, const PoissonTiling& tiling, const FieldSettings& settings,
               std::optional<Terrain> terrain);

    /// All tiles that may be seen, from the farthest to the nearest: none hides one that comes later.
    const std::vector<FieldTile>& seen() const { return seen_; }

    /// The images that its tiles need.
    std::vector<LayeredTiles::Key> needed() const;

    /// All triangles of all plants that may be seen; samples are moved by a part of their distance.
    PngPixels whole(double moved = 0) const;

    /// Layered depth images of tiles; with `by_level` in a colour for each level.
    PngPixels layered(const LayeredTiles& images, bool by_level = false) const;

    /// Tiles, samples and triangles by distance: band k has those from 2^k to 2^(k + 1) tiles away, band 0 nearer ones.
    std::vector<FieldCost> costs(const LayeredTiles& images) const;

    /// The plan of the field: tiles in the colours of their levels, darker in every other direction.
    PngPixels plan() const;

private:
    struct Canvas;
    struct Splats;

    double ground(double x, double y) const { return terrain_ ? terrain_->at(x, y) : 0; }
    MeshPoint on_screen(const MeshPoint& place) const; ///< column, row and depth, in samples and tiles
    bool may_be_seen(std::int32_t x, std::int32_t y) const;
    std::array<double, 2> rows_of(const FieldTile& tile) const;
    void choose_tiles();
    void draw_sky_and_ground(Canvas& canvas, double moved) const;
    void draw_plants(Canvas& canvas, const FieldTile& tile, double moved) const;
    void draw_image(Canvas& canvas, const FieldTile& tile, const LayeredDepthImage& image, bool by_level) const;
    ScreenColor hazy(const ScreenColor& color, double depth) const;
    template <class Draw>
    PngPixels picture(Draw draw) const;

    const PlantTileSet& set_;
    ptiles_tiling tiling_;
    FieldSettings settings_;
    std::optional<Terrain> terrain_;
    MeshPoint eye_{}, right_{}, down_{}, ahead_{};
    double focal_ = 1;           ///< in samples
    int columns_ = 0, rows_ = 0; ///< samples
    std::vector<FieldTile> seen_;
};

}
