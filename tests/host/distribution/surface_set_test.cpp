// Points on surfaces: what settings mean, what is measured, files that others read, and plane surfaces beside regions.
#include "host/distribution/surfaces/surface_set.hpp"

#include "base/files/whole_file.hpp"
#include "base/points/point_file.hpp"
#include "host/distribution/regions/nearest_in_plane.hpp"
#include "host/distribution/regions/region_darts.hpp"
#include "host/distribution/surfaces/surface_files.hpp"
#include "host/distribution/surfaces/surface_neighbours.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/temporary_folder.hpp"

#include <CGAL/IO/read_ply_points.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <numbers>
#include <span>
#include <sstream>

namespace poissonlab {
namespace {

const DistributionPlace on_reference{.engine = Engine::reference, .device = {}};

std::shared_ptr<const SurfaceMesh> mesh_of(const TriangleMesh& mesh)
{
    return std::make_shared<const SurfaceMesh>(SurfaceMesh{mesh, fixed_surface(mesh)});
}

MeshPointSettings settings_on(const TriangleMesh& mesh)
{
    MeshPointSettings settings;
    settings.read = mesh_of(mesh);
    return settings;
}

double number_in(const SurfaceSet& set, const std::string& key)
{
    for (const DistributionNumber& number : surface_numbers(set, 1))
        if (number.key == key) return number.value;
    return NAN;
}

TEST(SurfaceSets, HaveSoManyPointsAtADistanceThatShrinks)
{
    MeshPointSettings settings = settings_on(sphere_mesh(16));
    settings.points = 300;
    const SurfaceSet set = make_surface_set(settings, 1, on_reference);
    EXPECT_EQ(set.points.size(), 300U);
    EXPECT_GE(number_in(set, "least_distance"), set.min_distance * (1 - 1e-15));
    // Saturated sets have 0.777; the last distance is a hundredth below what fits.
    EXPECT_GT(number_in(set, "relative_radius"), 0.74);
    EXPECT_LT(number_in(set, "uncovered"), 0.02);
}

TEST(SurfaceSets, StopAtANumber)
{
    MeshPointSettings settings = settings_on(sphere_mesh(16));
    settings.points = 300;
    settings.relative_radius = 0.6;
    const SurfaceSet set = make_surface_set(settings, 1, on_reference);
    EXPECT_EQ(set.points.size(), 300U);
    EXPECT_GE(number_in(set, "relative_radius"), 0.6 * (1 - 1e-15));
    EXPECT_GT(number_in(set, "uncovered"), 0.02);
    settings.relative_radius = 0.9;
    EXPECT_THAT(message_of([&] { make_surface_set(settings, 1, on_reference); }),
                testing::MatchesRegex("the surface is saturated with 2[0-9]+ of 300 points: no further one fits; a "
                                      "relative radius of about 0\\.7[0-9]+ can be reached"));
}

TEST(SurfaceSets, SayHowSidesOfASheetAre)
{
    MeshPointSettings settings = settings_on(sheet_mesh(0.001));
    settings.min_distance = 0.08;
    const SurfaceSet set = make_surface_set(settings, 1, on_reference);
    EXPECT_GE(number_in(set, "least_distance"), 0.08 * (1 - 1e-15));
    EXPECT_LT(number_in(set, "least_of_any"), 0.08);
    EXPECT_EQ(number_in(set, "uncovered"), 0);
    settings.normal_angle = 180;
    EXPECT_TRUE(std::isnan(number_in(make_surface_set(settings, 1, on_reference), "least_of_any")));
}

/// Returns the least distance of points of two sets, over all pairs.
double least_between(const PointSet& a, const PointSet& b)
{
    double least = INFINITY;
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < b.size(); ++j)
            if (&a != &b || i != j)
                least = std::min(least, std::hypot(a[i][0] - b[j][0], a[i][1] - b[j][1], a[i][2] - b[j][2]));
    return least;
}

/// A coarse set is refined: its points stay, new ones keep the new distance from them, and no further one fits.
TEST(SurfaceSets, BeginWithGivenPoints)
{
    MeshPointSettings settings = settings_on(sphere_mesh(12));
    settings.normal_angle = 180;
    settings.min_distance = 0.4;
    const PointSet coarse = make_surface_set(settings, 1, on_reference).places();
    const TemporaryFolder folder;
    settings.start = folder.path() / "coarse.csv";
    write_points(settings.start, coarse);
    settings.min_distance = 0.2;
    const SurfaceSet set = make_surface_set(settings, 2, on_reference);
    const PointSet fine = set.places();
    EXPECT_TRUE(set.is_saturated);
    EXPECT_GT(fine.size(), 3 * coarse.size());
    EXPECT_TRUE(std::ranges::equal(coarse.coordinates, std::span(fine.coordinates).first(coarse.coordinates.size())));
    EXPECT_GE(least_between(fine, fine), 0.2 * (1 - 1e-15));
    settings.min_distance.reset();
    settings.points = 500;
    const SurfaceSet shrunk = make_surface_set(settings, 2, on_reference);
    EXPECT_EQ(shrunk.points.size(), 500U);
    EXPECT_EQ(shrunk.places()[0][0], coarse[0][0]);
    EXPECT_GT(number_in(shrunk, "relative_radius"), 0.65);
    settings.points = coarse.size();
    EXPECT_EQ(make_surface_set(settings, 2, on_reference).points.size(), coarse.size());
    settings.points = coarse.size() - 1;
    EXPECT_THAT(message_of([&] { make_surface_set(settings, 2, on_reference); }), testing::HasSubstr("the set is to"));
    settings.points.reset();
    settings.min_distance = 0.5;
    EXPECT_THAT(message_of([&] { make_surface_set(settings, 2, on_reference); }),
                testing::HasSubstr("nearer than the minimum distance, 0.5"));
}

/// A set is its own beginning: no point moves, so that all keep their distance. Sizes of 2^-300 and 2^300 are exact
/// multiples, whose squares of areas doubles do not have.
TEST(SurfaceSets, BeginWithTheirOwnPoints)
{
    const TemporaryFolder folder;
    for (const double size : {1.0, 0x1p-300, 0x1p300})
        for (const std::uint64_t seed : {1, 2, 3, 4}) {
            TriangleMesh mesh = seed % 2 == 0 ? sphere_mesh(7) : square_mesh(3, 0.3);
            for (MeshPoint& vertex : mesh.vertices)
                for (double& c : vertex) c *= size;
            MeshPointSettings settings = settings_on(mesh);
            settings.min_distance = 0.1 * size;
            const SurfaceSet set = make_surface_set(settings, seed, on_reference);
            settings.start = folder.path() / "own.csv";
            write_surface_points(settings.start, set.mesh->surface, set.points, "");
            const SurfaceSet again = make_surface_set(settings, seed, on_reference);
            EXPECT_EQ(again.places().coordinates, set.places().coordinates);
        }
}

/// Two near points of the start do not make the distance of all others small.
TEST(SurfaceSets, StayEvenWhereGivenPointsAreNear)
{
    MeshPointSettings settings = settings_on(square_mesh());
    settings.points = 500;
    const TemporaryFolder folder;
    settings.start = folder.path() / "pair.csv";
    write_points(settings.start, {3, {0.5, 0.5, 0, 0.5, 0.501, 0}});
    const SurfaceSet set = make_surface_set(settings, 1, on_reference);
    const PointSet places = set.places();
    ASSERT_EQ(places.size(), 500U);
    double least = INFINITY; // but for the pair
    for (std::size_t i = 2; i < places.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            least = std::min(least, std::hypot(places[i][0] - places[j][0], places[i][1] - places[j][1]));
    EXPECT_GT(least / std::sqrt(2 / std::sqrt(3.0) / 500), 0.74); // as without a start
    EXPECT_NEAR(set.min_distance, 0.001, 1e-8);
    EXPECT_LE(set.min_distance, number_in(set, "least_distance"));
    EXPECT_LT(number_in(set, "uncovered"), 0.02);
    EXPECT_THAT(set.notes, testing::ElementsAre(testing::MatchesRegex("two points of the start are 0.001 apart, nearer "
                                                                      "than the 0.0[34][0-9]+ that new points keep")));
}

/// Points of the start stay where they are, also beside obstacles; a note counts those that see an obstacle near.
TEST(SurfaceSets, SayWhereTheStartIsNearObstacles)
{
    MeshPointSettings settings = settings_on(square_mesh());
    settings.min_distance = 0.125;
    const TemporaryFolder folder;
    settings.start = folder.path() / "start.csv";
    settings.obstacles = folder.path() / "obstacles.csv";
    write_points(settings.start, {3, {0.25, 0.25, 0, 0.75, 0.75, 0, 0.75, 0.25, 0}});
    write_points(settings.obstacles, {3, {0.25, 0.375, 0}}); // exactly as far away as new points would be
    EXPECT_THAT(make_surface_set(settings, 1, on_reference).notes, testing::IsEmpty());
    write_points(settings.obstacles, {3, {0.25, 0.37, 0}});
    EXPECT_THAT(
        make_surface_set(settings, 1, on_reference).notes,
        testing::ElementsAre("a point of the start is nearer to an obstacle than the 0.125 that new points keep"));
    write_points(settings.obstacles, {3, {0.25, 0.25, 0, 0.75, 0.7, 0}});
    EXPECT_THAT(
        make_surface_set(settings, 1, on_reference).notes,
        testing::ElementsAre("2 points of the start are nearer to an obstacle than the 0.125 that new points keep"));
}

TEST(SurfaceSets, KeepAwayFromObstacles)
{
    MeshPointSettings settings = settings_on(sphere_mesh(12));
    settings.normal_angle = 180;
    const TemporaryFolder folder;
    settings.obstacles = folder.path() / "obstacles.csv";
    const PointSet obstacles{3, {0, 0, 1, 0, 0.03, 1, 0, 0, -1}}; // two of them are near each other
    write_points(settings.obstacles, obstacles);
    settings.min_distance = 0.3;
    const SurfaceSet set = make_surface_set(settings, 1, on_reference);
    EXPECT_TRUE(set.is_saturated);
    // The second one is sqrt(1 + 0.03^2) - 1 off the sphere, and the mesh of it lies some thousandths inside.
    EXPECT_THAT(set.notes, testing::ElementsAre(testing::HasSubstr("obstacles.csv: points were moved to the surface, "
                                                                   "by at most 0.0")));
    const PointSet places = set.places();
    EXPECT_GE(least_between(places, places), 0.3 * (1 - 1e-15));
    EXPECT_GE(least_between(places, obstacles), 0.3 - 0.01); // the second one is moved to the sphere
    const PointSet poles{3, {0, 0, 1, 0, 0, -1}};
    EXPECT_GE(least_between(places, poles), 0.3 * (1 - 1e-15) - 2 * set.mesh->surface.unit);
    settings.points = 5000;
    EXPECT_THAT(message_of([&] { make_surface_set(settings, 1, on_reference); }),
                testing::EndsWith("further one fits"));
    settings.points.reset();
    write_points(settings.obstacles, poles); // corners of the mesh
    EXPECT_THAT(make_surface_set(settings, 1, on_reference).notes, testing::IsEmpty());
    settings.obstacles.clear();
    settings.min_distance = 0.3;
    EXPECT_LT(least_between(make_surface_set(settings, 1, on_reference).places(), poles), 0.3);
    settings.obstacles = folder.path() / "obstacles.csv";
    write_points(settings.obstacles, {3, {0, 0, 1.2}});
    EXPECT_THAT(message_of([&] { make_surface_set(settings, 1, on_reference); }),
                testing::HasSubstr("1 of 1 points is farther off the mesh than the tolerance, 0.03"));
}

/// Reordering keeps all points, and the points of its first parts keep half of the distance of a densest packing.
TEST(SurfaceSets, AreOrderedByElimination)
{
    MeshPointSettings settings = settings_on(sphere_mesh(12));
    settings.normal_angle = 180;
    settings.min_distance = 0.1;
    PointSet own = make_surface_set(settings, 1, on_reference).places();
    settings.order = SurfaceOrder::elimination;
    PointSet ordered = make_surface_set(settings, 1, on_reference).places();
    const auto sorted = [](const PointSet& set) {
        std::vector<std::array<double, 3>> all;
        for (std::size_t i = 0; i < set.size(); ++i) all.push_back({set[i][0], set[i][1], set[i][2]});
        std::ranges::sort(all);
        return all;
    };
    EXPECT_EQ(sorted(own), sorted(ordered));
    for (const std::size_t part : {4, 16}) {
        const PointSet first{3,
                             {ordered.coordinates.begin(),
                              ordered.coordinates.begin() + static_cast<std::ptrdiff_t>(own.size() / part * 3)}};
        const double packed = std::sqrt(8 * std::numbers::pi / (std::sqrt(3.0) * static_cast<double>(first.size())));
        EXPECT_GT(least_between(first, first), 0.5 * packed);
    }
}

TEST(SurfaceSets, RefuseDistancesWithoutRoom)
{
    const MeshPointSettings settings = settings_on(square_mesh());
    const auto refusal = [&](double min_distance) {
        MeshPointSettings asked = settings;
        asked.min_distance = min_distance;
        return message_of([&] { surface_distance(asked, *asked.read); });
    };
    EXPECT_THAT(refusal(2), testing::HasSubstr("there is room for one point"));
    EXPECT_THAT(refusal(1e-6), testing::HasSubstr("at least 1e-05"));
    EXPECT_THAT(refusal(2e-5),
                testing::HasSubstr("there would be some 1.74e+09 points; at most 134217728 are possible"));
    MeshPointSettings along = settings; // paths may be longer than the box is wide
    along.metric = SurfaceMetric::surface;
    along.min_distance = 1.9;
    EXPECT_EQ(surface_distance(along, *along.read), 1.9);
    along.min_distance = 9;
    EXPECT_THAT(message_of([&] { surface_distance(along, *along.read); }),
                testing::HasSubstr("9 is more than can be measured along this mesh"));
}

TEST(SurfaceNeighbourhoods, AreThoseOfAllPairs)
{
    MeshPointSettings settings = settings_on(sheet_mesh(0.05));
    settings.points = 150;
    settings.relative_radius = 0.3;
    const SurfaceSet set = make_surface_set(settings, 2, on_reference);
    const PointSet places = set.places();
    double any = INFINITY, seen = INFINITY, sum = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        double nearest = INFINITY;
        for (std::size_t j = 0; j < places.size(); ++j) {
            if (i == j) continue;
            const double d =
                std::hypot(places[i][0] - places[j][0], places[i][1] - places[j][1], places[i][2] - places[j][2]);
            any = std::min(any, d);
            if (places[i][2] == places[j][2]) nearest = std::min(nearest, d); // on the same side
        }
        seen = std::min(seen, nearest);
        sum += nearest;
    }
    const SurfaceDistances found =
        surface_distances(set.mesh->surface, set.points, least_cosine(set.angle), set.mesh->surface.area);
    EXPECT_NEAR(found.least, seen, 1e-15);
    EXPECT_NEAR(found.least_of_any, any, 1e-15);
    EXPECT_NEAR(found.mean_nearest, sum / 150, 1e-14);
}

/// Numbers of saturated sets, and mean distances of nearest points, are those of darts in a square of the plane.
TEST(PlaneSurfaces, HaveTheStatisticsOfRegions)
{
    constexpr int sets = 12;
    std::array<double, 2> counts{}, squares{}, nearest{}, nearest_squares{};
    for (std::uint64_t seed = 0; seed < sets; ++seed) {
        MeshPointSettings on_mesh = settings_on(square_mesh(2));
        on_mesh.min_distance = 0.05;
        DartSettings in_region;
        in_region.region = "rectangle 0 0 1 1";
        in_region.min_distance = 0.05;
        const SurfaceSet a = make_surface_set(on_mesh, seed, on_reference);
        const RegionDarts b = throw_region_darts(in_region, seed, on_reference);
        const double count[2] = {double(a.points.size()), double(b.points.size())};
        const double mean[2] = {
            surface_distances(a.mesh->surface, a.points, least_cosine(180), a.mesh->surface.area).mean_nearest,
            nearest_distances(b.points).mean};
        for (std::size_t i = 0; i < 2; ++i) {
            counts[i] += count[i] / sets;
            squares[i] += count[i] * count[i] / sets;
            nearest[i] += mean[i] / sets;
            nearest_squares[i] += mean[i] * mean[i] / sets;
        }
    }
    const auto error = [](const auto& sums, const auto& of_squares) {
        double squared = 0;
        for (std::size_t i = 0; i < 2; ++i) squared += (of_squares[i] - sums[i] * sums[i]) / (sets - 1);
        return std::sqrt(squared);
    };
    EXPECT_LT(error(counts, squares), 4);
    EXPECT_NEAR(counts[0], counts[1], 4 * error(counts, squares));
    EXPECT_LT(error(nearest, nearest_squares), 3e-4);
    EXPECT_NEAR(nearest[0], nearest[1], 4 * error(nearest, nearest_squares));
}

TEST(SurfaceFiles, AreReadByCgal)
{
    using Kernel = CGAL::Simple_cartesian<double>;
    MeshPointSettings settings = settings_on(sphere_mesh(8));
    settings.points = 50;
    settings.relative_radius = 0.5;
    const SurfaceSet set = make_surface_set(settings, 1, on_reference);
    const TemporaryFolder folder;
    const std::filesystem::path file = folder.path() / "points.ply";
    write_surface_points(file, set.mesh->surface, set.points, "words");
    EXPECT_THAT(read_whole_file(file), testing::StartsWith("ply\nformat binary_little_endian 1.0\ncomment words\n"));
    using Oriented = std::pair<Kernel::Point_3, Kernel::Vector_3>;
    std::vector<Oriented> read;
    ASSERT_TRUE(CGAL::IO::read_PLY(file.string(), std::back_inserter(read),
                                   CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Oriented>())
                                       .normal_map(CGAL::Second_of_pair_property_map<Oriented>())));
    const PointSet places = set.places();
    ASSERT_EQ(read.size(), 50U);
    for (std::size_t i = 0; i < 50; ++i) {
        const auto& [point, normal] = read[i];
        EXPECT_EQ((std::array{point.x(), point.y(), point.z()}),
                  (std::array{places[i][0], places[i][1], places[i][2]}));
        EXPECT_NEAR(normal.squared_length(), 1, 1e-6);
        // Normals of a sphere point away from its middle, but for the slopes of flat triangles.
        EXPECT_GT(normal * (point - CGAL::ORIGIN), 0.9);
    }
}

/// The columns of normals are those of the triangles' slopes, and other readers find x, y and z by their names.
TEST(SurfaceFiles, HaveNormalsInTables)
{
    MeshPointSettings settings = settings_on(sphere_mesh(8));
    settings.points = 50;
    settings.relative_radius = 0.5;
    const SurfaceSet set = make_surface_set(settings, 1, on_reference);
    const TemporaryFolder folder;
    const std::filesystem::path file = folder.path() / "points.csv";
    write_surface_points(file, set.mesh->surface, set.points, "");
    EXPECT_EQ(read_points(file, any_coordinates).at(0), set.places());
    std::istringstream lines(read_whole_file(file));
    std::string line;
    std::getline(lines, line);
    EXPECT_EQ(line, "x,y,z,nx,ny,nz");
    for (std::size_t i = 0; i < 50; ++i) {
        std::array<double, 6> row{};
        char comma = 0;
        for (std::size_t k = 0; k < 6; ++k) (k > 0 ? lines >> comma : lines) >> row[k];
        EXPECT_NEAR(std::hypot(row[3], row[4], row[5]), 1, 1e-12);
        EXPECT_GT(row[0] * row[3] + row[1] * row[4] + row[2] * row[5], 0.9); // away from the middle of the sphere
    }
}

/// The file is read by the rules of glTF 2.0, sections 3.6 and 4.4: accessors lead to views of the one buffer.
TEST(SurfaceFiles, HavePointsAndNormalsInGltf)
{
    MeshPointSettings settings = settings_on(sphere_mesh(8));
    settings.points = 49; // its text has no whole number of words by chance alone
    settings.relative_radius = 0.5;
    const SurfaceSet set = make_surface_set(settings, 1, on_reference);
    const TemporaryFolder folder;
    const std::filesystem::path file = folder.path() / "points.glb";
    write_surface_points(file, set.mesh->surface, set.points, "");
    const std::string bytes = read_whole_file(file);
    const auto word = [&](std::size_t at) {
        std::uint32_t value = 0;
        std::memcpy(&value, &bytes.at(at), 4);
        return value;
    };
    ASSERT_EQ(bytes.substr(0, 4), "glTF");
    EXPECT_EQ(word(4), 2U);
    EXPECT_EQ(word(8), bytes.size());
    const std::uint32_t length = word(12);
    EXPECT_EQ(length % 4, 0U);
    EXPECT_EQ(bytes.substr(16, 4), "JSON");
    const auto json = nlohmann::json::parse(bytes.substr(20, length));
    EXPECT_EQ(word(20 + length), json["buffers"][0]["byteLength"]);
    EXPECT_EQ(bytes.substr(24 + length, 4), std::string("BIN\0", 4));
    const auto& primitive = json["meshes"][0]["primitives"][0];
    EXPECT_EQ(primitive["mode"], 0);
    const auto floats = [&](const char* name) {
        const auto& accessor = json["accessors"][primitive["attributes"][name].get<std::size_t>()];
        EXPECT_EQ(accessor["componentType"], 5126);
        EXPECT_EQ(accessor["type"], "VEC3");
        EXPECT_EQ(accessor["count"], 49);
        const auto& view = json["bufferViews"][accessor["bufferView"].get<std::size_t>()];
        EXPECT_EQ(view["byteLength"], 49 * 12);
        std::vector<float> values(49 * 3);
        const std::size_t begin = 28 + length + view.value("byteOffset", std::size_t{0});
        EXPECT_LE(begin + 49 * 12, bytes.size());
        std::memcpy(values.data(), bytes.data() + begin, 49 * 12);
        return values;
    };
    const std::vector<float> places = floats("POSITION"), normals = floats("NORMAL");
    const auto& bounds = json["accessors"][primitive["attributes"]["POSITION"].get<std::size_t>()];
    const PointSet expected = set.places();
    for (std::size_t i = 0; i < 49; ++i)
        for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(places[3 * i + k], static_cast<float>(expected[i][k]));
    for (std::size_t k = 0; k < 3; ++k) {
        std::vector<float> along;
        for (std::size_t i = 0; i < 49; ++i) along.push_back(places[3 * i + k]);
        EXPECT_EQ(bounds["min"][k].get<float>(), std::ranges::min(along));
        EXPECT_EQ(bounds["max"][k].get<float>(), std::ranges::max(along));
    }
    for (std::size_t i = 0; i < 147; i += 3) {
        EXPECT_NEAR(std::hypot(normals[i], normals[i + 1], normals[i + 2]), 1, 1e-6);
        EXPECT_GT(normals[i] * places[i] + normals[i + 1] * places[i + 1] + normals[i + 2] * places[i + 2], 0.9);
    }
}

TEST(SurfaceViews, ShowDotsOnTheNearSide)
{
    const SurfaceMesh mesh{sphere_mesh(8), fixed_surface(sphere_mesh(8))};
    const auto dark = [&](const MeshPoint& at) {
        // The point whose place is nearest to a direction: the triangle is that of the nearest middle.
        SurfacePoint point{};
        double best = -1;
        for (std::uint32_t t = 0; t < mesh.surface.triangles.size(); ++t) {
            const MeshPoint n = normal_of(mesh.surface.triangles[t]);
            const double along = n[0] * at[0] + n[1] * at[1] + n[2] * at[2];
            if (along <= best) continue;
            best = along;
            const auto place = place_on(mesh.surface.triangles[t], 715'827'882, 715'827'882);
            point = {.place = {int(place[0]), int(place[1]), int(place[2])},
                     .triangle = t,
                     .shares = {},
                     .next = 0,
                     .number = 0};
        }
        const PngPixels view = surface_view(mesh.surface, {point}, {0.5, true}, 800);
        std::array<int, 2> counts{};
        for (int row = 0; row < view.height; ++row)
            for (int column = 0; column < 800; ++column)
                counts[column / 400] += view.values[view.at(column, row, 0)] < 60;
        return counts;
    };
    // The first view is from -y above, the second one from +y above.
    EXPECT_GT(dark({-0.4, -0.8, 0.4})[0], 10);
    EXPECT_EQ(dark({-0.4, -0.8, 0.4})[1], 0);
    EXPECT_GT(dark({0.4, 0.8, 0.4})[1], 10);
    EXPECT_EQ(dark({0.4, 0.8, 0.4})[0], 0);
    EXPECT_GT(dark({0, 0, 1})[0], 10);
    EXPECT_GT(dark({0, 0, 1})[1], 10);
}

}
}
