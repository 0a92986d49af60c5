// These tests measure textures, objects and points of tiles on surfaces of quads, and read their files again.
#include "host/distribution/surface_textures/surface_texture.hpp"
#include "host/distribution/surfaces/tiled_surface.hpp"

#include "base/surfaces/triangle_mesh.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/places.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace poissonlab {
namespace {

const std::filesystem::path source = source_folder(), meshes = source / "configs" / "surfaces";

double number_of(const std::vector<DistributionNumber>& numbers, const std::string& key)
{
    const auto at = std::ranges::find(numbers, key, &DistributionNumber::key);
    return at == numbers.end() ? NAN : at->value;
}

QuadSettings chair(std::uint32_t refine)
{
    QuadSettings quads{.mesh = meshes / "chair.obj", .refine = refine};
    quads.read = quad_surface(quads);
    return quads;
}

/// Returns the pixel of a quad that lies so far along a side, counterclockwise, and so deep.
std::vector<std::uint8_t> pixel_of(const QuadAtlas& atlas, QuadCorner side, int along, int depth)
{
    const auto place = turned_place((along + 0.5) / atlas.side, (depth + 0.5) / atlas.side, side.corner);
    const auto at = atlas.place_of(side.quad, place[0], place[1]);
    const auto first = atlas.color.values.begin() +
                       static_cast<std::ptrdiff_t>(atlas.color.at(static_cast<int>(at[0]), static_cast<int>(at[1]), 0));
    return {first, first + atlas.color.channels};
}

TEST(QuadSurfaces, ComeFromFacesCubesAndPolycubes)
{
    const auto genus = [](const QuadSettings& settings) { return 1 - quad_surface(settings)->topology.euler() / 2; };
    EXPECT_EQ(genus({.mesh = meshes / "chair.obj", .refine = 2}), 0);
    EXPECT_EQ(genus({.mesh = meshes / "two-rings.obj", .smooth = 1}), 2);
    EXPECT_EQ(genus({.mesh = meshes / "bumpy-sphere.off", .way = QuadWay::cube, .refine = 3}), 0);
    EXPECT_EQ(genus({.mesh = meshes / "ring.obj", .way = QuadWay::polycube, .polycube = meshes / "ring-on-cubes.obj"}),
              1);
}

TEST(QuadSurfaces, LieOnTheirMeshes)
{
    // Each vertex is on the sphere, up to what the triangles of the mesh are inside of it.
    const auto surface = quad_surface({.mesh = meshes / "bumpy-sphere.off", .way = QuadWay::cube, .refine = 4});
    for (const MeshPoint& p : surface->mesh.vertices) {
        const double r = std::hypot(p[0], p[1], p[2]);
        const double x = p[0] / r, y = p[1] / r, z = p[2] / r;
        const double waved = 1 + 0.18 * std::sin(4 * x + 1) * std::sin(5 * y) + 0.12 * std::cos(6 * z);
        EXPECT_NEAR(r, waved, 0.03);
    }
    // A polycube that is its own mesh is mapped to itself.
    const QuadSettings same{.mesh = meshes / "ring-on-cubes.obj",
                            .way = QuadWay::polycube,
                            .polycube = meshes / "ring-on-cubes.obj",
                            .refine = 3};
    for (const MeshPoint& p : quad_surface(same)->mesh.vertices)
        for (const double c : p) EXPECT_NEAR(3 * c, std::round(3 * c), 1e-9);
}

TEST(QuadSurfaces, AreRefusedWithALine)
{
    const auto refused = [](const QuadSettings& settings) {
        return message_of<InputError>([&] { quad_surface(settings); });
    };
    EXPECT_THAT(refused({.mesh = meshes / "bumpy-sphere.off"}), testing::HasSubstr("face 1 has 3 corners"));
    EXPECT_THAT(refused({.mesh = meshes / "vase.obj"}), testing::HasSubstr("a quad on one side only"));
    EXPECT_THAT(refused({.mesh = meshes / "torus.obj", .way = QuadWay::cube}), testing::HasSubstr("seen from behind"));
    EXPECT_THAT(refused({.mesh = meshes / "ring.obj", .way = QuadWay::polycube, .polycube = meshes / "chair.obj"}),
                testing::HasSubstr("both must have the same faces"));
    EXPECT_THAT(refused({.mesh = meshes / "ring.obj", .way = QuadWay::polycube, .polycube = meshes / "ring.obj"}),
                testing::HasSubstr("lies on no side of a cube"));
}

TEST(TexturedSurfaces, FitAcrossAllEdgesAndAreReadAgain)
{
    const TemporaryFolder folder;
    SurfaceTextureSettings settings;
    settings.quads = chair(3);
    settings.exemplar = source / "configs" / "exemplars" / "sand.png";
    settings.heights = settings.exemplar;
    settings.size = 16;
    settings.candidates = 1;
    const DressedSurface dressed = textured_surface(settings, 1, {});
    EXPECT_EQ(number_of(dressed.numbers, "mismatches"), 0);
    EXPECT_EQ(number_of(dressed.numbers, "euler"), 2);
    // A quad shows beyond a side, in its gutter, what the next quad shows there, whichever sides meet.
    const QuadTopology& topology = dressed.surface->topology;
    for (std::uint32_t q = 0; q < dressed.surface->mesh.quads.size(); ++q)
        for (std::uint32_t k = 0; k < 4; ++k)
            for (int t = dressed.atlas.gutter; t < settings.size - dressed.atlas.gutter; ++t)
                ASSERT_EQ(pixel_of(dressed.atlas, {q, k}, t, -1),
                          pixel_of(dressed.atlas, topology.across({q, k}), settings.size - 1 - t, 0));
    EXPECT_GT(number_of(dressed.numbers, "step_across"), 0);

    const auto file = folder.path() / "chair.glb";
    write_dressed(file, dressed, 0);
    const TriangleMesh read = read_triangle_mesh(file, MeshParts::faces_and_texture);
    EXPECT_EQ(read.triangles.size(), 4 * dressed.surface->mesh.quads.size());
    double area = 0; // of texture coordinates, in pixels of the atlas
    for (const auto& [a, b, c] : read.texture_triangles) {
        const auto &p = read.texture_points[a], &q = read.texture_points[b], &r = read.texture_points[c];
        area += std::abs((q[0] - p[0]) * (r[1] - p[1]) - (r[0] - p[0]) * (q[1] - p[1])) / 2;
    }
    const PngPixels& atlas = dressed.atlas.color;
    EXPECT_NEAR(area * atlas.width * atlas.height, 256.0 * static_cast<double>(dressed.surface->mesh.quads.size()), 1);
    EXPECT_FALSE(std::filesystem::exists(file.string() + ".png"));
}

TEST(TexturedSurfaces, ShowObjectsInDisksThatDoNotOverlap)
{
    SurfaceObjectSettings settings;
    settings.quads = chair(1);
    settings.points = 600;
    settings.texels = 48;
    const DressedSurface dressed = surface_of_objects(settings, 1, {});
    // Pixels of other colours than the background are those in disks.
    const QuadAtlas& atlas = dressed.atlas;
    std::size_t inside = 0, all = 0;
    for (std::uint32_t q = 0; q < dressed.surface->mesh.quads.size(); ++q)
        for (int y = 0; y < atlas.side; ++y)
            for (int x = 0; x < atlas.side; ++x, ++all) {
                const auto [left, top] = atlas.corner_of(q);
                const std::uint8_t* const at =
                    &atlas.color.values[atlas.color.at(left + atlas.gutter + x, top + atlas.gutter + y, 0)];
                inside += !(at[0] == 0xfd && at[1] == 0xf6 && at[2] == 0xe3);
            }
    const double share = number_of(dressed.numbers, "share_of_disks");
    EXPECT_GT(share, 0.4);
    // Pixels that a border crosses count as inside: 4 pixels wide around 2 pi r at most.
    const double radius = number_of(dressed.numbers, "disk_radius") * atlas.side;
    EXPECT_GE(static_cast<double>(inside) / static_cast<double>(all), share * 0.99);
    EXPECT_LE(static_cast<double>(inside) / static_cast<double>(all), share * (1 + 2 / radius) * (1 + 2 / radius));
}

/// Balls fill the share N 4/3 pi R^3 of space, and of a surface, wherever it lies, on average the same share: here of a
/// cube's six sides, which cut some 1,900 balls for each seed. The two-sided bound of five standard errors comes from
/// the seeds themselves.
TEST(TexturedSurfaces, AreCutOutOfASolid)
{
    SurfaceObjectSettings settings;
    settings.quads = chair(1);
    settings.dimension = 3;
    settings.tiles = source / "runtime" / "tile_sets" / "sphere-c2-n128-r075.ptiles";
    settings.points = 4000;
    settings.object = "inside";
    settings.texels = 24;
    std::vector<double> shares;
    double expected = 0;
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        const DressedSurface dressed = surface_of_objects(settings, seed, {.engine = Engine::reference, .device = {}});
        const QuadAtlas& atlas = dressed.atlas;
        double dark = 0, all = 0;
        for (std::uint32_t q = 0; q < dressed.surface->mesh.quads.size(); ++q)
            for (int i = 0; i < atlas.side * atlas.side; ++i, ++all) {
                const auto [left, top] = atlas.corner_of(q);
                dark += 1 - atlas.color.values[atlas.color.at(left + atlas.gutter + i % atlas.side,
                                                              top + atlas.gutter + i / atlas.side, 0)] /
                                255.0;
            }
        shares.push_back(dark / all);
        expected = number_of(dressed.numbers, "share_of_balls");
    }
    double mean = 0, squares = 0;
    for (const double share : shares) mean += share / 12;
    for (const double share : shares) squares += (share - mean) * (share - mean);
    const double error = std::sqrt(squares / 11 / 12);
    EXPECT_LT(error, 0.01);
    EXPECT_NEAR(mean, expected, 5 * error);
    const double radius = 0.75 / 2 * std::cbrt(std::sqrt(2.0) / 128); // by the file's name
    EXPECT_NEAR(expected, 128 * 4.0 / 3 * std::numbers::pi * std::pow(radius, 3), 0.02);
}

TEST(TiledQuads, KeepTheirDistanceAlongTheSurface)
{
    MeshPointSettings settings;
    settings.method = SurfaceMethod::quads;
    settings.quads = chair(2);
    settings.points = 2000;
    const SurfaceSet set = make_surface_set(settings, 1, {.engine = Engine::reference, .device = {}});
    const auto numbers = surface_numbers(set, 1);
    EXPECT_NEAR(static_cast<double>(set.points.size()), 2000, 200);
    const double distance = number_of(numbers, "surface_distance"), least = number_of(numbers, "least_distance");
    EXPECT_NEAR(distance, number_of(numbers, "tile_distance") / 2, 1e-9); // sides are 1/2, and nothing is stretched
    // All pairs are compared by brute force; two faces at a right angle are nearer through space by a factor of sqrt 2
    // at most.
    const PointSet places = set.places();
    double nearest = 10;
    for (std::size_t i = 0; i < places.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            nearest = std::min(nearest, std::hypot(places[i][0] - places[j][0], places[i][1] - places[j][1],
                                                   places[i][2] - places[j][2]));
    EXPECT_NEAR(number_of(numbers, "least_of_any"), nearest, 1e-9);
    EXPECT_GE(nearest, distance / std::numbers::sqrt2 - 1e-9);
    EXPECT_GE(least, nearest - 1e-9);
}

}
}
