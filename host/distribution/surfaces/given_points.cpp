#include "host/distribution/surfaces/given_points.hpp"

#include "base/errors/errors.hpp"
#include "base/points/point_file.hpp"
#include "host/distribution/surfaces/along_surface.hpp"
#include "host/distribution/surfaces/surface_neighbours.hpp"
#include "host/distribution/surfaces/surface_set.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace poissonlab {
namespace {

/// Files of points on a mesh have places that are rounded; farther ones, in units of the grid, are told of.
constexpr double rounded_units = 8;

/// Points of files may be this part of the minimum distance away from the surface.
constexpr double off_surface = 0.1;

}

TriangleMesh triangles_on_grid(const FixedSurface& surface)
{
    TriangleMesh mesh;
    for (const SurfaceTriangle& t : surface.triangles) {
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.triangles.push_back({first, first + 1, first + 2});
        for (std::size_t c = 0; c < 9; c += 3)
            mesh.vertices.push_back({double(t.corners[c]), double(t.corners[c + 1]), double(t.corners[c + 2])});
    }
    return mesh;
}

SurfacePoint surface_point(const FixedSurface& surface, const MeshPosition& position, const MeshPoint& given)
{
    constexpr std::int64_t whole = std::int64_t{1} << contract::surface::BARYCENTRIC_BITS;
    const std::int64_t second = std::llround(position.shares[1] * double(whole)),
                       third = std::min<std::int64_t>(std::llround(position.shares[2] * double(whole)), whole - second);
    SurfacePoint point{};
    point.triangle = position.triangle;
    point.shares[0] = static_cast<std::uint32_t>(second);
    point.shares[1] = static_cast<std::uint32_t>(third);
    const MeshPlace place = place_on(surface.triangles[position.triangle], point.shares[0], point.shares[1]);
    std::ranges::copy(place, point.place);
    MeshPoint rounded = given;
    bool is_there = true;
    for (std::size_t k = 0; k < 3; ++k) {
        rounded[k] = std::round(given[k]);
        is_there = is_there && rounded[k] >= 0 && std::abs(rounded[k] - double(place[k])) <= 1;
    }
    if (is_there) std::ranges::copy(rounded, point.place);
    return point;
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

GivenPoints points_on_surface(const FixedSurface& surface, const PointSet& places, double tolerance,
                              const std::filesystem::path& file)
{
    const TriangleMesh mesh = triangles_on_grid(surface);
    const TriangleTree tree(mesh);
    GivenPoints given;
    std::size_t off = 0, first = 0;
    double first_off = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        MeshPoint place{};
        for (std::size_t k = 0; k < 3; ++k) place[k] = (places[i][k] - surface.origin[k]) / surface.unit;
        const MeshPosition on = tree.nearest(place);
        const MeshPoint away = difference(place_of(mesh, on), place);
        const double distance = std::hypot(away[0], away[1], away[2]) * surface.unit;
        if (distance > tolerance && off++ == 0) first = i, first_off = distance;
        given.farthest = std::max(given.farthest, distance);
        given.points.push_back(surface_point(surface, on, place));
    }
    if (off > 0)
        throw InputError(
            fmt::format("{}: {} of {} points {} farther off the mesh than the tolerance, {:.4g}: the first "
                        "is point {}, ({:.6g}, {:.6g}, {:.6g}), which is {:.4g} off",
                        file.string(), off, places.size(), off == 1 ? "is" : "are", tolerance, first + 1,
                        places[first][0], places[first][1], places[first][2], first_off));
    return given;
}

std::shared_ptr<const SurfaceBeginning> surface_beginning(const MeshPointSettings& settings, const SurfaceMesh& mesh)
{
    if (settings.beginning) return settings.beginning;
    auto beginning = std::make_shared<SurfaceBeginning>();
    beginning->least = INFINITY;
    if (settings.start.empty() && settings.obstacles.empty()) return beginning;
    const FixedSurface& surface = mesh.surface;
    const double distance = surface_distance(settings, mesh);
    const auto read = [&](const std::filesystem::path& file) {
        if (file.empty()) return std::vector<SurfacePoint>{};
        GivenPoints given = points_on_surface(surface, points_in_space(file), off_surface * distance, file);
        if (given.farthest > rounded_units * surface.unit)
            beginning->notes.push_back(
                fmt::format("{}: points were moved to the surface, by at most {:.4g}", file.string(), given.farthest));
        return std::move(given.points);
    };
    beginning->start = read(settings.start);
    beginning->obstacles = read(settings.obstacles);
    const std::vector<SurfacePoint>& start = beginning->start;
    const bool is_kept = settings.min_distance || settings.relative_radius;
    if (settings.points && start.size() > *settings.points)
        throw InputError(fmt::format("{}: has {} points, and the set is to have {}", settings.start.string(),
                                     start.size(), *settings.points));
    if (start.size() < 2) return beginning;
    const bool is_along = settings.metric == SurfaceMetric::surface;
    const std::int32_t cosine = least_cosine(settings.normal_angle);
    beginning->least = (is_along ? distances_along(surface, start).least
                                 : surface_distances(surface, start, cosine, surface.area).least) *
                       (1 - 0x1p-40);
    if (is_kept &&
        !(is_along ? keep_distance_along(surface, start, distance) : keep_distance(surface, start, distance, cosine)))
        throw InputError(fmt::format("{}: two of its points are {:.6g} apart, nearer than the minimum distance, {:.6g}",
                                     settings.start.string(), beginning->least, distance));
    if (beginning->least < least_part_of_size * surface.size)
        throw InputError(fmt::format("{}: two of its points are {:.6g} apart: must be at least {:.4g}",
                                     settings.start.string(), beginning->least, least_part_of_size * surface.size));
    return beginning;
}

}
