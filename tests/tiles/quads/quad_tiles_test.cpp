// These tests are of surfaces of quads, and of Poisson disk tiles on them. Distances are measured by ways through
// places of edges, which are straight in space on each face of a polycube.
#include "tiles/quads/quad_points.hpp"

#include "tests/support/errors.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace poissonlab {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;

/// Makes the surface of unit cubes.
QuadMesh polycube(const std::set<std::array<int, 3>>& cubes)
{
    QuadMesh mesh;
    std::map<std::array<int, 3>, std::uint32_t> numbers;
    for (const auto& cube : cubes)
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (const int upper : {0, 1}) {
                auto beside = cube;
                beside[axis] += 2 * upper - 1;
                if (cubes.contains(beside)) continue;
                Quad quad{};
                for (std::size_t i = 0; i < 4; ++i) {
                    auto corner = cube;
                    corner[axis] += upper;
                    corner[(axis + (upper ? 1 : 2)) % 3] += i == 1 || i == 2;
                    corner[(axis + (upper ? 2 : 1)) % 3] += i == 2 || i == 3;
                    const auto [at, is_new] = numbers.try_emplace(corner, static_cast<std::uint32_t>(numbers.size()));
                    if (is_new) mesh.vertices.push_back({double(corner[0]), double(corner[1]), double(corner[2])});
                    quad[i] = at->second;
                }
                mesh.quads.push_back(quad);
            }
    return mesh;
}

QuadMesh cube() { return polycube({{0, 0, 0}}); }

/// Makes a seat with a back, at whose corners 3, 4 and 5 squares meet.
QuadMesh chair() { return polycube({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 1, 1}, {1, 1, 1}}); }

QuadMesh ring()
{
    return polycube({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {2, 1, 0}, {0, 2, 0}, {1, 2, 0}, {2, 2, 0}});
}

/// Makes a torus of `side` x `side` quads, whose places in space do not matter.
QuadMesh flat_torus(std::uint32_t side)
{
    QuadMesh mesh{std::vector<MeshPoint>(side * side), {}};
    for (std::uint32_t j = 0; j < side; ++j)
        for (std::uint32_t i = 0; i < side; ++i) {
            const auto at = [&](std::uint32_t x, std::uint32_t y) { return y % side * side + x % side; };
            mesh.quads.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    return mesh;
}

std::map<std::size_t, int> valences(const QuadMesh& mesh)
{
    const QuadTopology topology(mesh);
    std::map<std::size_t, int> counts;
    for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) ++counts[topology.valence(v)];
    return counts;
}

double length_between(const MeshPoint& a, const MeshPoint& b)
{
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

TEST(QuadMeshes, HaveTheEulerCharacteristicOfTheirGenus)
{
    EXPECT_EQ(QuadTopology(cube()).euler(), 2);
    EXPECT_EQ(QuadTopology(ring()).euler(), 0);
    const QuadMesh fine = refined(ring(), QuadTopology(ring()), 3), smooth = smoothed(fine, QuadTopology(fine));
    EXPECT_EQ(QuadTopology(smooth).euler(), 0);
    EXPECT_EQ(fine.quads.size(), 9 * ring().quads.size());
    EXPECT_EQ(smooth.quads.size(), 36 * ring().quads.size());
    // Gauss and Bonnet: quads that lack or are too many at vertices are 4 for each unit of the characteristic.
    int defect = 0;
    for (const auto& [valence, count] : valences(chair())) defect += (4 - static_cast<int>(valence)) * count;
    EXPECT_EQ(defect, 8);
    EXPECT_GT(valences(chair())[5], 0);
}

TEST(QuadMeshes, KeepPlanesWhenTheyAreRefined)
{
    const QuadMesh fine = refined(cube(), QuadTopology(cube()), 4);
    EXPECT_EQ(fine.vertices.size(), 6 * 16 + 2);
    for (const Quad& quad : fine.quads)
        for (std::size_t k = 0; k < 4; ++k)
            EXPECT_DOUBLE_EQ(length_between(fine.vertices[quad[k]], fine.vertices[quad[(k + 1) % 4]]), 0.25);
}

TEST(QuadMeshes, AreSmoothedAsCatmullAndClarkDo)
{
    QuadMesh mesh = cube();
    for (MeshPoint& p : mesh.vertices)
        for (double& c : p) c = 2 * c - 1;
    const QuadMesh smooth = smoothed(mesh, QuadTopology(mesh));
    // The rules for corners, (F + 2 R) / 3, and for edges give 5/9 and 3/4 for a cube of side 2.
    for (std::size_t v = 0; v < 8; ++v)
        for (const double c : smooth.vertices[v]) EXPECT_NEAR(std::abs(c), 5.0 / 9, 1e-15);
    for (std::size_t v = 8; v < 20; ++v) {
        std::array<double, 3> sorted{};
        for (std::size_t k = 0; k < 3; ++k) sorted[k] = std::abs(smooth.vertices[v][k]);
        std::ranges::sort(sorted);
        EXPECT_THAT(sorted, ElementsAre(DoubleNear(0, 1e-15), DoubleNear(0.75, 1e-15), DoubleNear(0.75, 1e-15)));
    }
}

TEST(QuadMeshes, AreRefusedWhereTheyAreNoClosedManifolds)
{
    const auto refused = [](const QuadMesh& mesh) { return message_of<InputError>([&] { QuadTopology{mesh}; }); };
    EXPECT_EQ(refused({}), "there are no quads");
    QuadMesh open = cube();
    open.quads.pop_back();
    EXPECT_THAT(refused(open), testing::HasSubstr("a quad on one side only: the surface must be closed"));
    QuadMesh turned = cube();
    std::ranges::reverse(turned.quads[2]);
    EXPECT_THAT(refused(turned), testing::HasSubstr("two quads on one side"));
    EXPECT_THAT(refused(polycube({{0, 0, 0}, {1, 1, 0}})), testing::HasSubstr("two quads on one side"));
    EXPECT_THAT(refused(polycube({{0, 0, 0}, {1, 1, 1}})), testing::HasSubstr("touch at vertex"));
    QuadMesh twice = cube();
    twice.quads[0][2] = twice.quads[0][0];
    EXPECT_EQ(refused(twice), "quad 1 has vertex 1 twice");
}

TEST(QuadPlaces, OfAllSidesTurnTogether)
{
    for (const double u : {0.1, 0.5, 0.8})
        for (const double v : {0.05, 0.3, 0.5})
            for (std::uint32_t q = 0; q < 4; ++q) {
                const auto at = turned_place(u, v, q), back = turned_place(at[0], at[1], 4 - q);
                EXPECT_NEAR(back[0], u, 1e-15);
                EXPECT_NEAR(back[1], v, 1e-15);
            }
    EXPECT_THAT(turned_place(0, 0, 1), ElementsAre(1, 0));
}

TEST(QuadPoints, KeepTheirDistanceOnATorusAsInThePlane)
{
    constexpr std::uint32_t side = 5;
    const QuadMesh mesh = flat_torus(side);
    const QuadPoints laid = lay_quad_points(mesh, QuadTopology(mesh), {0.2, 2, 7});
    double least = 10;
    for (std::size_t i = 0; i < laid.points.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const auto along = [&](double a, double b) { return std::abs(std::remainder(a - b, double{side})); };
            const QuadPoint &p = laid.points[i], &q = laid.points[j];
            least = std::min(least, std::hypot(along(p.quad % side + p.u, q.quad % side + q.u),
                                               along(p.quad / side + p.v, q.quad / side + q.v)));
        }
    EXPECT_GE(least, 0.2);
    EXPECT_LT(least, 0.205);
    // Saturated darts cover 0.547 by disks of that diameter; regions that are filled in turn cover a little less.
    const double covered = static_cast<double>(laid.points.size()) / (side * side) * 3.14159 * 0.01;
    EXPECT_GT(covered, 0.50);
    EXPECT_LT(covered, 0.57);
}

/// Finds the shortest way between places of two quads that share a vertex, over places of their common edge, or of the
/// two edges of a quad between them: never shorter than the true one.
class WaysOverEdges
{
public:
    explicit WaysOverEdges(const QuadMesh& mesh) : mesh_(mesh), topology_(mesh) {}

    double least_of_neighbours(const QuadPoints& laid) const
    {
        std::vector<std::vector<MeshPoint>> of_quads(mesh_.quads.size());
        for (const QuadPoint& p : laid.points) of_quads[p.quad].push_back(place_on(mesh_, p.quad, p.u, p.v));
        double least = 10;
        for (std::uint32_t v = 0; v < mesh_.vertices.size(); ++v) {
            const auto& around = topology_.around(v);
            for (std::size_t i = 0; i < around.size(); ++i)
                for (std::size_t steps = 0; steps <= 2; ++steps)
                    for (const MeshPoint& p : of_quads[around[i].quad])
                        for (const MeshPoint& q : of_quads[around[(i + steps) % around.size()].quad])
                            if (&p != &q) least = std::min(least, way(v, i, steps, p, q, least));
        }
        return least;
    }

private:
    /// Returns the end of the edge that the corner's quad and the one before it share.
    MeshPoint edge_place(std::uint32_t vertex, std::size_t i, int step) const
    {
        const QuadCorner at = topology_.around(vertex)[i % topology_.valence(vertex)];
        const MeshPoint &a = mesh_.vertices[vertex], &b = mesh_.vertices[mesh_.quads[at.quad][(at.corner + 1) % 4]];
        MeshPoint place{};
        for (std::size_t k = 0; k < 3; ++k) place[k] = a[k] + (b[k] - a[k]) * step / steps_;
        return place;
    }

    double way(std::uint32_t v, std::size_t i, std::size_t steps, const MeshPoint& p, const MeshPoint& q,
               double enough) const
    {
        if (length_between(p, q) >= enough) return enough;
        if (steps == 0) return length_between(p, q);
        double least = enough;
        for (int s = 0; s <= steps_; ++s) {
            const MeshPoint x = edge_place(v, i + 1, s);
            if (length_between(p, x) >= least) continue;
            if (steps == 1) {
                least = std::min(least, length_between(p, x) + length_between(x, q));
                continue;
            }
            for (int t = 0; t <= steps_; ++t) {
                const MeshPoint y = edge_place(v, i + 2, t);
                least = std::min(least, length_between(p, x) + length_between(x, y) + length_between(y, q));
            }
        }
        return least;
    }

    static constexpr int steps_ = 64;
    const QuadMesh& mesh_;
    QuadTopology topology_;
};

TEST(QuadPoints, KeepTheirDistanceAroundVerticesOfThreeAndFiveQuads)
{
    for (const QuadMesh& mesh : {cube(), chair()}) {
        const QuadPoints laid = lay_quad_points(mesh, QuadTopology(mesh), {0.25, 1, 3});
        const double least = WaysOverEdges(mesh).least_of_neighbours(laid);
        EXPECT_GE(least, 0.25);
        EXPECT_LT(least, 0.27); // that of some points is the distance, nearly
        EXPECT_GT(laid.points.size(), 8 * mesh.quads.size());
    }
}

TEST(QuadPoints, AreThoseOfFewTilesOnLargeSurfaces)
{
    const QuadMesh mesh = refined(chair(), QuadTopology(chair()), 12);
    const QuadPoints laid = lay_quad_points(mesh, QuadTopology(mesh), {0.25, 1, 3});
    // Tiles are combinations of four sectors, up to turns, and of directions of edges that are alike at both ends.
    EXPECT_LT(laid.tiles, mesh.quads.size() / 5);
    EXPECT_EQ(laid.disks, 3); // of 3, 4 and 5 quads
}

TEST(ConeDistances, GoTheShorterWayAroundAndThroughTheVertex)
{
    // Two places on sides of a corner of three quads, opposite each other: 135 degrees apart.
    EXPECT_NEAR(cone_squared(3, {0, 1, 0}, {1, std::sqrt(0.5), std::sqrt(0.5)}), 2 + std::sqrt(2), 1e-12);
    // Around six quads, a way of half a turn or more leads through the vertex.
    EXPECT_DOUBLE_EQ(cone_squared(6, {0, 1, 0}, {3, 1, 0}), 4);
    EXPECT_DOUBLE_EQ(cone_squared(4, {0, 1, 1}, {2, 1, 1}), 8);
    EXPECT_DOUBLE_EQ(cone_squared(4, {0, 1, 0}, {3, 0, 1}), 0);
}

}
}
