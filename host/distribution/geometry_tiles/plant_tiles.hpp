// Plants in the tiles of a Poisson disk tile set, and lit plants as triangles.
//
// Cohen and others 2003, section 4: plants are placed in tiles by Poisson disk distributions, and "sunflowers that
// intersect a tile boundary are repeated in all tiles with opposite matching colors". Here these are corner tiles or
// template tiles, whose points within a radius of a border are the same in all tiles that fit there, and plants fit the
// disks of their points: what is above a tile follows from the tile, whatever lies around it. All that a plant is
// follows from its place relative to the lattice of tiles, so that it is the same in all tiles that have it.
#pragma once

#include "host/distribution/geometry_tiles/plant_model.hpp"
#include "tiles/poisson/tile_lookup.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace poissonlab {

/// The ways in which plants stand, besides their places.
struct PlantLooks
{
    std::uint32_t models = 1;
    std::array<double, 2> scale{0.8, 1};      ///< of a plant that fits its disk: the range
    std::array<double, 2> turn{-1.57, -1.57}; ///< about z, radians: the range
};

struct Plant
{
    double x = 0, y = 0; ///< of its foot, in tiles from the tile's lower left corner
    std::uint32_t model = 0;
    double scale = 1;
    double turn = 0;

    bool operator==(const Plant&) const = default;

    /// False for those of neighbours that reach into the tile.
    bool is_in_tile() const { return x >= 0 && x < 1 && y >= 0 && y < 1; }
};

/// Throws InputError for tiles whose borders do not decide what is above them: edge tiles, and those with chains.
void check_plant_tiles(const PoissonTileSet& tiles);

/// The radius of disks that do not overlap in any tiling, in tiles, no larger than the strips along borders are wide.
/// Throws InputError as check_plant_tiles() does, and for tiles that have no minimum distance.
double plant_radius(const PoissonTileSet& tiles);

/// The plants whose disks reach into a tile, also those that stand in tiles around it.
std::vector<Plant> plants_of_tile(const PoissonTileSet& tiles, std::uint32_t tile, double radius,
                                  const PlantLooks& looks);

/// A vertex in the light: the place is in tiles, the plant's foot has height 0.
struct LitVertex
{
    MeshPoint place;
    ScreenColor color;
};

/// The vertices of a plant in sunlight, darker near the ground.
void light_plant(const PlantModel& model, const Plant& plant, double radius, std::vector<LitVertex>& vertices);

/// The direction to the sun, and light on a surface with this normal from 0 to 1, that shines through from behind.
extern const MeshPoint plant_sun;
double light_through(const MeshPoint& normal);

}
