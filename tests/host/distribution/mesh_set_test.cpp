// Measures of points on meshes are compared with those of the plane; some files are refused.
#include "host/distribution/surface_spectra/mesh_set.hpp"

#include "base/files/whole_file.hpp"
#include "base/points/point_file.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/temporary_folder.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace poissonlab {
namespace {

using testing::HasSubstr;

std::string off_text(const TriangleMesh& mesh)
{
    std::string text = fmt::format("OFF\n{} {} 0\n", mesh.vertices.size(), mesh.triangles.size());
    for (const MeshPoint& p : mesh.vertices) text += fmt::format("{} {} {}\n", p[0], p[1], p[2]);
    for (const MeshTriangle& t : mesh.triangles) text += fmt::format("3 {} {} {}\n", t[0], t[1], t[2]);
    return text;
}

/// A mesh and a set in files.
class MeshSets : public testing::Test
{
protected:
    MeshSetSettings settings_of(const TriangleMesh& mesh, const PointSet& points)
    {
        MeshSetSettings settings;
        settings.set = folder.path() / "points.csv";
        settings.mesh = folder.path() / "mesh.off";
        write_whole_file(settings.mesh, off_text(mesh));
        write_points(settings.set, points);
        return settings;
    }

    MeshSpectra measured(const TriangleMesh& mesh, const PointSet& points, std::uint32_t eigenfunctions = 1250)
    {
        MeshSetSettings settings = settings_of(mesh, points);
        settings.eigenfunctions = eigenfunctions;
        return measure_mesh_set(*read_mesh_set(settings), settings, 1, {});
    }

    TemporaryFolder folder;
};

PointSet darts_on(const TriangleMesh& mesh, std::size_t count, std::uint64_t seed)
{
    MeshPointSettings settings;
    settings.read = std::make_shared<const SurfaceMesh>(SurfaceMesh{mesh, fixed_surface(mesh)});
    settings.points = count;
    return make_surface_set(settings, seed, {.engine = Engine::reference, .device = {}}).places();
}

PointSet square_grid(std::size_t rows, double turn)
{
    PointSet grid{3, {}};
    const double side = 1 / static_cast<double>(rows);
    for (int i = -40; i <= 40; ++i)
        for (int j = -40; j <= 40; ++j) {
            const double u = i * side, v = j * side;
            const double x = 0.5 + u * std::cos(turn) - v * std::sin(turn),
                         y = 0.5 + u * std::sin(turn) + v * std::cos(turn);
            if (x >= 0 && x <= 1 && y >= 0 && y <= 1) grid.coordinates.insert(grid.coordinates.end(), {x, y, 0});
        }
    return grid;
}

/// The mesh is a torus, because darts are denser at the border of an open surface, which raises low frequencies.
TEST_F(MeshSets, OfDartsOnAClosedMeshAreAsThoseOfThePlane)
{
    const TriangleMesh mesh = textured_mesh(24, 16, [](double u, double v) {
        const double along = 2 * std::numbers::pi * u, around = 2 * std::numbers::pi * v;
        const double away = 1 + 0.4 * std::cos(around);
        return MeshPoint{away * std::cos(along), away * std::sin(along), 0.4 * std::sin(around)};
    });
    const MeshSpectra spectra = measured(mesh, darts_on(mesh, 200, 9));
    EXPECT_EQ(spectra.shape.open_edges, 0U);
    EXPECT_NEAR(spectra.reach, 1.4, 0.05);
    for (const MeshSetMeasures* set : {&spectra.set, &spectra.darts}) {
        // Saturated dart throwing on the torus (docs/glossary.md): 0.82, 0.06, 0.68. The power up to root N / 4 is the
        // mean of some 39 squares of deviates.
        EXPECT_NEAR(set->nearest_ratio, 0.82, 0.02);
        EXPECT_NEAR(*set->low_frequency_mean, 0.06, 0.06 * 4 * std::sqrt(2.0 / 39));
        // Rings are one wide, and the unit is that of root N / 2: the frequency is known to half a ring.
        EXPECT_NEAR(*set->effective_nyquist, 0.68, 0.5 / (std::sqrt(200.0) / 2));
        EXPECT_EQ(set->verdict.answer, "yes") << set->verdict.because;
    }
    EXPECT_EQ(spectra.random.verdict.answer, "no");
    EXPECT_NEAR(*spectra.random.low_frequency_mean, 1, 4 * std::sqrt(2.0 / 39));
    EXPECT_GT(spectra.random.counts.p_value, 1e-4);
}

/// Lloyd's method leaves less power at low frequencies than darts and has points farther apart.
TEST_F(MeshSets, AreComparedWithMethods)
{
    MeshSetSettings settings = settings_of(sphere_mesh(24), darts_on(sphere_mesh(24), 2, 1));
    settings.set.clear();
    settings.methods = {"lloyd", "elimination"};
    settings.eigenfunctions = 1250;
    MeshWithPoints read = *read_mesh_set(settings);
    EXPECT_TRUE(read.points.empty());
    read.points = points_by_method("lloyd", 200, read.surface, settings, 1);
    const MeshSpectra spectra = measure_mesh_set(read, settings, 1, {});
    ASSERT_EQ(spectra.methods.size(), 1U);
    EXPECT_EQ(spectra.methods[0].name, "elimination");
    EXPECT_LT(*spectra.set.low_frequency_mean, *spectra.darts.low_frequency_mean);
    EXPECT_EQ(spectra.set.verdict.answer, "yes") << spectra.set.verdict.because;
    EXPECT_GT(spectra.set.nearest_ratio, spectra.darts.nearest_ratio);
    // 40 sets of 200 points of the plane's Lloyd relaxation have 0.912, 0.0122 and 0.939 after 50 iterations. The power
    // is the mean of some 39 squares of deviates, and rings are one wide.
    EXPECT_NEAR(spectra.set.nearest_ratio, 0.912, 0.03);
    EXPECT_NEAR(*spectra.set.low_frequency_mean, 0.0122, 0.0122 * 4 * std::sqrt(2.0 / 39));
    EXPECT_NEAR(*spectra.set.effective_nyquist, 0.939, 0.5 / (std::sqrt(200.0) / 2));
    EXPECT_LT(*spectra.methods[0].set.low_frequency_mean, *spectra.random.low_frequency_mean);
}

TEST_F(MeshSets, OfATurnedLatticeHavePeaks)
{
    const MeshSpectra spectra = measured(square_mesh(4), square_grid(14, 0.3));
    EXPECT_GT(spectra.set.above_chance.value(), 0);
    EXPECT_NE(spectra.set.verdict.answer, "yes") << spectra.set.verdict.because;
}

TEST_F(MeshSets, WithTooFewEigenfunctionsAreNotJudged)
{
    const TriangleMesh mesh = square_mesh(8);
    const MeshSpectra spectra = measured(mesh, darts_on(mesh, 200, 9), 240);
    EXPECT_LT(spectra.reach, 1);
    EXPECT_EQ(spectra.set.verdict.answer, "unknown");
    EXPECT_FALSE(spectra.set.above_chance);
}

TEST_F(MeshSets, OfDartsOnlyOnHalfOfASphereAreUneven)
{
    PointSet half{3, {}};
    const PointSet all = darts_on(sphere_mesh(16), 300, 2);
    for (std::size_t i = 0; i < all.size(); ++i)
        if (all[i][2] > 0) half.coordinates.insert(half.coordinates.end(), all[i].begin(), all[i].end());
    const MeshSpectra spectra = measured(sphere_mesh(16), half);
    EXPECT_LT(spectra.set.counts.p_value, 1e-6);
    EXPECT_EQ(spectra.set.verdict.answer, "no") << spectra.set.verdict.because;
    EXPECT_EQ(spectra.darts.verdict.answer, "yes") << spectra.darts.verdict.because;
}

TEST_F(MeshSets, OfTwoAndThreePointsAreMeasured)
{
    for (const std::size_t count : {2u, 3u, 5u}) {
        PointSet points{3, {}};
        for (std::size_t i = 0; i < count; ++i)
            points.coordinates.insert(points.coordinates.end(),
                                      {(static_cast<double>(i) + 0.5) / static_cast<double>(count), 0.5, 0});
        const MeshSpectra spectra = measured(square_mesh(), points);
        EXPECT_NEAR(spectra.set.least, 1 / static_cast<double>(count), 0x1p-29) << "places on a grid of 2^-30";
        EXPECT_EQ(spectra.set.verdict.answer, "unknown");
    }
}

TEST_F(MeshSets, OnMeshesWhoseSquaredAreasAreNoDoublesAreRefused)
{
    for (const double side : {1e-61, 1e61}) {
        TriangleMesh mesh = square_mesh(2);
        for (MeshPoint& vertex : mesh.vertices)
            for (double& c : vertex) c *= side;
        const MeshSetSettings settings = settings_of(mesh, {3, {0, 0, 0, side / 2, 0, 0}});
        EXPECT_THAT(message_of([&] { read_mesh_set(settings); }), HasSubstr("must be from 1e-120 to 1e+120"));
    }
}

TEST_F(MeshSets, OffTheMeshAreRefused)
{
    const PointSet off{3, {0.5, 0.5, 0.001, 0.25, 0.5, 0.2, 0.75, 0.5, 0}};
    const auto refusal = [&](const PointSet& points) {
        return message_of([&] { read_mesh_set(settings_of(square_mesh(), points)); });
    };
    EXPECT_THAT(refusal(off),
                HasSubstr("1 of 3 points is farther off the mesh than the tolerance, 0.05774: the first is "
                          "point 2, (0.25, 0.5, 0.2), which is 0.2 off"));
    MeshSetSettings settings = settings_of(square_mesh(), off);
    settings.tolerance = 0.2;
    EXPECT_DOUBLE_EQ(read_mesh_set(settings)->farthest, 0.2);
    EXPECT_THAT(refusal({3, {0.5, 0.5, 0}}), HasSubstr("has one point"));
    EXPECT_THAT(refusal({2, {0.5, 0.5, 0.2, 0.1}}), HasSubstr("three coordinates"));
}

/// The classes of a file's column, and what files without one are told.
TEST_F(MeshSets, ReadTheClassesOfTheirPoints)
{
    MeshSetSettings settings = settings_of(square_mesh(), {3, {0.1, 0.1, 0, 0.9, 0.9, 0, 0.5, 0.2, 0}});
    write_whole_file(settings.set, "x,y,z,kind\n0.1,0.1,0,oak\n0.9,0.9,0,elm\n0.5,0.2,0,oak\n");
    settings.classes = "kind";
    const auto read = read_mesh_set(settings);
    EXPECT_EQ(read->classes.second, (std::vector<std::string>{"elm", "oak"}));
    EXPECT_EQ(read->classes.first, (std::vector<std::uint8_t>{1, 0, 1}));
    settings.classes = "genus";
    EXPECT_THAT(message_of([&] { read_mesh_set(settings); }), HasSubstr("genus: is not a column with classes"));
    write_whole_file(settings.set, "x,y,z,genus\n0.1,0.1,0,a\n0.9,0.9,0,a\n");
    EXPECT_THAT(message_of([&] { read_mesh_set(settings); }), HasSubstr("all points have the class a"));
}

}
}
