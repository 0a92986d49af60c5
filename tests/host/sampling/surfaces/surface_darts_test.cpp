// Darts on surfaces: kernels against their twin, distances of all pairs, where darts fall, saturation by places that
// would show a gap and by the density of random sequential addition, and the two sides of a sheet.
#include "host/sampling/surfaces/surface_darts.hpp"

#include "base/geometry/relative_radius.hpp"
#include "tests/support/chi_square.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/meshes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

namespace poissonlab {
namespace {

struct SurfaceCase
{
    std::string name;
    TriangleMesh mesh;
    double min_distance;
    std::size_t points = 0; ///< 0: to saturation
    double shrinking = 1;
    double angle = 120;
};

void PrintTo(const SurfaceCase& c, std::ostream* out) { *out << c.name; }

std::shared_ptr<const FixedSurface> fixed(const TriangleMesh& mesh)
{
    return std::make_shared<const FixedSurface>(fixed_surface(mesh));
}

SurfaceDartRequest request_of(const SurfaceCase& c, std::uint32_t realization = 0)
{
    return {.surface = fixed(c.mesh),
            .min_distance = c.min_distance,
            .angle = c.angle,
            .points = c.points,
            .shrinking = c.shrinking,
            .stream = stream_key(3, Purpose::surface_darts, realization)};
}

SurfaceDarts plain(const SurfaceDartRequest& request)
{
    return throw_surface_darts(request, *reference::surface_dart_engine(request), 1'000'000);
}

SurfaceDarts by_kernels(const SurfaceDartRequest& request, std::size_t group_size)
{
    return throw_surface_darts(request, *surface_dart_engine(request, Device::open(), group_size), 1'000'000);
}

bool are_same(const SurfaceDarts& a, const SurfaceDarts& b)
{
    return a.points.size() == b.points.size() && a.min_distance == b.min_distance && a.is_saturated == b.is_saturated &&
           a.small_area == b.small_area && a.darts == b.darts &&
           std::memcmp(a.points.data(), b.points.data(), a.points.size() * sizeof(SurfacePoint)) == 0;
}

/// The least distance of any two points that see each other, from all pairs, by doubles of their places and normals.
double least_of_pairs(const FixedSurface& surface, const std::vector<SurfacePoint>& points, double angle)
{
    const PointSet places = points_of(surface, points);
    double least = INFINITY;
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const MeshPoint a = normal_of(surface.triangles[points[i].triangle]);
            const MeshPoint b = normal_of(surface.triangles[points[j].triangle]);
            if (angle < 180 && a[0] * b[0] + a[1] * b[1] + a[2] * b[2] < std::cos(angle * std::numbers::pi / 180))
                continue;
            least = std::min(least, std::hypot(places[i][0] - places[j][0], places[i][1] - places[j][1],
                                               places[i][2] - places[j][2]));
        }
    return least;
}

class SurfaceDartSets : public testing::TestWithParam<SurfaceCase>
{
};

TEST_P(SurfaceDartSets, AreTheSameByKernels)
{
    const SurfaceDartRequest request = request_of(GetParam());
    const SurfaceDarts expected = plain(request);
    EXPECT_TRUE(are_same(by_kernels(request, 0), expected));
    EXPECT_TRUE(are_same(by_kernels(request, 16), expected));
    EXPECT_TRUE(are_same(by_kernels(request, 1), expected));
}

TEST_P(SurfaceDartSets, KeepTheirDistance)
{
    const SurfaceDartRequest request = request_of(GetParam());
    const SurfaceDarts set = plain(request);
    EXPECT_TRUE(request.points == 0 || set.points.size() == request.points);
    if (set.points.size() < 2) return;
    const double least = least_of_pairs(*request.surface, set.points, request.angle);
    EXPECT_GE(least, set.min_distance * (1 - 1e-15));
    EXPECT_TRUE(set.points.size() < 100 || least < set.min_distance * 1.1) << least;
}

// Oclgrind interprets these as well: see tests/CMakeLists.txt.
INSTANTIATE_TEST_SUITE_P(Small, SurfaceDartSets,
                         testing::Values(SurfaceCase{"square", square_mesh(), 0.5},
                                         SurfaceCase{"sheet", sheet_mesh(0.1), 0.7, 6, 0.8}));
INSTANTIATE_TEST_SUITE_P(Sizes, SurfaceDartSets,
                         testing::Values(SurfaceCase{"sphere, saturated", sphere_mesh(12), 0.2},
                                         SurfaceCase{"sphere, to a number", sphere_mesh(30), 0.1, 500},
                                         SurfaceCase{"sphere, shrinking", sphere_mesh(12), 0.17, 400, 0.97},
                                         SurfaceCase{"sphere, two points", sphere_mesh(6), 1.9},
                                         SurfaceCase{"square, saturated", square_mesh(3), 0.06},
                                         SurfaceCase{"sheet, saturated", sheet_mesh(0.01), 0.08},
                                         SurfaceCase{"sheet, all see each other", sheet_mesh(0.01), 0.08, 0, 1, 180}));

/// Uniform places on a surface.
std::vector<SurfacePoint> places_on(const FixedSurface& surface, std::size_t count)
{
    const std::vector<SurfacePiece> pieces = whole_pieces(surface);
    const SurfacePieceChoice choice = surface_piece_choice(surface, pieces);
    std::vector<SurfacePoint> places;
    for (std::size_t i = 0; i < count; ++i)
        places.push_back(
            reference::surface_dart(surface, pieces, choice, stream_key(9, Purpose::surface_coverage, 0), i));
    return places;
}

/// Returns how much farther than the distance the loneliest of these places is from all points that it sees.
double largest_gap(const SurfaceDartRequest& request, const SurfaceDarts& set, const std::vector<SurfacePoint>& places)
{
    const FixedSurface& surface = *request.surface;
    double largest = -INFINITY;
    for (const SurfacePoint& place : places) {
        double nearest = INFINITY;
        for (const SurfacePoint& point : set.points)
            if (cosine_between(surface.triangles[place.triangle], surface.triangles[point.triangle]) >=
                least_cosine(request.angle))
                nearest = std::min(nearest,
                                   std::sqrt(static_cast<double>(squared_distance(place_of(place), place_of(point)))));
        largest = std::max(largest, nearest * surface.unit - set.min_distance);
    }
    return largest;
}

TEST(SaturatedSurfaces, LeaveNoGap)
{
    for (const SurfaceCase& c :
         {SurfaceCase{"sphere", sphere_mesh(10), 0.25}, SurfaceCase{"sheet", sheet_mesh(0.05), 0.2},
          SurfaceCase{"square", square_mesh(), 0.1}}) {
        const SurfaceDartRequest request = request_of(c);
        SurfaceDarts set = plain(request);
        ASSERT_TRUE(set.is_saturated);
        EXPECT_EQ(set.small_area, 0);
        std::vector<SurfacePoint> places = places_on(*request.surface, 15'000);
        EXPECT_LT(largest_gap(request, set, places), 0) << c.name;
        // The measure sees the gap that a point leaves that is taken away, at least there.
        places.push_back(set.points.back());
        set.points.pop_back();
        EXPECT_GE(largest_gap(request, set, places), 0) << c.name;
    }
}

/// Disks of chord d on a sphere have the area pi d^2, as in the plane; packings differ by the order of (d / radius)^2.
TEST(SaturatedSurfaces, AreAsDenseAsRandomSequentialAddition)
{
    const std::shared_ptr<const FixedSurface> sphere = fixed(sphere_mesh(60));
    const double d = std::sqrt(saturated_count(sphere->area, 1) / 1500);
    double sum = 0, squares = 0;
    constexpr int sets = 8;
    for (int i = 0; i < sets; ++i) {
        SurfaceDartRequest request{.surface = sphere, .min_distance = d};
        request.stream = stream_key(4, Purpose::surface_darts, static_cast<std::uint32_t>(i));
        const auto count = static_cast<double>(by_kernels(request, 0).points.size());
        sum += count / sets;
        squares += count * count / sets;
    }
    const double error = std::sqrt((squares - sum * sum) / (sets - 1));
    EXPECT_LT(error, 10);
    EXPECT_NEAR(sum, 1500, 4 * error + 1500 * d * d);
}

TEST(SurfaceDarts, FallByAreas)
{
    // Triangles of very different areas: rows of a sphere from pole to pole.
    const FixedSurface surface = fixed_surface(sphere_mesh(8));
    const std::vector<SurfacePoint> places = places_on(surface, 200'000);
    std::vector<double> counts(surface.triangles.size());
    for (const SurfacePoint& place : places) ++counts[place.triangle];
    double statistic = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const double expected = surface.areas[i] / surface.area * 200'000;
        statistic += (counts[i] - expected) * (counts[i] - expected) / expected;
    }
    const double tail = test::chi_square_tail(statistic, static_cast<double>(counts.size() - 1));
    EXPECT_GT(tail, 1e-4);
    EXPECT_LT(tail, 1 - 1e-4);
}

TEST(SurfaceDarts, FallUniformlyIntoATriangle)
{
    TriangleMesh mesh;
    mesh.vertices = {{0, 0, 0}, {4, 0, 1}, {0, 3, 2}};
    mesh.triangles = {{0, 1, 2}};
    const FixedSurface surface = fixed_surface(mesh);
    // Each of 8 x 8 small triangles has the same area, and its number follows from shares.
    std::vector<std::uint64_t> counts(64);
    for (const SurfacePoint& place : places_on(surface, 100'000)) {
        const std::uint32_t a = place.shares[0] >> 28, b = place.shares[1] >> 28;
        const std::uint64_t rest = (place.shares[0] & 0xfffffffu) + std::uint64_t{place.shares[1] & 0xfffffffu};
        const std::uint32_t row = a + b, is_upper = rest >= (1u << 28) ? 1 : 0;
        // Row r of strips has 2 r + 1 triangles.
        const std::uint32_t strip = std::min(row + is_upper, 7u);
        ++counts[strip * strip + 2 * std::min(b, strip) + (is_upper != 0 ? 1 : 0)];
    }
    EXPECT_TRUE(test::are_equally_likely(counts, 1));
}

TEST(SurfaceSheets, HaveBothSidesUnlessAllPointsSeeEachOther)
{
    const auto counted = [](double thickness, double angle) {
        SurfaceCase c{"sheet", sheet_mesh(thickness), 0.05, 0, 1, angle};
        return static_cast<double>(plain(request_of(c)).points.size());
    };
    const double one_side = static_cast<double>(plain(request_of({"square", square_mesh(), 0.05})).points.size());
    // Numbers of saturated sets vary by some hundredth.
    EXPECT_NEAR(counted(0.001, 120), 2 * one_side, 0.08 * one_side);
    EXPECT_NEAR(counted(0.001, 180), one_side, 0.08 * one_side);
    EXPECT_NEAR(counted(1, 180), 2 * one_side, 0.08 * one_side);
}

TEST(SurfaceDarts, DoNotDependOnWhereAndHowLargeTheMeshIs)
{
    TriangleMesh moved = sphere_mesh(12);
    for (MeshPoint& v : moved.vertices)
        for (double& c : v) c = c * 1024 + 4096;
    const SurfaceDarts here = plain(request_of({"sphere", sphere_mesh(12), 0.2, 200}));
    const SurfaceDarts there = plain(request_of({"sphere", moved, 0.2 * 1024, 200}));
    ASSERT_EQ(here.points.size(), there.points.size());
    std::size_t same = 0;
    for (std::size_t i = 0; i < 200; ++i) same += here.points[i].triangle == there.points[i].triangle;
    EXPECT_EQ(same, 200U);
}

TEST(FixedSurfaces, RefuseWhatHasNoPlaces)
{
    TriangleMesh line = square_mesh();
    for (MeshPoint& v : line.vertices) v[1] = v[0];
    EXPECT_EQ(message_of([&] { fixed_surface(line); }), "the mesh has no area: its corners lie on lines");
    TriangleMesh far = square_mesh();
    for (MeshPoint& v : far.vertices) v[0] = 1e15 + v[0];
    EXPECT_THAT(message_of([&] { fixed_surface(far); }), testing::HasSubstr("move it nearer"));
    TriangleMesh dot = square_mesh();
    for (MeshPoint& v : dot.vertices) v = {1, 2, 3};
    EXPECT_THAT(message_of([&] { fixed_surface(dot); }), testing::HasSubstr("the mesh is 0 wide"));
    EXPECT_EQ(message_of([&] { fixed_surface({}); }), "the mesh has no triangles");
}

TEST(FixedSurfaces, KeepAreas)
{
    EXPECT_NEAR(fixed_surface(square_mesh(3)).area, 1, 1e-8);
    // A sphere of flat triangles has less than 4 pi, by some (pi / 60)^2 / 2.
    const double area = fixed_surface(sphere_mesh(60)).area;
    EXPECT_LT(area, 4 * std::numbers::pi);
    EXPECT_NEAR(area, 4 * std::numbers::pi, 4 * std::numbers::pi * 0.003);
    // Triangles without an area are left out.
    TriangleMesh flat = square_mesh();
    flat.triangles.push_back({0, 1, 1});
    EXPECT_EQ(fixed_surface(flat).flat, 1U);
    EXPECT_EQ(fixed_surface(flat).triangles.size(), 2U);
}

TEST(FixedSurfaces, CountEdgesWithATriangleOnOneSide)
{
    EXPECT_EQ(fixed_surface(square_mesh(1)).open_edges, 4U);
    EXPECT_EQ(fixed_surface(square_mesh(3)).open_edges, 12U);
    EXPECT_EQ(fixed_surface(sphere_mesh(6)).open_edges, 0U);
    EXPECT_EQ(fixed_surface(sheet_mesh(0.1)).open_edges, 8U);
    // Corners at one place count as one: halves of the square with corners of their own.
    TriangleMesh parts = square_mesh(1);
    parts.vertices.push_back(parts.vertices[parts.triangles[1][0]]);
    parts.triangles[1][0] = 4;
    EXPECT_EQ(fixed_surface(parts).open_edges, 4U);
}

}
}
