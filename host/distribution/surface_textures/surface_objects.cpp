// This evaluates the procedural object distribution function on a surface of quads: it finds at each pixel of the atlas
// the nearest point of the surface's Poisson disk tiling, whether the place is in its disk, and the object's colour
// there.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, section 7.6, figure 7.13. Disks have half of the tiling's
// distance along the quads for their radius; an object lies in the frame of its point's own quad, which is unfolded
// around the vertex that is nearest to the place.
#include "host/distribution/object_shapes.hpp"
#include "host/distribution/surface_textures/surface_texture.hpp"
#include "host/distribution/surfaces/quad_surface.hpp"
#include "host/distribution/surfaces/tiled_quads.hpp"
#include "tiles/quads/quad_points.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <cmath>
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
        return object_color(&scene_, object_shapes().radii.data(), object.id, static_cast<float>(object.offset[0]),
                            static_cast<float>(object.offset[1]), 0, at, behind, &is_inside);
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

}

DressedSurface surface_of_objects(const SurfaceObjectSettings& settings, std::uint64_t seed)
{
    DressedSurface dressed{quad_surface(settings.quads), {}, {}, {}};
    const QuadSurface& surface = *dressed.surface;
    const double distance = quad_distance(settings.points, surface.mesh.quads.size());
    const QuadPoints points = lay_quad_points(surface.mesh, surface.topology, {distance, 1, seed});
    ObjectScene scene{};
    scene.radius = static_cast<float>(distance / 2);
    scene.size = spread_of(settings.size, 1);
    scene.turn = spread_of(settings.orientation, 2 * std::numbers::pi);
    scene.aspect = spread_of(settings.aspect, 1);
    set_look(scene, settings.object, 2);
    const QuadTriangles triangles = triangles_of(surface.mesh);
    const double side = std::sqrt(triangles.surface.area / static_cast<double>(surface.mesh.quads.size()));
    const ObjectsOnQuads objects(surface, points, scene, 1 / side);

    QuadAtlas& atlas = dressed.atlas;
    constexpr int gutter = 2, samples = 2;
    atlas = QuadAtlas::with(surface.mesh.quads.size(), settings.texels, gutter, 3);
    for (std::uint32_t q = 0; q < surface.mesh.quads.size(); ++q) atlas.cells.push_back({q, 0});
    tbb::parallel_for(std::uint32_t{0}, static_cast<std::uint32_t>(surface.mesh.quads.size()), [&](std::uint32_t q) {
        const auto [left, top] = atlas.corner_of(q);
        const int whole = atlas.side + 2 * gutter;
        const auto part = [&](double pixel) { return std::clamp((pixel - gutter) / atlas.side, 0.0, 1.0); };
        for (int i = 0; i < whole * whole; ++i) {
            std::array<std::uint32_t, 3> sum{};
            for (int s = 0; s < samples * samples; ++s) {
                const double x = i % whole + (s % samples + 0.5) / samples,
                             y = i / whole + (s / samples + 0.5) / samples;
                const std::uint32_t color = objects.color_at(q, part(x), 1 - part(y));
                for (std::uint32_t c = 0; c < 3; ++c) sum[c] += color >> (16 - 8 * c) & 255;
            }
            for (int c = 0; c < 3; ++c)
                atlas.color.values[atlas.color.at(left + i % whole, top + i / whole, c)] =
                    static_cast<std::uint8_t>(sum[static_cast<std::size_t>(c)] / (samples * samples));
        }
    });
    const StretchOfAll stretch = stretch_of_quads(triangles);
    dressed.numbers = quad_numbers(surface, stretch);
    dressed.numbers.push_back({"objects", "Objects", static_cast<double>(points.points.size()), "on the surface"});
    dressed.numbers.push_back({"disk_radius", "Radius of disks", distance / 2, "sides of a tile, along the quads"});
    dressed.numbers.push_back({"share_of_disks", "Share of disks",
                               static_cast<double>(points.points.size()) * std::numbers::pi * distance * distance / 4 /
                                   static_cast<double>(surface.mesh.quads.size()),
                               "of the quads"});
    dressed.facts = {fmt::format("{} objects, {} different tiles", points.points.size(), points.tiles)};
    return dressed;
}

}
