#include "host/distribution/surfaces/given_points.hpp"

#include "base/errors/errors.hpp"
#include "base/points/point_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace poissonlab {
namespace {

SurfacePoint surface_point(const FixedSurface& surface, const MeshPosition& position)
{
    const auto share = [&](std::size_t corner) {
        return static_cast<std::uint32_t>(std::ldexp(position.shares[corner], contract::surface::BARYCENTRIC_BITS));
    };
    SurfacePoint point{};
    point.triangle = position.triangle;
    point.shares[0] = share(1);
    point.shares[1] = share(2);
    std::ranges::copy(place_on(surface.triangles[position.triangle], share(1), share(2)), point.place);
    return point;
}

}

TriangleMesh triangles_of(const FixedSurface& surface)
{
    TriangleMesh mesh;
    std::map<std::array<int, 3>, std::uint32_t> numbers;
    for (const SurfaceTriangle& t : surface.triangles) {
        MeshTriangle& triangle = mesh.triangles.emplace_back();
        for (std::size_t c = 0; c < 3; ++c) {
            const std::array<int, 3> corner{t.corners[3 * c], t.corners[3 * c + 1], t.corners[3 * c + 2]};
            const auto [found, is_new] = numbers.try_emplace(corner, static_cast<std::uint32_t>(mesh.vertices.size()));
            triangle[c] = found->second;
            if (!is_new) continue;
            MeshPoint& place = mesh.vertices.emplace_back();
            for (std::size_t k = 0; k < 3; ++k) place[k] = surface.origin[k] + corner[k] * surface.unit;
        }
    }
    return mesh;
}

PointSet points_in_space(const std::filesystem::path& file)
{
    const std::vector<PointSet> sets = read_own_points(file, any_coordinates);
    const std::string name = file.string();
    if (sets.size() != 1)
        throw InputError(fmt::format("{}: has {} sets; points on a mesh are one set", name, sets.size()));
    if (sets.front().dimension != 3) throw InputError(name + ": points on a mesh have three coordinates, x, y and z");
    return sets.front();
}

GivenPoints points_on_surface(const FixedSurface& surface, const TriangleMesh& mesh, const PointSet& places,
                              double tolerance, const std::filesystem::path& file)
{
    const TriangleTree tree(mesh);
    GivenPoints given;
    std::size_t off = 0, first = 0;
    double first_off = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const MeshPoint place{places[i][0], places[i][1], places[i][2]};
        const MeshPosition on = tree.nearest(place);
        const MeshPoint away = difference(place_of(mesh, on), place);
        const double distance = std::sqrt(dot(away, away));
        if (distance > tolerance && off++ == 0) first = i, first_off = distance;
        given.farthest = std::max(given.farthest, distance);
        given.points.push_back(surface_point(surface, on));
    }
    if (off > 0)
        throw InputError(
            fmt::format("{}: {} of {} points {} farther off the mesh than the tolerance, {:.4g}: the first "
                        "is point {}, ({:.6g}, {:.6g}, {:.6g}), which is {:.4g} off",
                        file.string(), off, places.size(), off == 1 ? "is" : "are", tolerance, first + 1,
                        places[first][0], places[first][1], places[first][2], first_off));
    return given;
}

}
