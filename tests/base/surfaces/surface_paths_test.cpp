// Shortest paths on meshes are compared with those of CGAL, and with the closed forms of planes, cubes and cones.
#include "base/surfaces/surface_paths.hpp"

#include "tests/support/meshes.hpp"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace poissonlab {
namespace {

using PathKernel = CGAL::Simple_cartesian<double>;
using PathMesh = CGAL::Surface_mesh<PathKernel::Point_3>;
using CgalPaths = CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<PathKernel, PathMesh>>;

std::vector<MeshPosition> positions_on(const TriangleMesh& mesh, std::size_t count, unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> share;
    std::vector<MeshPosition> positions;
    for (std::size_t i = 0; i < count; ++i) {
        double a = share(random), b = share(random);
        if (a + b > 1) a = 1 - a, b = 1 - b;
        positions.push_back({static_cast<std::uint32_t>(random() % mesh.triangles.size()), {1 - a - b, a, b}});
    }
    return positions;
}

/// The paths of each source.
std::vector<std::vector<SurfacePath>> paths_from(const TriangleMesh& mesh, const std::vector<MeshPosition>& sources,
                                                 const std::vector<MeshPosition>& targets, double reach)
{
    std::vector<std::vector<SurfacePath>> found(sources.size());
    SurfacePaths(mesh, targets).from_each(sources, reach, [&](std::size_t i, std::span<const SurfacePath> paths) {
        found[i].assign(paths.begin(), paths.end());
    });
    return found;
}

/// A mesh of hills and saddles, which may be closed.
TriangleMesh bumpy(TriangleMesh mesh, double height)
{
    for (MeshPoint& p : mesh.vertices) {
        const double k = 1 + height * std::sin(7 * p[0] + 1) * std::sin(5 * p[1] + 2) * std::cos(6 * p[2]);
        p = {k * p[0], k * p[1], k * p[2] + height * std::sin(9 * p[0]) * std::cos(8 * p[1])};
    }
    return mesh;
}

void expect_as_cgal(const TriangleMesh& mesh, double reach, unsigned seed)
{
    PathMesh of_cgal;
    for (const MeshPoint& p : mesh.vertices) of_cgal.add_vertex({p[0], p[1], p[2]});
    std::vector<PathMesh::Face_index> faces;
    for (const auto& [a, b, c] : mesh.triangles)
        faces.push_back(
            of_cgal.add_face(PathMesh::Vertex_index(a), PathMesh::Vertex_index(b), PathMesh::Vertex_index(c)));
    const std::vector<MeshPosition> sources = positions_on(mesh, 3, seed), targets = positions_on(mesh, 60, seed + 1);
    const auto found = paths_from(mesh, sources, targets, reach);
    // CGAL's barycentric coordinates begin with the source of the face's own halfedge.
    const auto shares_of = [&](const MeshPosition& position) {
        const auto start = source(halfedge(faces[position.triangle], of_cgal), of_cgal);
        std::size_t first = 0;
        while (mesh.triangles[position.triangle][first] != start.idx()) ++first;
        const auto& s = position.shares;
        return CgalPaths::Barycentric_coordinates{s[first], s[(first + 1) % 3], s[(first + 2) % 3]};
    };
    for (std::size_t i = 0; i < sources.size(); ++i) {
        CgalPaths paths(of_cgal);
        paths.add_source_point(faces[sources[i].triangle], shares_of(sources[i]));
        std::size_t at = 0;
        for (std::uint32_t t = 0; t < targets.size(); ++t) {
            const double length =
                paths.shortest_distance_to_source_points(faces[targets[t].triangle], shares_of(targets[t])).first;
            const bool is_found = at < found[i].size() && found[i][at].target == t;
            if (length >= 0 && std::abs(length - reach) > 1e-6) {
                EXPECT_EQ(is_found, length <= reach) << length;
            }
            if (!is_found) continue;
            EXPECT_NEAR(found[i][at].length, length, 1e-7);
            EXPECT_NEAR(std::sqrt(dot(found[i][at].way, found[i][at].way)), length, 1e-7);
            ++at;
        }
        EXPECT_EQ(at, found[i].size());
    }
}

TEST(SurfacePaths, AreThoseOfCgal)
{
    for (const double reach : {0.3, 1.0, 9.0}) {
        expect_as_cgal(sphere_mesh(10), reach, 1);
        for (const double height : {0.1, 0.3, 0.6}) {
            expect_as_cgal(bumpy(sphere_mesh(12), height), reach, 2);
            expect_as_cgal(bumpy(square_mesh(9), height), reach, 3);
        }
    }
}

/// A path in the plane is straight, and its way is the difference of its ends.
TEST(SurfacePaths, OfAPlaneAreDifferences)
{
    for (const std::uint32_t rows : {1u, 2u, 3u, 17u}) {
        const TriangleMesh mesh = square_mesh(rows);
        const std::vector<MeshPosition> targets = positions_on(mesh, 50, rows);
        const auto found = paths_from(mesh, targets, targets, 2);
        for (std::size_t i = 0; i < targets.size(); ++i) {
            ASSERT_EQ(found[i].size(), targets.size());
            for (const SurfacePath& path : found[i]) {
                const MeshPoint way = difference(place_of(mesh, targets[path.target]), place_of(mesh, targets[i]));
                for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(path.way[k], way[k], 1e-8);
            }
        }
    }
}

/// Paths go around the edge of a hole of an L, from one arm to the other.
TEST(SurfacePaths, GoAroundCornersOfOpenSurfaces)
{
    TriangleMesh mesh = square_mesh(2);
    mesh.triangles.erase(mesh.triangles.begin() + 6, mesh.triangles.end()); // without the square beyond 0.5, 0.5
    const std::vector<MeshPosition> ends{{3, {1, 0, 0}}, {5, {0, 1, 0}}};
    const MeshPoint a = place_of(mesh, ends[0]), b = place_of(mesh, ends[1]), corner{0.5, 0.5, 0};
    const auto found = paths_from(mesh, {ends[0]}, ends, 9);
    ASSERT_EQ(found[0].size(), 2U);
    const MeshPoint to = difference(corner, a), on = difference(b, corner);
    EXPECT_NEAR(found[0][1].length, std::sqrt(dot(to, to)) + std::sqrt(dot(on, on)), 1e-8);
}

/// Does the line from a to b enter the inside of the square that begins at `low`?
bool crosses_square(const MeshPoint& a, const MeshPoint& b, const MeshPoint& low, double side)
{
    constexpr double rounding = 1e-7;
    double from = 0, to = 1;
    for (std::size_t k = 0; k < 2; ++k) {
        const double first = low[k] + rounding - a[k], last = low[k] + side - rounding - a[k], way = b[k] - a[k];
        if (std::abs(way) < 1e-12) {
            if (first >= 0 || last <= 0) return false;
            continue;
        }
        from = std::max(from, std::min(first / way, last / way));
        to = std::min(to, std::max(first / way, last / way));
    }
    return from < to;
}

/// The length of the shortest path in the plane around a square hole, through any of its corners.
double length_around_square(const MeshPoint& a, const MeshPoint& b, const MeshPoint& low, double side)
{
    std::array<MeshPoint, 6> places{a, b};
    for (std::size_t c = 0; c < 4; ++c)
        places[2 + c] = {low[0] + side * static_cast<double>(c % 2), low[1] + side * static_cast<double>(c / 2), 0};
    std::array<double, 6> lengths{0, 9, 9, 9, 9, 9};
    for (int round = 0; round < 6; ++round)
        for (std::size_t i = 0; i < 6; ++i)
            for (std::size_t j = 0; j < 6; ++j) {
                const MeshPoint way = difference(places[j], places[i]);
                if (!crosses_square(places[i], places[j], low, side))
                    lengths[j] = std::min(lengths[j], lengths[i] + std::sqrt(dot(way, way)));
            }
    return lengths[1];
}

/// Lines from the middles of triangles of a lattice go through several of its vertices, the last of which may be the
/// corner of a hole.
TEST(SurfacePaths, GoAroundHolesOfLattices)
{
    constexpr std::uint32_t rows = 5;
    for (const std::uint32_t cell : {6u, 7u, 8u, 11u, 12u, 13u, 16u, 17u, 18u}) { // those that leave a way around them
        const MeshPoint low{double(cell % rows) / rows, double(cell / rows) / rows, 0};
        TriangleMesh mesh = square_mesh(rows);
        std::erase_if(mesh.triangles, [&](const MeshTriangle& t) {
            const auto middle = [&](std::size_t k) {
                return (mesh.vertices[t[0]][k] + mesh.vertices[t[1]][k] + mesh.vertices[t[2]][k]) / 3 - low[k];
            };
            return middle(0) > 0 && middle(0) < 1.0 / rows && middle(1) > 0 && middle(1) < 1.0 / rows;
        });
        ASSERT_EQ(mesh.triangles.size(), 2 * (rows * rows - 1));
        std::vector<MeshPosition> middles;
        for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) middles.push_back({t, {1.0 / 3, 1.0 / 3, 1.0 / 3}});
        const auto found = paths_from(mesh, middles, middles, 9);
        for (std::size_t i = 0; i < middles.size(); ++i) {
            ASSERT_EQ(found[i].size(), middles.size());
            for (const SurfacePath& path : found[i])
                EXPECT_NEAR(path.length,
                            length_around_square(place_of(mesh, middles[i]), place_of(mesh, middles[path.target]), low,
                                                 1.0 / rows),
                            1e-6)
                    << cell << ": from " << i << " to " << path.target;
        }
    }
}

/// Sources in corners and on edges, reach 0, no targets and no sources.
TEST(SurfacePaths, OfUncommonSources)
{
    const TriangleMesh mesh = bumpy(sphere_mesh(8), 0.2);
    const std::vector<MeshPosition> targets = positions_on(mesh, 40, 5);
    const std::vector<MeshPosition> sources{{30, {1, 0, 0}}, {31, {0.5, 0.5, 0}}, {32, {0, 0, 1}}};
    const auto there = paths_from(mesh, sources, targets, 20), back = paths_from(mesh, targets, sources, 20);
    for (std::size_t i = 0; i < sources.size(); ++i) {
        ASSERT_EQ(there[i].size(), targets.size());
        for (std::size_t t = 0; t < targets.size(); ++t) {
            ASSERT_EQ(back[t].size(), sources.size());
            EXPECT_NEAR(there[i][t].length, back[t][i].length, 1e-7);
        }
    }
    EXPECT_TRUE(paths_from(mesh, {}, targets, 1).empty());
    EXPECT_TRUE(paths_from(mesh, sources, {}, 1)[0].empty());
    EXPECT_EQ(paths_from(mesh, {targets[7]}, targets, 1e-7)[0].at(0).target, 7U);
}

}
}
