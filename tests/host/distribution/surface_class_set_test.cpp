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

}
}
