// Fields of tiles with plants over a terrain, seen in perspective: as a whole, and by layered depth images of tiles.
//
// Cohen and others 2003, section 4: "render the visible tiles in back to front order. Each tile is selected from the
// appropriate hierarchy level and from the appropriate viewing direction based on its distance and orientation to the
// camera. Each sample point within each tile is splatted to the screen in back to front order". The order of samples is
// that of McMillan: for a parallel projection, pixels that are farther from where the camera is seen come first.
//
// Places and colours depend on the C library's sines and may differ by rounding elsewhere.
//
// Plants stand upright on the terrain at their feet; the samples of a plant are lifted together.
#pragma once

#include "base/images/png_file.hpp"
#include "host/distribution/geometry_tiles/layered_tiles.hpp"
#include "host/distribution/instances/instances.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace poissonlab {

struct PlantCanvas;

/// A tile of the field that the camera may see.
struct FieldTile
{
    std::int32_t x = 0, y = 0;
    std::uint32_t tile = 0, direction = 0;
    int level = 0;
    double distance = 0;            ///< of its middle from the camera
    std::array<double, 2> ground{}; ///< its lowest and highest corner of cells of the ground
};

/// The numbers of a band of distances from the camera.
struct FieldCost
{
    std::uint64_t tiles = 0, samples = 0, triangles = 0;
};

/// The colours of a field's picture.
enum class FieldColors
{
    lit,    ///< plants and ground in sunlight and haze
    levels, ///< plants in a colour for each level
    cover   ///< white plants before black
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
    PngPixels whole(double moved = 0, FieldColors colors = FieldColors::lit) const;

    /// Layered depth images of tiles.
    PngPixels layered(const LayeredTiles& images, FieldColors colors = FieldColors::lit) const;

    /// Tiles, samples and triangles by distance: band k has those from 2^k to 2^(k + 1) tiles away, band 0 nearer ones.
    std::vector<FieldCost> costs(const LayeredTiles& images) const;

    /// The plan of the field: tiles in the colours of their levels, darker in every other direction.
    PngPixels plan() const;

private:
    double ground(double x, double y) const { return terrain_ ? terrain_->at(x, y) : 0; }
    MeshPoint on_screen(const MeshPoint& place) const; ///< column, row and depth, in samples and tiles
    bool may_be_seen(const FieldTile& tile) const;
    std::array<double, 2> rows_of(const FieldTile& tile) const;
    void choose_tiles();
    void draw_sky_and_ground(PlantCanvas& canvas, double moved, FieldColors colors) const;
    void draw_plants(PlantCanvas& canvas, const FieldTile& tile, double moved, FieldColors colors) const;
    void draw_image(PlantCanvas& canvas, const FieldTile& tile, const LayeredDepthImage& image,
                    FieldColors colors) const;
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
