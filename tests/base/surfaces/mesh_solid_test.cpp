// The inside of meshes is compared with CGAL's, volumes with the divergence theorem, and what is no closed surface is
// refused.
#include "base/surfaces/mesh_solid.hpp"

#include "base/files/whole_file.hpp"
#include "base/regions/fixed_space.hpp"
#include "base/regions/solid_lattice.hpp"
#include "base/surfaces/triangle_tree.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/temporary_folder.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

namespace poissonlab {
namespace {

using testing::HasSubstr;

using SolidKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using SolidMesh = CGAL::Surface_mesh<SolidKernel::Point_3>;

/// The vertices of a mesh that lie at one place as one, turned such that no edge is along an axis if `turn` is not 0.
TriangleMesh joined(const TriangleMesh& mesh, double turn = 0)
{
    TriangleMesh result;
    std::map<std::array<std::int64_t, 3>, std::uint32_t> numbers;
    for (const MeshTriangle& t : mesh.triangles) {
        MeshTriangle corners{};
        for (std::size_t c = 0; c < 3; ++c) {
            const MeshPoint& p = mesh.vertices[t[c]];
            const std::array<std::int64_t, 3> key{std::llround(p[0] * 1e9), std::llround(p[1] * 1e9),
                                                  std::llround(p[2] * 1e9)};
            const auto [found, is_new] = numbers.try_emplace(key, static_cast<std::uint32_t>(result.vertices.size()));
            const double s = std::sin(turn), k = std::cos(turn), x = k * p[0] - s * p[1], y = s * p[0] + k * p[1];
            if (is_new) result.vertices.push_back({x, k * y - s * p[2], s * y + k * p[2]});
            corners[c] = found->second;
        }
        if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0])
            result.triangles.push_back(corners);
    }
    return result;
}

TriangleMesh box_mesh(double size = 1)
{
    TriangleMesh mesh;
    for (int i = 0; i < 8; ++i) mesh.vertices.push_back({size * (i & 1), size * (i >> 1 & 1), size * (i >> 2)});
    mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return mesh;
}

TriangleMesh torus_mesh()
{
    return joined(textured_mesh(40, 24, [](double u, double v) {
        const double along = 2 * M_PI * u, around = 2 * M_PI * v, away = 1 + 0.4 * std::cos(around);
        return MeshPoint{away * std::cos(along), away * std::sin(along), 0.4 * std::sin(around)};
    }));
}

/// By the divergence theorem: the sum of the tetrahedra between the origin and the triangles.
double divergence_volume(const TriangleMesh& mesh)
{
    double volume = 0;
    for (const auto& [a, b, c] : mesh.triangles)
        volume += dot(mesh.vertices[a], cross(mesh.vertices[b], mesh.vertices[c])) / 6;
    return volume;
}

class MeshSolids : public testing::Test
{
protected:
    std::filesystem::path file_of(const TriangleMesh& mesh)
    {
        std::string text = fmt::format("OFF\n{} {} 0\n", mesh.vertices.size(), mesh.triangles.size());
        for (const MeshPoint& p : mesh.vertices) text += fmt::format("{} {} {}\n", p[0], p[1], p[2]);
        for (const MeshTriangle& t : mesh.triangles) text += fmt::format("3 {} {} {}\n", t[0], t[1], t[2]);
        write_whole_file(folder.path() / "mesh.off", text);
        return folder.path() / "mesh.off";
    }

    /// Positions farther from the surface than a cell's diagonal are inside where CGAL says so; nearer ones may differ.
    void expect_as_cgal(const TriangleMesh& mesh)
    {
        const FixedSpace space(solid_of_mesh(file_of(mesh)));
        SolidMesh of_cgal;
        for (const MeshPoint& p : mesh.vertices) of_cgal.add_vertex({p[0], p[1], p[2]});
        for (const auto& [a, b, c] : mesh.triangles)
            of_cgal.add_face(SolidMesh::Vertex_index(a), SolidMesh::Vertex_index(b), SolidMesh::Vertex_index(c));
        const CGAL::Side_of_triangle_mesh<SolidMesh, SolidKernel> side(of_cgal);
        const TriangleTree tree(mesh);
        const double cell = space.unit() * (1 << FixedSpace::lattice_shift);
        std::mt19937 random(1);
        int far = 0, differ = 0, inside = 0;
        for (int i = 0; i < 5000; ++i) {
            TorusPoint<3> position;
            for (std::size_t k = 0; k < 3; ++k)
                position[k] = static_cast<std::uint32_t>(random() % (space.extent().high[k] + 1));
            const MeshPoint place = space.own(position);
            const MeshPoint off = difference(place_of(mesh, tree.nearest(place)), place);
            const bool by_cgal = side({place[0], place[1], place[2]}) == CGAL::ON_BOUNDED_SIDE;
            const bool is_near = std::sqrt(dot(off, off)) < cell * std::numbers::sqrt3;
            inside += by_cgal ? 1 : 0;
            far += is_near ? 0 : 1;
            if (is_near)
                differ += space.contains(position) != by_cgal ? 1 : 0;
            else
                EXPECT_EQ(space.contains(position), by_cgal);
        }
        EXPECT_GT(inside, 500);
        EXPECT_GT(far, 3000);
        EXPECT_LT(differ, 60) << "of some 500 in a layer of two diagonals";
    }

    TemporaryFolder folder;
};

TEST_F(MeshSolids, AreTheInsideByCgal)
{
    expect_as_cgal(box_mesh());
    expect_as_cgal(joined(sphere_mesh(12), 0.4));
    expect_as_cgal(torus_mesh());
    expect_as_cgal(joined(torus_mesh(), 1.1));
}

/// The lattice is off by h^2 / 12 of the curvature at smooth places, and by some 0.3 h^2 along edges.
TEST_F(MeshSolids, HaveTheVolumeOfTheDivergenceTheorem)
{
    for (const auto& mesh : {box_mesh(), box_mesh(1e6), box_mesh(1e-9), joined(box_mesh(), 0.3),
                             joined(sphere_mesh(20)), torus_mesh(), joined(torus_mesh(), 0.7)}) {
        const double volume = divergence_volume(mesh);
        EXPECT_NEAR(FixedSpace(solid_of_mesh(file_of(mesh))).volume(), volume, 1e-3 * volume);
        TriangleMesh inside_out = mesh;
        for (MeshTriangle& t : inside_out.triangles) std::swap(t[0], t[1]);
        EXPECT_NEAR(FixedSpace(solid_of_mesh(file_of(inside_out))).volume(), volume, 1e-3 * volume);
    }
}

TriangleMesh both(const TriangleMesh& a, const TriangleMesh& b, double shift, bool is_turned)
{
    TriangleMesh sum = a;
    const auto first = static_cast<std::uint32_t>(a.vertices.size());
    for (const MeshPoint& p : b.vertices) sum.vertices.push_back({p[0] + shift, p[1] + shift, p[2] + shift});
    for (const auto& [i, j, k] : b.triangles)
        sum.triangles.push_back(is_turned ? MeshTriangle{first + j, first + i, first + k}
                                          : MeshTriangle{first + i, first + j, first + k});
    return sum;
}

TEST_F(MeshSolids, MayHaveHollowsAndSeveralParts)
{
    const auto volume = [&](const TriangleMesh& mesh) { return FixedSpace(solid_of_mesh(file_of(mesh))).volume(); };
    EXPECT_NEAR(volume(both(box_mesh(), box_mesh(0.5), 0.25, true)), 0.875, 1e-3);
    EXPECT_NEAR(volume(both(box_mesh(), box_mesh(0.5), 2, false)), 1.125, 3e-3);
}

TEST_F(MeshSolids, ThatAreNotClosedAreRefused)
{
    const auto refusal = [&](const TriangleMesh& mesh) {
        return message_of([&] { FixedSpace(solid_of_mesh(file_of(mesh))); });
    };
    TriangleMesh open = box_mesh();
    open.triangles.pop_back();
    EXPECT_THAT(refusal(open),
                HasSubstr("mesh.off: a region needs a closed surface, and 3 edges have a face on one side only"));
    TriangleMesh turned = box_mesh();
    std::swap(turned.triangles[3][0], turned.triangles[3][1]);
    EXPECT_THAT(refusal(turned), HasSubstr("3 edges have faces of opposite orientation"));
    TriangleMesh twice = both(box_mesh(), box_mesh(), 0, false);
    EXPECT_THAT(refusal(twice), HasSubstr("edges have more than two faces"));
    EXPECT_THAT(refusal(both(box_mesh(), box_mesh(), 0.5, false)), HasSubstr("the surface overlaps itself"));
    EXPECT_THAT(refusal(both(box_mesh(), box_mesh(0.5), 2, true)), HasSubstr("are oriented differently"));
    TriangleMesh thin = box_mesh();
    for (MeshPoint& p : thin.vertices) p[2] = 0.5 + (p[2] - 0.5) * 1e-6;
    EXPECT_THAT(refusal(thin), HasSubstr("is thinner everywhere than a cell"));
    EXPECT_THAT(refusal(square_mesh()), HasSubstr("a face on one side only"));
    const auto scaled = [](double scale) {
        TriangleMesh mesh = box_mesh();
        for (MeshPoint& p : mesh.vertices)
            for (double& c : p) c *= scale;
        return mesh;
    };
    EXPECT_THAT(refusal(scaled(1e120)), HasSubstr("must be from 1e-60 to 1e+60"));
    EXPECT_THAT(refusal(scaled(1e-120)), HasSubstr("must be from 1e-60 to 1e+60"));
    for (const double scale : {1e-59, 1e59})
        EXPECT_NEAR(FixedSpace(solid_of_mesh(file_of(scaled(scale)))).volume() / scale / scale / scale, 1, 1e-3);
    EXPECT_THAT(message_of([&] { solid_of_mesh(folder.path() / "none.off"); }),
                HasSubstr("must be a file that is there"));
}

}
}
