// This evaluates the procedural object distribution function on a surface of quads: it finds at each pixel of the atlas
// the nearest point of the surface's Poisson disk tiling, whether the place is in its disk, and the object's colour
// there.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, section 7.6, figure 7.13. Disks have half of the tiling's
// distance along the quads for their radius; an object lies in the frame of its point's own quad, which is unfolded
// around the vertex that is nearest to the place. A surface that is cut out of a solid, as in figure 7.16, shows at
// each place the object there of Poisson sphere tiles in space.
#include "base/random/random.hpp"
#include "host/distribution/object_shapes.hpp"
#include "host/distribution/object_tiles.hpp"
#include "host/distribution/surface_textures/surface_texture.hpp"
#include "host/distribution/surfaces/quad_surface.hpp"
#include "host/distribution/surfaces/tiled_surface.hpp"
#include "tiles/quads/quad_points.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace poissonlab {
namespace {

using namespace contract::objects;

/// This is the nearest object to a place, and where the place is from its point.
struct NearestObject
{
    double squared = INFINITY;
    std::uint32_t id = 0;
    std::array<double, 2> offset{};
};

class ObjectsOnQuads
{
public:
    ObjectsOnQuads(const QuadSurface& surface, const QuadPoints& points, const ObjectScene& scene, double per_unit)
        : surface_(surface), points_(points), scene_(scene), per_unit_(per_unit),
          first_(surface.mesh.quads.size() + 1, 0)
    {
        for (const QuadPoint& p : points.points) ++first_[p.quad + 1];
        for (std::size_t q = 1; q < first_.size(); ++q) first_[q] += first_[q - 1];
    }

    std::uint32_t color_at(std::uint32_t quad, double u, double v) const
    {
        const NearestObject object = nearest(quad, u, v);
        const MeshPoint place = place_on(surface_.mesh, quad, u, v);
        const auto part = [&](std::size_t k) { return static_cast<float>(place[k] * per_unit_); };
        const std::uint32_t behind = background_color(&scene_, part(0), part(1), part(2));
        const QuadPoint point = object.id > 0 ? points_.points[object.id - 1] : QuadPoint{};
        const ObjectCoordinates at{static_cast<float>(point.u), static_cast<float>(point.v), 0};
        std::uint32_t is_inside = 0;
        const std::uint32_t color =
            object_color(&scene_, object_shapes().radii.data(), object.id, static_cast<float>(object.offset[0]),
                         static_cast<float>(object.offset[1]), 0, at, behind, &is_inside);
        return color == behind ? color : modulated(&scene_, color, part(0), part(1), part(2));
    }

private:
    NearestObject nearest(std::uint32_t quad, double u, double v) const
    {
        const std::uint32_t corner = v < 0.5 ? (u < 0.5 ? 0 : 1) : (u < 0.5 ? 3 : 2);
        const auto own = turned_place(u, v, 4 - corner);
        const auto& around = surface_.topology.around(surface_.mesh.quads[quad][corner]);
        const WedgePlace place{surface_.topology.wedge_of({quad, corner}), own[0], own[1]};
        NearestObject found;
        for (std::uint32_t wedge = 0; wedge < around.size(); ++wedge)
            for (std::size_t i = first_[around[wedge].quad]; i < first_[around[wedge].quad + 1]; ++i) {
                const QuadPoint& p = points_.points[i];
                const auto at = turned_place(p.u, p.v, 4 - around[wedge].corner);
                const WedgePlace point{wedge, at[0], at[1]};
                const double squared = cone_squared(static_cast<std::uint32_t>(around.size()), point, place);
                if (squared >= found.squared) continue;
                found = {squared, static_cast<std::uint32_t>(i) + 1,
                         turned_offset(offset(point, place, around.size()), around[wedge].corner)};
            }
        return found;
    }

    /// Returns the way from a point to a place, along the axes of the point's wedge.
    static std::array<double, 2> offset(const WedgePlace& point, const WedgePlace& place, std::size_t valence)
    {
        const std::size_t after = (place.wedge + valence - point.wedge) % valence;
        // This is the shorter way round; half a turn of four quads is the same both ways.
        const std::size_t turns = 2 * after <= valence ? after : 4 * valence - (valence - after);
        const auto there = turned_offset({place.a, place.b}, static_cast<std::uint32_t>(turns % 4));
        return {there[0] - point.a, there[1] - point.b};
    }

    static std::array<double, 2> turned_offset(const std::array<double, 2>& x, std::uint32_t quarters)
    {
        switch (quarters % 4) {
        case 1:
            return {-x[1], x[0]};
        case 2:
            return {-x[0], -x[1]};
        case 3:
            return {x[1], -x[0]};
        default:
            return x;
        }
    }

    const QuadSurface& surface_;
    const QuadPoints& points_;
    const ObjectScene& scene_;
    double per_unit_;
    std::vector<std::size_t> first_;
};

using ColorAt = std::function<std::uint32_t(std::uint32_t quad, double u, double v)>;

QuadAtlas atlas_of(std::size_t quads, int texels, const ColorAt& color_at)
{
    constexpr int gutter = 2, samples = 2;
    QuadAtlas atlas = QuadAtlas::with(quads, texels, gutter, 3);
    for (std::uint32_t q = 0; q < quads; ++q) atlas.cells.push_back({q, 0});
    tbb::parallel_for(std::uint32_t{0}, static_cast<std::uint32_t>(quads), [&](std::uint32_t q) {
        const auto [left, top] = atlas.corner_of(q);
        const int whole = atlas.side + 2 * gutter;
        const auto part = [&](double pixel) { return std::clamp((pixel - gutter) / atlas.side, 0.0, 1.0); };
        for (int i = 0; i < whole * whole; ++i) {
            std::array<std::uint32_t, 3> sum{};
            for (int s = 0; s < samples * samples; ++s) {
                const double x = i % whole + (s % samples + 0.5) / samples,
                             y = i / whole + (s / samples + 0.5) / samples;
                const std::uint32_t color = color_at(q, part(x), 1 - part(y));
                for (std::uint32_t c = 0; c < 3; ++c) sum[c] += color >> (16 - 8 * c) & 255;
            }
            for (int c = 0; c < 3; ++c)
                atlas.color.values[atlas.color.at(left + i % whole, top + i / whole, c)] =
                    static_cast<std::uint8_t>(sum[static_cast<std::size_t>(c)] / (samples * samples));
        }
    });
    return atlas;
}

ObjectScene looks_of(const SurfaceObjectSettings& settings, double radius)
{
    ObjectScene scene{};
    scene.radius = static_cast<float>(radius);
    scene.size = spread_of(settings.size, 1);
    scene.turn = spread_of(settings.orientation, 2 * std::numbers::pi);
    scene.aspect = spread_of(settings.aspect, 1);
    set_look(scene, settings.object, settings.dimension);
    return scene;
}

void show_objects_on(DressedSurface& dressed, const SurfaceObjectSettings& settings, std::uint64_t seed, double side)
{
    const QuadSurface& surface = *dressed.surface;
    const auto quads = static_cast<double>(surface.mesh.quads.size());
    const double distance = quad_distance(settings.points, surface.mesh.quads.size());
    const QuadPoints points = lay_quad_points(surface.mesh, surface.topology, {distance, 1, seed});
    const ObjectScene scene = looks_of(settings, distance / 2);
    const ObjectsOnQuads objects(surface, points, scene, 1 / side);
    dressed.atlas = atlas_of(surface.mesh.quads.size(), settings.texels,
                             [&](std::uint32_t q, double u, double v) { return objects.color_at(q, u, v); });
    const auto count = static_cast<double>(points.points.size());
    dressed.numbers.push_back({"objects", "Objects", count, "on the surface"});
    dressed.numbers.push_back({"disk_radius", "Radius of disks", distance / 2, "sides of a tile, along the quads"});
    dressed.numbers.push_back({"share_of_disks", "Share of disks",
                               count * std::numbers::pi * distance * distance / 4 / quads, "of the quads"});
    dressed.facts = {fmt::format("{} objects, {} different tiles", points.points.size(), points.tiles)};
}

/// The longest side of the box around a mesh.
double width_of(const QuadMesh& mesh)
{
    double width = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        double low = INFINITY, high = -INFINITY;
        for (const MeshPoint& p : mesh.vertices) low = std::min(low, p[k]), high = std::max(high, p[k]);
        width = std::max(width, high - low);
    }
    return width;
}

void cut_out_of_solid(DressedSurface& dressed, const SurfaceObjectSettings& settings, std::uint64_t seed,
                      const DistributionPlace& place)
{
    const QuadMesh& mesh = dressed.surface->mesh;
    const ObjectTileSet tiles(object_tile_set(settings.tiles, 3, place));
    const pobjects distribution = tiles.distribution({stream_key(seed, Purpose::tile_choice, 0)[0], 0});
    const double a_tile = tiles.tiles().parameters.points_per_tile;
    const double scale = std::cbrt(static_cast<double>(settings.points) / a_tile) / width_of(mesh);
    ObjectScene scene = looks_of(settings, tiles.radius());
    scene.extent = static_cast<float>(scale * width_of(mesh));
    dressed.atlas = atlas_of(mesh.quads.size(), settings.texels, [&](std::uint32_t q, double u, double v) {
        MeshPoint at = place_on(mesh, q, u, v);
        for (double& x : at) x *= scale;
        const pobjects_object object = pobjects_at(&distribution, at.data(), nullptr);
        const auto number = [](double x) { return static_cast<float>(x); };
        const ObjectCoordinates part{number((at[0] - object.offset[0]) / scene.extent + 0.5),
                                     number((at[1] - object.offset[1]) / scene.extent + 0.5),
                                     number((at[2] - object.offset[2]) / scene.extent + 0.5)};
        const std::uint32_t behind = background_color(&scene, number(at[0]), number(at[1]), number(at[2]));
        std::uint32_t is_inside = 0;
        const std::uint32_t color =
            object_color(&scene, object_shapes().radii.data(), object.point.id, number(object.offset[0]),
                         number(object.offset[1]), number(object.offset[2]), part, behind, &is_inside);
        return color == behind ? color : modulated(&scene, color, number(at[0]), number(at[1]), number(at[2]));
    });
    dressed.numbers.push_back({"share_of_balls", "Share of balls",
                               a_tile * 4 / 3 * std::numbers::pi * std::pow(tiles.radius(), 3),
                               "4/3 π R³ of each point, of the largest size"});
    dressed.facts = {fmt::format("cut out of a solid, {} objects in a cube as wide as the mesh", settings.points)};
}

}

DressedSurface surface_of_objects(const SurfaceObjectSettings& settings, std::uint64_t seed,
                                  const DistributionPlace& place)
{
    DressedSurface dressed{quad_surface(settings.quads), {}, {}, {}};
    const QuadTriangles triangles = triangles_of(dressed.surface->mesh);
    dressed.numbers = quad_numbers(*dressed.surface, stretch_of_quads(triangles));
    const auto quads = static_cast<double>(dressed.surface->mesh.quads.size());
    if (settings.dimension == 3)
        cut_out_of_solid(dressed, settings, seed, place);
    else
        show_objects_on(dressed, settings, seed, std::sqrt(triangles.surface.area / quads));
    return dressed;
}

}
