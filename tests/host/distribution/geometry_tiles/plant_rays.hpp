// A tile set with plants for tests, and rays that look at every triangle of plants.
#pragma once

#include "host/distribution/geometry_tiles/plant_field.hpp"

#include "host/tile_sampling/tile_set_cache.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace poissonlab {

inline PoissonTileSet built_tiles(PoissonTileKind kind, std::uint32_t tiles, std::uint32_t points)
{
    PoissonTileParameters p;
    p.kind = kind;
    p.colors = kind == PoissonTileKind::corner ? 2 : 1;
    p.tiles = tiles;
    p.points_per_tile = points;
    p.relative_radius = 0.7;
    return build_tile_set(p, Engine::reference, {}).set;
}

inline const PlantLooks some_looks{3, {0.7, 1}, {-2, -1}};

inline const PlantTileSet& some_plants()
{
    static const PlantTileSet set = [] {
        PoissonTileSet tiles = built_tiles(PoissonTileKind::corner, 16, 20);
        const double radius = plant_radius(tiles);
        return PlantTileSet(std::move(tiles), radius, some_looks, sunflower_models(3));
    }();
    return set;
}

/// A triangle in space with colours.
struct LitTriangle
{
    std::array<LitVertex, 3> v;
    MeshPoint lift{};
};

struct RayHit
{
    double distance = INFINITY;
    std::array<double, 3> color{};
    double margin = INFINITY; ///< of the ray from the borders of triangles that it meets or nearly meets
};

/// The place at which a ray meets the triangle, by Möller and Trumbore: its distance and the weights of the corners.
inline std::optional<std::array<double, 4>> met(const MeshPoint& from, const MeshPoint& along, const LitTriangle& t)
{
    const MeshPoint a = difference(t.v[1].place, t.v[0].place), b = difference(t.v[2].place, t.v[0].place);
    const MeshPoint p = cross(along, b);
    const double determinant = dot(a, p);
    if (std::abs(determinant) < 1e-18) return std::nullopt;
    MeshPoint s = difference(from, t.v[0].place);
    s = difference(s, t.lift);
    const MeshPoint q = cross(s, a);
    const double u = dot(s, p) / determinant, v = dot(along, q) / determinant;
    return std::array{dot(b, q) / determinant, 1 - u - v, u, v};
}

/// The nearest hit; `is_counted` may refuse places.
template <class IsCounted>
RayHit cast(const std::vector<LitTriangle>& triangles, const MeshPoint& from, const MeshPoint& along,
            IsCounted is_counted)
{
    RayHit nearest;
    for (const LitTriangle& t : triangles) {
        const auto hit = met(from, along, t);
        if (!hit) continue;
        const double least = std::min({(*hit)[1], (*hit)[2], (*hit)[3]});
        if (least > -1e-6) nearest.margin = std::min(nearest.margin, std::abs(least));
        MeshPoint place{};
        for (std::size_t k = 0; k < 3; ++k) place[k] = from[k] + (*hit)[0] * along[k];
        if (least < 0 || (*hit)[0] >= nearest.distance || !is_counted(place)) continue;
        nearest.distance = (*hit)[0];
        nearest.color = {};
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t k = 0; k < 3; ++k)
                nearest.color[k] += (*hit)[i + 1] * static_cast<double>(t.v[i].color[k]);
    }
    return nearest;
}

inline std::vector<LitTriangle> triangles_of(const std::vector<LitPlant>& plants)
{
    std::vector<LitTriangle> all;
    for (const LitPlant& plant : plants)
        for (const MeshTriangle& t : plant.model->triangles)
            all.push_back({{plant.vertices[t[0]], plant.vertices[t[1]], plant.vertices[t[2]]}});
    return all;
}

}
