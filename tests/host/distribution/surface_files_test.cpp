// Files of points on surfaces have columns of faces, barycentric coordinates, and numbers of vertices.
#include "host/distribution/surfaces/surface_files.hpp"

#include "base/files/whole_file.hpp"
#include "host/distribution/surfaces/surface_set.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <sstream>

namespace poissonlab {
namespace {

using ColumnsByName = std::map<std::string, std::vector<double>>;

ColumnsByName columns_of_csv(const std::string& text)
{
    std::istringstream lines(text);
    std::string line, word;
    std::getline(lines, line);
    std::vector<std::string> names;
    for (std::istringstream head(line); std::getline(head, word, ',');) names.push_back(word);
    ColumnsByName columns;
    while (std::getline(lines, line)) {
        std::istringstream row(line);
        for (const std::string& name : names) {
            std::getline(row, word, ',');
            columns[name].push_back(std::stod(word));
        }
    }
    return columns;
}

SurfaceSet set_on(const TriangleMesh& mesh, std::size_t points, SurfaceMethod method)
{
    MeshPointSettings settings;
    settings.read = std::make_shared<const SurfaceMesh>(SurfaceMesh{mesh, fixed_surface(mesh)});
    settings.points = points;
    settings.method = method;
    return make_surface_set(settings, 1, {.engine = Engine::reference, .device = {}});
}

class SurfaceColumns : public testing::TestWithParam<SurfaceMethod>
{
};

/// Corners are rounded to half a unit of the grid, and places to half a unit: barycentric coordinates reproduce places
/// to a unit along each axis, but for the rounding of doubles.
TEST_P(SurfaceColumns, ReproducePlacesAndLinearFunctions)
{
    for (const std::size_t points : {1, 2, 3, 200}) {
        TriangleMesh mesh = sphere_mesh(9);
        for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) mesh.faces.push_back(2 * i);
        mesh.columns = {{"height", "x"}, {false, false}, {}};
        for (const MeshPoint& v : mesh.vertices) {
            mesh.columns.values.push_back(v[0] - 2 * v[1] + 3 * v[2]);
            mesh.columns.values.push_back(7);
        }
        mesh.normals = mesh.vertices;
        mesh.normal_triangles = mesh.triangles;
        const SurfaceSet set = set_on(mesh, points, GetParam());
        const TemporaryFolder folder;
        const std::filesystem::path file = folder.path() / "points.csv";
        write_surface_points(file, set.mesh->surface, set.points, "", &mesh);
        const ColumnsByName columns = columns_of_csv(read_whole_file(file));
        const double tolerance = set.mesh->surface.unit + 8 * 0x1p-53;
        ASSERT_EQ(columns.at("face").size(), points);
        for (std::size_t i = 0; i < points; ++i) {
            const auto at = [&](const std::string& name) { return columns.at(name)[i]; };
            MeshPoint sum{};
            double shares = 0;
            for (const char* k : {"0", "1", "2"}) {
                const double share = at(std::string("bary_") + k);
                const MeshPoint& v = mesh.vertices[static_cast<std::size_t>(at(std::string("vertex_") + k))];
                for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += share * v[axis];
                EXPECT_GE(share, 0);
                shares += share;
            }
            EXPECT_EQ(shares, 1);
            EXPECT_NEAR(sum[0], at("x"), tolerance);
            EXPECT_NEAR(sum[1], at("y"), tolerance);
            EXPECT_NEAR(sum[2], at("z"), tolerance);
            EXPECT_NEAR(at("height"), at("x") - 2 * at("y") + 3 * at("z"), 6 * tolerance + 32 * 0x1p-53);
            EXPECT_NEAR(at("mesh_x"), 7, 3 * 7 * 0x1p-53);
            // The normals of vertices are their places, so that those between them have the points' directions.
            const double length = std::hypot(at("x"), at("y"), at("z"));
            EXPECT_NEAR(at("shading_nx"), at("x") / length, 4 * tolerance);
            EXPECT_NEAR(at("shading_nz"), at("z") / length, 4 * tolerance);
            const MeshTriangle& t = mesh.triangles[static_cast<std::size_t>(at("face")) / 2];
            EXPECT_EQ(t[0], at("vertex_0"));
            EXPECT_EQ(t[2], at("vertex_2"));
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Methods, SurfaceColumns, testing::Values(SurfaceMethod::darts, SurfaceMethod::elimination));

/// Texture coordinates that a corner lacks are NaN in all of its triangle; bytes stay bytes.
TEST(SurfaceColumnFiles, SayWhatIsNotThere)
{
    TriangleMesh mesh = square_mesh();
    mesh.faces = {0, 0};
    mesh.texture_points = {{0, 0}, {1, 0}, {1, 1}};
    mesh.texture_triangles = {{0, 1, 2}, {0, 2, no_texture_point}};
    mesh.columns = {{"red"}, {true}, {0, 255, 0, 255}};
    const SurfaceSet set = set_on(mesh, 40, SurfaceMethod::darts);
    const TemporaryFolder folder;
    write_surface_points(folder.path() / "a.csv", set.mesh->surface, set.points, "", &mesh);
    const ColumnsByName columns = columns_of_csv(read_whole_file(folder.path() / "a.csv"));
    const double tolerance = set.mesh->surface.unit + 8 * 0x1p-53;
    int missing = 0;
    for (std::size_t i = 0; i < 40; ++i) {
        const double x = columns.at("x")[i], y = columns.at("y")[i];
        EXPECT_NEAR(columns.at("red")[i], 255 * x, 256 * tolerance);
        if (y > x) {
            EXPECT_TRUE(std::isnan(columns.at("u")[i]));
            ++missing;
        } else {
            EXPECT_NEAR(columns.at("u")[i], x, tolerance);
            EXPECT_NEAR(columns.at("v")[i], y, tolerance);
        }
    }
    EXPECT_GT(missing, 5);
    EXPECT_LT(missing, 35);
    // Normals that cancel out, or are not finite numbers, have no direction.
    mesh.normal_triangles = {{0, 0, 0}, {1, 1, 1}};
    for (const MeshPoint& second : {MeshPoint{0, 0, 0}, {0, NAN, 1}, {0, INFINITY, 1}}) {
        mesh.normals = {{0, 3, 4}, second};
        write_surface_points(folder.path() / "b.csv", set.mesh->surface, set.points, "", &mesh);
        const ColumnsByName shaded = columns_of_csv(read_whole_file(folder.path() / "b.csv"));
        for (std::size_t i = 0; i < 40; ++i)
            for (std::size_t k = 0; k < 3; ++k) {
                const double c = shaded.at(std::array{"shading_nx", "shading_ny", "shading_nz"}[k])[i];
                if (std::isnan(columns.at("u")[i]))
                    EXPECT_TRUE(std::isnan(c));
                else
                    EXPECT_NEAR(c, mesh.normals[0][k] / 5, 0x1p-50);
            }
    }
    mesh.normal_triangles.clear();
    write_surface_points(folder.path() / "a.ply", set.mesh->surface, set.points, "", &mesh);
    const std::string ply = read_whole_file(folder.path() / "a.ply");
    EXPECT_THAT(ply, testing::HasSubstr("property double v\nproperty uchar red\nend_header\n"));
    EXPECT_EQ(static_cast<unsigned char>(ply.back()), std::lround(columns.at("red").back()));
}

}
}
