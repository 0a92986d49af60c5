#include "host/distribution/geometry_tiles/plant_tiles.hpp"

#include "base/errors/errors.hpp"
#include "kernels/common/fields/instances.h"
#include "tiles/objects/object_lookup.hpp"

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

using namespace contract::instances;

/// Numbers of the tiles around a tile, row by row from the south, such that all fit.
std::array<std::uint32_t, 9> tiles_around(const PoissonTileParameters& p, std::uint32_t tile)
{
    std::array<std::uint32_t, 9> numbers{};
    numbers[4] = tile;
    if (p.kind == PoissonTileKind::frame) return numbers;
    const std::uint32_t c = p.colors;
    std::array<std::array<std::uint32_t, 4>, 4> corners{}; // row by row; the outer ones have colour 0
    corners[2][2] = tile / (c * c * c);
    corners[1][1] = tile / c % c;
    corners[2][1] = tile % c;
    corners[1][2] = tile / (c * c) % c;
    for (std::size_t y = 0; y < 3; ++y)
        for (std::size_t x = 0; x < 3; ++x)
            numbers[3 * y + x] =
                ((corners[y + 1][x + 1] * c + corners[y][x + 1]) * c + corners[y][x]) * c + corners[y + 1][x];
    return numbers;
}

double between(const std::array<double, 2>& range, double part) { return range[0] + (range[1] - range[0]) * part; }

}

void check_plant_tiles(const PoissonTileSet& tiles)
{
    const PoissonTileParameters& p = tiles.parameters;
    if (p.dimension != 2 || p.kind == PoissonTileKind::edge || p.border != TileBorder::strip)
        throw InputError("must be corner tiles or template tiles of the plane whose borders are strips: others do not "
                         "decide which plants of their neighbours reach into them");
}

double plant_radius(const PoissonTileSet& tiles)
{
    check_plant_tiles(tiles);
    if (tiles.squared_min_distance == 0) throw InputError("must be tiles with a minimum distance");
    const double proven = std::sqrt(static_cast<double>(tiles.squared_min_distance)) / 65536;
    return std::min(proven, asked_min_distance(tiles.parameters)) / 2;
}

std::vector<Plant> plants_of_tile(const PoissonTileSet& tiles, std::uint32_t tile, double radius,
                                  const PlantLooks& looks)
{
    const std::array<std::uint32_t, 9> around = tiles_around(tiles.parameters, tile);
    std::vector<Plant> plants;
    for (int k = 0; k < 9; ++k)
        for (std::uint32_t i = 0; i < tiles.parameters.points_per_tile; ++i) {
            const UnitPosition at = tiles.position(around[static_cast<std::size_t>(k)], i);
            Plant plant{at[0] / 65536.0 + k % 3 - 1, at[1] / 65536.0 + k / 3 - 1};
            const double dx = plant.x - std::clamp(plant.x, 0.0, 1.0), dy = plant.y - std::clamp(plant.y, 0.0, 1.0);
            if (dx * dx + dy * dy >= radius * radius) continue;
            const std::uint32_t id = ptiles_hash(0, static_cast<std::uint32_t>(at[0]) & 0xffff,
                                                 static_cast<std::uint32_t>(at[1]) & 0xffff, 0);
            plant.model =
                static_cast<std::uint32_t>(std::uint64_t{pobjects_bits(id, PURPOSE_MODEL)} * looks.models >> 32);
            plant.scale = between(looks.scale, pobjects_uniform(id, PURPOSE_SCALE));
            plant.turn = between(looks.turn, pobjects_uniform(id, PURPOSE_INSTANCE_TURN));
            plants.push_back(plant);
        }
    return plants;
}

const MeshPoint plant_sun = unit({-0.45, -0.5, 0.75});

double light_through(const MeshPoint& normal)
{
    const double cosine = dot(normal, plant_sun);
    return cosine > 0 ? cosine : -0.45 * cosine;
}

void light_plant(const PlantModel& model, const Plant& plant, double radius, std::vector<LitVertex>& vertices)
{
    const double c = std::cos(plant.turn), s = std::sin(plant.turn), size = radius * plant.scale;
    vertices.resize(model.places.size());
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const MeshPoint &p = model.places[i], &n = model.normals[i];
        const MeshPoint normal{c * n[0] - s * n[1], s * n[0] + c * n[1], n[2]};
        const double height = std::clamp(p[2] / std::max(model.height, 1e-9), 0.0, 1.0),
                     open = 0.4 + 0.6 * height * height;
        const double light = open * (0.5 + 0.62 * light_through(normal));
        vertices[i].place = {plant.x + size * (c * p[0] - s * p[1]), plant.y + size * (s * p[0] + c * p[1]),
                             size * p[2]};
        for (std::size_t k = 0; k < 3; ++k)
            vertices[i].color[k] = static_cast<float>(std::min(1.0, light * static_cast<double>(model.colors[i][k])));
    }
}

}
