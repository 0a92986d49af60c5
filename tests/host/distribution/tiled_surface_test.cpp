// Tiles over texture coordinates: the points of a plane tiling where the surface is plane, distances on cylinders, the
// stretch of spheres, seams, and sets whose distance holds after points were left out.
#include "host/distribution/surfaces/tiled_surface.hpp"

#include "host/distribution/surfaces/laid_tiles.hpp"
#include "host/distribution/surfaces/surface_neighbours.hpp"
#include "host/distribution/surfaces/texture_seams.hpp"
#include "host/tile_points/tile_points.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/places.hpp"
#include "tiles/poisson/tile_set_file.hpp"

#include <tbb/global_control.h>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace poissonlab {
namespace {

using std::numbers::pi;
using testing::ElementsAre;

const DistributionPlace by_reference{.engine = Engine::reference, .device = {}};

const std::shared_ptr<const PoissonTileSet>& tiles_on_surfaces()
{
    static const auto tiles = std::make_shared<const PoissonTileSet>(
        read_tile_set(source_folder() + "/runtime/tile_sets/corner-c3-n64-r085.ptiles"));
    return tiles;
}

MeshPointSettings tiled(const TriangleMesh& mesh, double tiles_per_unit)
{
    MeshPointSettings settings;
    settings.method = SurfaceMethod::tiles;
    settings.tiles_per_unit = tiles_per_unit;
    settings.read_tiles = tiles_on_surfaces();
    settings.read = std::make_shared<const SurfaceMesh>(SurfaceMesh{mesh, fixed_surface(mesh)});
    return settings;
}

SurfaceSet tiled_set(const MeshPointSettings& settings, std::uint64_t seed = 1)
{
    return make_surface_set(settings, seed, by_reference);
}

double value_of(const SurfaceSet& set, const std::string& key)
{
    for (const DistributionNumber& number : surface_numbers(set, 1))
        if (number.key == key) return number.value;
    return NAN;
}

/// Returns the points of the plane's tiling that lie in a square from (0, 0) of this tile on, `tiles` wide, in parts of
/// its side. Points of tiles with chains lie outside of their tile.
std::vector<std::array<double, 2>> plane_points(std::uint32_t seed, std::array<std::int32_t, 2> lowest,
                                                std::uint32_t tiles)
{
    const TileBlock block{{lowest[0] - 1, lowest[1] - 1, 0}, {tiles + 2, tiles + 2, 1}};
    const auto units = reference::exact_tile_points(*tiles_on_surfaces(), {seed, 0}, block);
    const double side = tiles * 65536.0;
    std::vector<std::array<double, 2>> inside;
    for (std::size_t i = 0; i < units.size(); i += 2) {
        const double x = static_cast<std::int32_t>(units[i] - 65536),
                     y = static_cast<std::int32_t>(units[i + 1] - 65536);
        if (x >= 0 && y >= 0 && x < side && y < side) inside.push_back({x / side, y / side});
    }
    return inside;
}

TriangleMesh flat_square(std::uint32_t rows)
{
    return textured_mesh(rows, rows, [](double u, double v) { return MeshPoint{u, v, 0}; });
}

/// A cylinder around z whose texture coordinates keep lengths, but for its flat faces.
TriangleMesh cylinder(std::uint32_t columns)
{
    return textured_mesh(columns, 4, [](double u, double v) {
        return MeshPoint{std::cos(2 * pi * u) / (2 * pi), std::sin(2 * pi * u) / (2 * pi), v};
    });
}

double distance_between(const PointSet& places, std::size_t i, std::size_t j)
{
    return std::hypot(places[i][0] - places[j][0], places[i][1] - places[j][1], places[i][2] - places[j][2]);
}

TEST(TiledSurfaces, OfAPlaneAreTheTiling)
{
    for (const std::uint32_t rows : {1u, 4u, 8u}) {
        const PointSet places = tiled_set(tiled(flat_square(rows), 4), 7).places();
        const auto expected = plane_points(7, {0, 0}, 4);
        ASSERT_EQ(places.size(), expected.size());
        for (std::size_t i = 0; i < places.size(); ++i)
            ASSERT_THAT(std::vector(places[i].begin(), places[i].end()),
                        ElementsAre(expected[i][0], expected[i][1], 0));
        EXPECT_GT(places.size(), 1000U);
    }
}

TEST(TiledSurfaces, CanLieFarFrom0AndBeMirrored)
{
    TriangleMesh mesh = flat_square(4);
    for (TexturePoint& point : mesh.texture_points) point = {-300 - point[0], point[1] + 20};
    const PointSet places = tiled_set(tiled(mesh, 4), 3).places();
    // x = 1 is the left side of tile -1204.
    const auto expected = plane_points(3, {-1204, 80}, 4);
    ASSERT_EQ(places.size(), expected.size());
    for (std::size_t i = 0; i < places.size(); ++i)
        ASSERT_THAT(std::vector(places[i].begin(), places[i].end()),
                    ElementsAre(1 - expected[i][0], expected[i][1], 0));
}

/// Points on corners and edges of triangles, in all directions: none is lost, none comes twice.
TEST(TiledSurfaces, HaveEachPointOnOneTriangle)
{
    auto lattice = std::make_shared<PoissonTileSet>(*tiles_on_surfaces());
    for (std::size_t i = 0; i < lattice->points.size(); i += 2) {
        const auto in_tile = static_cast<std::uint32_t>(i / 2 % 64);
        lattice->points[i] = static_cast<std::uint16_t>(in_tile % 8 * 8192);
        lattice->points[i + 1] = static_cast<std::uint16_t>(in_tile / 8 * 8192);
    }
    lattice->parameters.border = TileBorder::strip;
    for (const bool is_turned : {false, true})
        for (const int mirror : {1, -1}) {
            TriangleMesh mesh = flat_square(16);
            for (TexturePoint& point : mesh.texture_points) {
                if (is_turned) point = {point[1], point[0]};
                point[0] = mirror == 1 ? point[0] : 1 - point[0];
            }
            MeshPointSettings settings = tiled(mesh, 2);
            settings.read_tiles = lattice;
            const SurfaceSet set = tiled_set(settings);
            EXPECT_EQ(set.points.size(), 4U * 64);
            EXPECT_THAT(set.notes, testing::IsEmpty());
            EXPECT_EQ(value_of(set, "least_distance"), 1.0 / 16);
        }
}

TEST(TiledSurfaces, KeepTheDistanceOfTheirTilesOnACylinder)
{
    const SurfaceSet set = tiled_set(tiled(cylinder(512), 5));
    const double proven = std::sqrt(static_cast<double>(tiles_on_surfaces()->squared_min_distance)) / 65536 / 5;
    EXPECT_DOUBLE_EQ(value_of(set, "tile_distance"), proven);
    // Arcs are longer than chords by the sixth of the squared half angle at most.
    const double chord = std::sin(pi * proven) / pi, rounding = 1 - std::pow(pi / 512, 2) / 6 - 1e-8;
    const PointSet places = set.places();
    double unrolled = INFINITY, through_space = INFINITY, across = INFINITY;
    for (std::size_t i = 0; i < places.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const auto along = [&](std::size_t k) { return std::atan2(places[k][1], places[k][0]) / (2 * pi); };
            const double a = along(i) - std::floor(along(i)), b = along(j) - std::floor(along(j));
            unrolled = std::min(unrolled, std::hypot(a - b, places[i][2] - places[j][2]));
            double& least = std::abs(a - b) > 0.5 ? across : through_space;
            least = std::min(least, distance_between(places, i, j));
        }
    EXPECT_GE(unrolled, proven * rounding);
    EXPECT_GE(through_space, chord * rounding);
    EXPECT_LT(across, 0.9 * chord); // the tiling does not close
    EXPECT_NEAR(value_of(set, "least_without_seams"), through_space, 1e-12);
    EXPECT_NEAR(value_of(set, "least_distance"), across, 1e-12);
    EXPECT_EQ(value_of(set, "charts"), 1);
    EXPECT_NEAR(value_of(set, "least_stretch"), 1, std::pow(pi / 512, 2));
    EXPECT_NEAR(value_of(set, "greatest_stretch"), 1, 1e-8);
    EXPECT_NEAR(value_of(set, "surface_distance"), proven, proven * std::pow(pi / 512, 2));
    EXPECT_GT(value_of(set, "broken_by_seams"), 0);
    EXPECT_LT(value_of(set, "broken_by_seams"), 0.1);
}

TEST(TiledSurfaces, CloseAcrossASeam)
{
    MeshPointSettings settings = tiled(cylinder(512), 5);
    settings.is_closed = true;
    const SurfaceSet set = tiled_set(settings);
    const double chord = std::sin(pi * value_of(set, "tile_distance")) / pi;
    EXPECT_GE(value_of(set, "least_distance"), chord * (1 - std::pow(pi / 512, 2) / 6 - 1e-8));
    EXPECT_EQ(value_of(set, "broken_by_seams"), 0);
}

TEST(TextureStretches, AreThoseOfSpheres)
{
    const auto measured = [](const auto& polar_of) {
        const TriangleMesh mesh = textured_mesh(200, 100, [&](double u, double v) {
            const double polar = polar_of(v);
            return MeshPoint{std::sin(polar) * std::cos(2 * pi * u), std::sin(polar) * std::sin(2 * pi * u),
                             -std::cos(polar)};
        });
        const FixedSurface surface = fixed_surface(mesh);
        const TexturePlane plane = texture_plane(mesh, surface, 1);
        return stretch_of_all(surface, plane, stretches_of(surface, plane));
    };
    // Flat triangles differ from the sphere by squares of their angles, in parts.
    const double rounding = std::pow(pi / 100, 2);
    const auto near = [&](double value) { return testing::DoubleNear(value, 2 * value * rounding); };
    // Angles, without a tenth at each pole: a unit of v is 0.8 pi long, one of u 2 pi times the sine of the polar
    // angle. The mean of the squared sine over that part of the sphere is 1 - c^2 / 3.
    const double c = std::cos(pi / 10), s = std::sin(pi / 10);
    const StretchOfAll angles = measured([](double v) { return pi * (0.1 + 0.8 * v); });
    EXPECT_THAT(angles.extremes.greatest, near(2 * pi));
    EXPECT_THAT(angles.extremes.least, near(2 * pi * s));
    EXPECT_THAT(angles.area_distortion, near(1 / s));
    const double mean_square = pi * pi * (0.32 + 2 * (1 - c * c / 3));
    EXPECT_THAT(angles.root_mean_square, near(std::sqrt(mean_square / (4 * pi * c))));
    // Archimedes: heights and angles keep areas. A unit of u is 2 pi sin t long, one of v 1.6 / sin t.
    const StretchOfAll heights = measured([](double v) { return std::acos(0.8 - 1.6 * v); });
    // Flat triangles are as wide as one of their two circles, whose radii differ most at the ends, by the slope times
    // 0.016.
    EXPECT_NEAR(heights.area_distortion, 1, 0.8 / 0.6 * 0.016 / 0.6);
    EXPECT_THAT(heights.extremes.greatest, near(2 * pi));
    EXPECT_THAT(heights.extremes.least, near(1.6));
}

TEST(TextureStretches, AreSingularValues)
{
    // Turned by 0.3, stretched by 5 and 0.01, turned by 1.1.
    const auto map = [](TexturePoint p) {
        const double x = 5 * (std::cos(0.3) * p[0] - std::sin(0.3) * p[1]);
        const double y = 0.01 * (std::sin(0.3) * p[0] + std::cos(0.3) * p[1]);
        return MeshPoint{2, std::cos(1.1) * x - std::sin(1.1) * y, std::sin(1.1) * x + std::cos(1.1) * y};
    };
    const std::array<TexturePoint, 3> texture{{{0.1, 0.2}, {0.9, 0.3}, {0.4, 0.8}}};
    // Coordinates are rounded to steps, of 2^-32 where there are 256 tiles a unit.
    TextureTriangle triangle;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < 2; ++k) triangle.corners[i][k] = std::llround(texture[i][k] * 0x1p32);
    const Stretch stretch = stretch_of({map(texture[0]), map(texture[1]), map(texture[2])}, triangle, 256);
    EXPECT_NEAR(stretch.greatest, 5, 5e-8);
    EXPECT_NEAR(stretch.least, 0.01, 1e-10);
}

/// A triangle's area in steps is not zero where that by doubles of its coordinates is.
TEST(TextureStretches, AreFiniteWhereTrianglesAreNearlyLines)
{
    TriangleMesh mesh = flat_square(2);
    mesh.texture_points.insert(mesh.texture_points.end(), {{0, 0}, {1, 2}, {0.001, 0.002}});
    const auto first = static_cast<std::uint32_t>(mesh.texture_points.size() - 3);
    mesh.texture_triangles[0] = {first, first + 1, first + 2};
    for (const double width : {11.0, 12.0, 7.3}) {
        const FixedSurface surface = fixed_surface(mesh);
        const TexturePlane plane = texture_plane(mesh, surface, width);
        const StretchOfAll all = stretch_of_all(surface, plane, stretches_of(surface, plane));
        EXPECT_GT(all.extremes.least, 0) << width;
        for (const double value : {all.extremes.greatest, all.area_distortion, all.root_mean_square})
            EXPECT_TRUE(std::isfinite(value)) << width;
    }
}

TEST(TiledSurfaces, KeepADistanceOnceOthersAreLeftOut)
{
    MeshPointSettings settings = tiled(cylinder(64), 4);
    const SurfaceSet all = tiled_set(settings, 5);
    const double distance = value_of(all, "least_without_seams") * 1.05;
    settings.min_distance = distance;
    const SurfaceSet set = tiled_set(settings, 5);
    EXPECT_GE(value_of(set, "least_distance"), distance * (1 - 1e-15));
    EXPECT_EQ(value_of(set, "laid_points"), static_cast<double>(all.points.size()));
    EXPECT_LT(set.points.size(), all.points.size());
    EXPECT_GT(set.points.size(), all.points.size() / 2);
}

TEST(KeptPoints, AreThoseOfALoopOverAllPairs)
{
    const SurfaceSet set = tiled_set(tiled(cylinder(64), 2));
    const FixedSurface& surface = set.mesh->surface;
    std::vector<std::uint32_t> order(set.points.size());
    for (std::uint32_t i = 0; i < order.size(); ++i)
        order[i] = static_cast<std::uint32_t>(i * 97 % order.size()); // 256 points
    constexpr double distance = 0.13;
    const auto kept = kept_in_order(surface, set.points, order, distance, least_cosine(180));
    const PointSet places = set.places();
    std::vector<std::uint32_t> expected;
    for (const std::uint32_t i : order) {
        const auto is_near = [&](std::uint32_t j) { return distance_between(places, i, j) < distance; };
        const bool stays = std::ranges::none_of(expected, is_near);
        if (stays) expected.push_back(i);
        EXPECT_EQ(kept[i], stays);
    }
    EXPECT_LT(expected.size(), order.size());
}

TEST(TiledSurfaces, SayWhereCoordinatesOverlapOrAreMissing)
{
    TriangleMesh mesh = flat_square(2);
    for (TexturePoint& point : mesh.texture_points) point[0] = std::abs(point[0] - 0.5); // folded
    const SurfaceSet folded = tiled_set(tiled(mesh, 4));
    EXPECT_THAT(folded.notes,
                ElementsAre(fmt::format("texture coordinates overlap: {} of {} points repeat others of the "
                                        "tiling on other faces",
                                        folded.points.size() / 2, folded.points.size())));
    for (const DistributionNumber& number : tiling_numbers(folded)) EXPECT_NE(number.key, "surface_distance");
    mesh = flat_square(2);
    mesh.texture_triangles[0][1] = no_texture_point;
    mesh.texture_triangles[1][1] = mesh.texture_triangles[1][0];
    EXPECT_THAT(tiled_set(tiled(mesh, 4)).notes,
                ElementsAre("1 of 8 faces have no texture coordinates, 1 no area in them: 25 % "
                            "of the surface has no points"));
    MeshPointSettings plain;
    plain.mesh = "plain.off";
    EXPECT_THAT(message_of([&] {
                    check_texture(plain, SurfaceMesh{square_mesh(), fixed_surface(square_mesh())});
                }),
                testing::StartsWith("plain.off: has no texture coordinates, over which tiles are laid"));
}

TEST(TiledSurfaces, HaveAsManyPointsAsAskedFor)
{
    MeshPointSettings settings = tiled(cylinder(64), 1);
    settings.tiles_per_unit.reset();
    settings.points = 1000;
    EXPECT_EQ(tiled_set(settings).points.size(), 1000U);
}

TEST(TiledSurfaces, AreTheSameByOneThread)
{
    const SurfaceSet many = tiled_set(tiled(cylinder(64), 6));
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_EQ(tiled_set(tiled(cylinder(64), 6)).places().coordinates, many.places().coordinates);
}

TEST(TextureCharts, HangTogetherByEdges)
{
    TriangleMesh mesh = flat_square(2);
    const auto count = [](const TriangleMesh& of) {
        const FixedSurface surface = fixed_surface(of);
        return charts_of(of, surface, texture_plane(of, surface, 1)).count;
    };
    EXPECT_EQ(count(mesh), 1U);
    // The lower half has its own coordinates.
    for (std::size_t t = 0; t < 4; ++t)
        for (std::uint32_t& corner : mesh.texture_triangles[t]) corner += 9;
    for (std::size_t i = 0; i < 9; ++i)
        mesh.texture_points.push_back({mesh.texture_points[i][0] + 3, mesh.texture_points[i][1]});
    EXPECT_EQ(count(mesh), 2U);
}

}
}
