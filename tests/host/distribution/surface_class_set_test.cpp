// Points of several classes on meshes: their distances against all pairs, files with classes, and what is refused.
#include "host/distribution/surface_classes/surface_class_set.hpp"

#include "base/files/whole_file.hpp"
#include "host/distribution/surfaces/surface_files.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>
#include <string>

namespace poissonlab {
namespace {

SurfaceClassSettings classes_on(const TriangleMesh& mesh)
{
    SurfaceClassSettings settings;
    settings.read = std::make_shared<const SurfaceMesh>(SurfaceMesh{mesh, fixed_surface(mesh)});
    return settings;
}

SurfaceClassSet plain_set(const SurfaceClassSettings& settings, std::uint64_t seed = 1)
{
    return throw_surface_classes(settings, seed, {.engine = Engine::reference, .device = {}});
}

/// Nearest distances from all pairs, by doubles of places and normals.
SurfaceNearest nearest_by_pairs(const SurfaceClassSet& set, std::uint32_t one, std::uint32_t other)
{
    const FixedSurface& surface = set.surface();
    SurfaceNearest all{INFINITY, 0};
    std::size_t seen = 0;
    const PointSet places = points_of(surface, set.darts.points);
    const double cosine = std::cos(set.work.request.angle * std::numbers::pi / 180);
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (set.darts.classes[i] != one) continue;
        const MeshPoint a = normal_of(surface.triangles[set.darts.points[i].triangle]);
        double nearest = INFINITY;
        for (std::size_t j = 0; j < places.size(); ++j) {
            const MeshPoint b = normal_of(surface.triangles[set.darts.points[j].triangle]);
            if (j != i && set.darts.classes[j] == other && a[0] * b[0] + a[1] * b[1] + a[2] * b[2] >= cosine)
                nearest = std::min(nearest, std::hypot(places[i][0] - places[j][0], places[i][1] - places[j][1],
                                                       places[i][2] - places[j][2]));
        }
        if (!std::isfinite(nearest)) continue;
        all.least = std::min(all.least, nearest);
        all.mean += nearest;
        ++seen;
    }
    all.mean /= static_cast<double>(seen);
    return all;
}

TEST(SurfaceClassSets, AreMeasuredAsAllPairsAre)
{
    for (const TriangleMesh& mesh : {sphere_mesh(9), sheet_mesh(0.02)}) {
        SurfaceClassSettings settings = classes_on(mesh);
        settings.classes.points = {3, 30, 200};
        settings.classes.relative_radius = 0.5;
        const SurfaceClassSet set = plain_set(settings);
        EXPECT_EQ(set.darts.counts(), settings.classes.points);
        for (const SurfacePair& pair : pairs_of(set)) {
            const auto first = static_cast<std::uint32_t>(pair.first), second = static_cast<std::uint32_t>(pair.second);
            const SurfaceNearest expected = nearest_by_pairs(set, first, second),
                                 other = nearest_by_pairs(set, second, first);
            EXPECT_NEAR(pair.from_first.least, expected.least, 1e-12) << first << " and " << second;
            EXPECT_NEAR(pair.from_first.mean, expected.mean, 1e-12) << first << " and " << second;
            EXPECT_NEAR(pair.from_second.mean, other.mean, 1e-12) << first << " and " << second;
            EXPECT_GE(expected.least, set.kept().at(first, second) * (1 - 1e-12));
        }
    }
}

TEST(SurfaceClassSets, MeasureClassesOfFewPoints)
{
    const FixedSurface surface = fixed_surface(square_mesh());
    std::vector<std::vector<SurfacePoint>> by_class(3);
    SurfacePoint corner{};
    std::ranges::copy(place_on(surface.triangles[0], 0, 0), corner.place);
    by_class[1] = {corner};
    for (const SurfacePair& pair : surface_pairs(surface, by_class, least_cosine(180))) {
        EXPECT_TRUE(std::isinf(pair.from_first.least)); // no point sees another
        EXPECT_TRUE(std::isnan(pair.from_second.mean));
    }
}

TEST(SurfaceClassSets, WriteTheirClasses)
{
    const TemporaryFolder folder;
    SurfaceClassSettings settings = classes_on(sphere_mesh(9));
    settings.classes.points = {2, 20};
    const SurfaceClassSet set = plain_set(settings);
    const auto written = [&](const std::string& name) {
        write_surface_points(folder.path() / name, set.surface(), set.darts.points, set.darts.classes, "");
        return read_whole_file(folder.path() / name);
    };
    const std::string csv = written("a.csv");
    EXPECT_THAT(csv, testing::StartsWith("x,y,z,nx,ny,nz,class\n"));
    EXPECT_EQ(std::ranges::count(csv, '\n'), 23);
    EXPECT_THAT(written("a.ply"), testing::HasSubstr("property uint class\nend_header\n"));
    // A node, a mesh and two accessors for each class; the bytes of each view lie in the buffer one after the other.
    const std::string glb = written("a.glb");
    std::uint32_t length = 0;
    std::memcpy(&length, &glb[12], 4);
    const auto json = nlohmann::json::parse(glb.substr(20, length));
    ASSERT_EQ(json["nodes"].size(), 2U);
    EXPECT_EQ(json["scenes"][0]["nodes"], nlohmann::json({0, 1}));
    std::size_t begin = 0;
    for (std::size_t own = 0; own < 2; ++own) {
        EXPECT_EQ(json["nodes"][own]["name"], "class_" + std::to_string(own));
        const auto& attributes = json["meshes"][json["nodes"][own]["mesh"].get<std::size_t>()]["primitives"][0];
        for (const char* name : {"POSITION", "NORMAL"}) {
            const auto& accessor = json["accessors"][attributes["attributes"][name].get<std::size_t>()];
            EXPECT_EQ(accessor["count"], settings.classes.points[own]);
            const auto& view = json["bufferViews"][accessor["bufferView"].get<std::size_t>()];
            EXPECT_EQ(view.value("byteOffset", 0U), begin);
            EXPECT_EQ(view["byteLength"], 12 * settings.classes.points[own]);
            begin += 12 * settings.classes.points[own];
        }
    }
    EXPECT_EQ(json["buffers"][0]["byteLength"], begin);
    EXPECT_EQ(glb.size(), 20 + length + 8 + begin);
}

/// The densest packing of one point on a sphere has a distance larger than the diagonal of its box.
TEST(SurfaceClassSets, HaveDerivedDistancesThatFit)
{
    SurfaceClassSettings settings = classes_on(sphere_mesh(9));
    settings.classes.points = {1, 1};
    settings.classes.relative_radius = 1;
    settings.classes.factor = 0.9;
    EXPECT_EQ(plain_set(settings).darts.points.size(), 2U);
}

TEST(SurfaceClassSets, SayWhatIsWrong)
{
    const auto message = [](const std::vector<double>& distances, const std::vector<std::size_t>& points,
                            const std::vector<std::string>& densities = {}) {
        SurfaceClassSettings settings = classes_on(square_mesh());
        settings.classes.distances = distances;
        settings.classes.points = points;
        settings.classes.densities = densities;
        return message_of([&] { plain_set(settings); });
    };
    EXPECT_THAT(message({0.1, 2}, {}), testing::HasSubstr("2 is the distance of classes 1 and 1: must be from 1e-05"));
    EXPECT_THAT(message({0.1, 1e-6}, {}), testing::HasSubstr("the diagonal of the mesh's box"));
    EXPECT_THAT(message({0.2, 0.2}, {90, 9}), testing::HasSubstr("no further one fits; distances of about 0."));
    EXPECT_THAT(message({}, {9, 9}, {"x - 2", "1"}), testing::HasSubstr("x - 2: is -"));
    EXPECT_EQ(message({}, {9, 9}, {"1", "0*x"}), "0*x: is 0 everywhere on the mesh, or nearly");
    EXPECT_THAT(message({}, {9}, {"hue"}), testing::HasSubstr("numbers of the mesh's vertices: none"));
}

/// Two sides of a sheet do not see each other. One point of the upper side is among those of the lower one: it is found
/// from everywhere, unless so many points look for it that only those within sixteen mean distances do.
TEST(SurfaceClassSets, StopLookingWhereManyPointsSeeNone)
{
    const FixedSurface surface = fixed_surface(sheet_mesh(0.5));
    const auto on_triangle = [&](std::uint32_t triangle, std::uint32_t i) {
        SurfacePoint point{};
        point.triangle = triangle;
        point.shares[0] = (i * 2654435769U) >> 2;
        point.shares[1] = (i * 1013904223U) >> 2;
        std::ranges::copy(place_on(surface.triangles[triangle], point.shares[0], point.shares[1]), point.place);
        return point;
    };
    for (const std::uint32_t count : {300U, 36'000U}) { // 36,000 by 32,000 that are left are more than 10^9
        std::vector<SurfacePoint> from, to;
        for (std::uint32_t i = 0; i < count; ++i) {
            from.push_back(on_triangle(0, i));
            to.push_back(on_triangle(2, i));
        }
        to.push_back(on_triangle(0, 77));
        from.erase(from.begin() + 77);
        const double spacing = std::sqrt(surface.area / static_cast<double>(to.size()));
        double near = 0, all = 0, least = INFINITY;
        std::size_t seen = 0;
        for (const SurfacePoint& point : from) {
            const double distance =
                surface.unit * std::sqrt(static_cast<double>(squared_distance(place_of(point), place_of(to.back()))));
            all += distance;
            least = std::min(least, distance);
            if (distance > 16 * spacing) continue;
            near += distance;
            ++seen;
        }
        const SurfaceNearest found = surface_nearest(surface, from, to, least_cosine(90));
        EXPECT_NEAR(found.least, least, 1e-12);
        const bool stops = count > 1000;
        ASSERT_GT(seen, 100U);
        ASSERT_LT(seen, from.size() / 2 + (stops ? 0 : from.size()));
        EXPECT_NEAR(found.mean, stops ? near / static_cast<double>(seen) : all / static_cast<double>(from.size()),
                    1e-12);
    }
}

/// The first triangles of a fan, which lie in the plane, after `flat` ones without an area.
TriangleMesh fan_mesh(std::uint32_t triangles, std::uint32_t flat)
{
    TriangleMesh mesh;
    mesh.vertices = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {-2, 2, 0}, {1, 0, 0}};
    for (std::uint32_t i = 0; i < flat; ++i) mesh.triangles.push_back({0, 5, 1});
    for (std::uint32_t i = 0; i < triangles; ++i) mesh.triangles.push_back({0, i + 1, i + 2});
    return mesh;
}

/// One, two and three triangles, some beside others without an area; one, two and three points, and as many as fit.
TEST(SurfaceClassSets, AreMadeOnSmallMeshes)
{
    for (const std::uint32_t triangles : {1, 2, 3})
        for (const std::uint32_t flat : {0, 2})
            for (std::uint64_t seed = 1; seed <= 5; ++seed) {
                SurfaceClassSettings settings = classes_on(fan_mesh(triangles, flat));
                const double area = settings.read->surface.area;
                EXPECT_NEAR(area, 2 * triangles, 1e-6);
                for (const std::size_t count : {1, 2, 3}) {
                    settings.classes.points.assign(count, count);
                    settings.classes.relative_radius = 0.4;
                    EXPECT_EQ(plain_set(settings, seed).darts.counts(), settings.classes.points);
                }
                settings.classes.points.clear();
                settings.classes.distances = {0.5, 0.3};
                const SurfaceClassSet full = plain_set(settings, seed);
                EXPECT_EQ(full.darts.is_full, std::vector<bool>(2, true));
                EXPECT_LT(full.darts.small_area, 1e-6 * area);
                EXPECT_GT(full.darts.points.size(), 3 * triangles);
                pairs_of(full); // which throws where two points are too near
                for (const SurfacePoint& point : full.darts.points) EXPECT_GT(full.surface().areas[point.triangle], 0);
            }
}

/// Two squares at a distance are as two meshes: each has all classes, and is full of them. Both are open.
TEST(SurfaceClassSets, FillEachPartOfAMesh)
{
    TriangleMesh mesh = square_mesh();
    for (const MeshPoint& corner : square_mesh().vertices)
        mesh.vertices.push_back({corner[0] + 9, corner[1], corner[2]});
    for (const auto& [a, b, c] : square_mesh().triangles) mesh.triangles.push_back({a + 4, b + 4, c + 4});
    SurfaceClassSettings settings = classes_on(mesh);
    EXPECT_EQ(settings.read->surface.open_edges, 8U);
    settings.classes.distances = {0.2, 0.1};
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        const SurfaceClassSet set = plain_set(settings, seed);
        const PointSet places = points_of(set.surface(), set.darts.points);
        const ClassDistances kept = set.kept();
        for (const double left : {0, 9})
            for (std::uint32_t own = 0; own < 2; ++own)
                for (int i = 0; i < 41 * 41; ++i) {                           // no place has room
                    const double x = left + i % 41 / 40.0, y = i / 41 / 40.0; // NOLINT(bugprone-integer-division)
                    bool is_near = false;
                    for (std::size_t k = 0; k < places.size() && !is_near; ++k)
                        is_near = std::hypot(places[k][0] - x, places[k][1] - y) <
                                  kept.at(own, set.darts.classes[k]) * (1 + 1e-6);
                    ASSERT_TRUE(is_near) << x << ", " << y << " of class " << own;
                }
    }
}

}
}
