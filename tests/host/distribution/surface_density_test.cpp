// Points on surfaces that follow a density have counts of closed forms, and are those that all pairs select; wrong
// densities are refused.
#include "host/distribution/surfaces/surface_density.hpp"

#include "base/files/whole_file.hpp"
#include "host/distribution/surfaces/surface_set.hpp"
#include "host/sampling/surfaces/surface_darts.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace poissonlab {
namespace {

struct DensityCase
{
    TriangleMesh mesh;
    std::string density;
    std::size_t points = 2000;
};

PointSet points_of_density(const DensityCase& c, std::uint64_t seed = 1)
{
    MeshPointSettings settings;
    settings.read = std::make_shared<const SurfaceMesh>(SurfaceMesh{c.mesh, fixed_surface(c.mesh)});
    settings.method = SurfaceMethod::elimination;
    settings.points = c.points;
    settings.density = c.density;
    return make_surface_set(settings, seed, {.engine = Engine::reference, .device = {}}).places();
}

/// Returns the chi-square of counts in eight bands of equal width along an axis from `low` to `high`: `below(t)` is the
/// expected part of the points below t.
template <typename Below>
double chi_square_of_bands(const PointSet& set, std::size_t axis, double low, double high, const Below& below)
{
    std::array<double, 8> counts{};
    for (std::size_t i = 0; i < set.size(); ++i) {
        const double along = std::clamp((set[i][axis] - low) / (high - low) * 8, 0.0, 7.999);
        ++counts[static_cast<std::size_t>(along)];
    }
    double sum = 0;
    for (std::size_t b = 0; b < 8; ++b) {
        const auto end = [&](std::size_t k) { return low + (high - low) * static_cast<double>(k) / 8; };
        const double expected = (below(end(b + 1)) - below(end(b))) * static_cast<double>(set.size());
        sum += (counts[b] - expected) * (counts[b] - expected) / expected;
    }
    return sum;
}

/// With 7 degrees of freedom, random points exceed this once in a thousand sets; even ones have less.
constexpr double chi_square_limit = 24.3;

/// On a sphere, heights are uniform (Archimedes), so that a density of 1 + 0.9 z has a share of (z + 1) / 2 +
/// 0.9 (z^2 - 1) / 4 below z. Without the density the test must fail.
TEST(SurfaceDensities, HaveTheCountsOfTheirIntegralOnASphere)
{
    const auto below = [](double z) { return (z + 1) / 2 + 0.9 * (z * z - 1) / 4; };
    for (const std::uint64_t seed : {1, 2, 3}) {
        const PointSet set = points_of_density({sphere_mesh(48), "1 + 0.9*z"}, seed);
        EXPECT_LT(chi_square_of_bands(set, 2, -1, 1, below), chi_square_limit);
        EXPECT_GT(chi_square_of_bands(set, 2, -1, 1, [](double z) { return (z + 1) / 2; }), 10 * chi_square_limit);
    }
}

/// A number of vertices that is linear in x gives the same density as a formula.
TEST(SurfaceDensities, AreThoseOfVerticesToo)
{
    TriangleMesh mesh = square_mesh(4);
    mesh.columns = {{"quality"}, {false}, {}};
    for (const MeshPoint& v : mesh.vertices) mesh.columns.values.push_back(0.5 + 3 * v[0]);
    const auto below = [](double x) { return (0.5 * x + 1.5 * x * x) / 2; };
    EXPECT_LT(chi_square_of_bands(points_of_density({mesh, "quality"}), 0, 0, 1, below), chi_square_limit);
    EXPECT_LT(chi_square_of_bands(points_of_density({mesh, "0.5 + 3*x"}), 0, 0, 1, below), chi_square_limit);
}

/// A picture that is white in its upper right quarter alone lies over texture coordinates, v upwards, twice along u.
TEST(SurfaceDensities, AreThoseOfPicturesOverTextureCoordinates)
{
    const TemporaryFolder folder;
    write_whole_file(folder.path() / "corner.pgm", "P2\n2 2\n1\n0 1\n0 0\n");
    TriangleMesh mesh = square_mesh();
    for (const MeshPoint& v : mesh.vertices) mesh.texture_points.push_back({2 * v[0], v[1]});
    mesh.texture_triangles = mesh.triangles;
    const PointSet set = points_of_density({mesh, (folder.path() / "corner.pgm").string(), 400});
    int left = 0;
    for (std::size_t i = 0; i < set.size(); ++i) {
        EXPECT_GE(set[i][1], 0.5 - 1e-8);
        EXPECT_GE(std::fmod(set[i][0], 0.5), 0.25 - 1e-8);
        left += set[i][0] < 0.5;
    }
    EXPECT_NEAR(left, 200, 4 * 10); // four deviations of a fair coin's 400 throws
}

TEST(SurfaceDensities, HaveNoPointsWhereTheyAreZero)
{
    for (const std::size_t points : {1, 2, 3, 500}) {
        const PointSet set = points_of_density({square_mesh(), "x > 0.75", points});
        ASSERT_EQ(set.size(), points);
        for (std::size_t i = 0; i < points; ++i) EXPECT_GT(set[i][0], 0.75);
    }
}

/// Repeated removal of the heaviest of 40 candidates, by weights of all pairs, gives the same points as octaves and
/// cells.
TEST(SurfaceDensities, RemoveWhatAllPairsSay)
{
    const TriangleMesh mesh = sheet_mesh(0.02);
    const FixedSurface surface = fixed_surface(mesh);
    SurfaceDensity density("0.01 + x^4", "light", mesh);
    const auto candidates = density_candidates(surface, density, 40, stream_key(7, Purpose::surface_candidates, 0));
    constexpr std::size_t kept = 12;
    std::vector<std::size_t> left(40);
    for (std::size_t i = 0; i < 40; ++i) left[i] = i;
    const PointSet places = points_of(surface, candidates.points);
    const auto weight = [&](std::size_t i, std::size_t j) {
        const auto kept_distance = [&](std::size_t p) {
            return std::sqrt(2 / std::sqrt(3.0) * candidates.integral / (kept * candidates.densities[p]));
        };
        if (places[i][2] != places[j][2]) return 0.0; // on two sides
        const double d = std::hypot(places[i][0] - places[j][0], places[i][1] - places[j][1]);
        const double part = d / std::min(kept_distance(i), kept_distance(j));
        return part >= 1 ? 0 : std::pow(1 - std::max(part, 0.65 * (1 - std::pow(kept / 40.0, 1.5))), 8);
    };
    while (left.size() > kept) {
        std::size_t heaviest = 0;
        double most = -1;
        for (std::size_t a = 0; a < left.size(); ++a) {
            double sum = 0;
            for (const std::size_t j : left) sum += j == left[a] ? 0 : weight(left[a], j);
            if (sum > most) most = sum, heaviest = a;
        }
        left.erase(left.begin() + static_cast<std::ptrdiff_t>(heaviest));
    }
    std::vector<std::array<int, 3>> expected, found;
    for (const std::size_t i : left) expected.push_back(std::to_array(candidates.points[i].place));
    for (const SurfacePoint& p : eliminate_by_density(surface, candidates, kept, 120))
        found.push_back(std::to_array(p.place));
    EXPECT_THAT(found, testing::UnorderedElementsAreArray(expected));
}

/// No two points are nearer than half of the distance that their densities have in a densest packing.
TEST(SurfaceDensities, AreEven)
{
    const PointSet set = points_of_density({square_mesh(), "0.2 + x", 1000});
    double least = INFINITY;
    for (std::size_t i = 0; i < set.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const double d = std::hypot(set[i][0] - set[j][0], set[i][1] - set[j][1]);
            const double densest = 0.2 + std::max(set[i][0], set[j][0]);
            least = std::min(least, d / std::sqrt(2 / std::sqrt(3.0) * 0.7 / (1000 * densest)));
        }
    EXPECT_GT(least, 0.5);
}

/// A peak at the pole of a sphere that takes 10^-7 of its area, and that none of 131,072 places meets, is told of. A
/// density whose largest place is a corner that places come near to is not.
TEST(SurfaceDensities, TellOfPeaksAtCorners)
{
    MeshPointSettings settings;
    const TriangleMesh mesh = sphere_mesh(12);
    settings.read = std::make_shared<const SurfaceMesh>(SurfaceMesh{mesh, fixed_surface(mesh)});
    settings.method = SurfaceMethod::elimination;
    settings.points = 20;
    const auto notes = [&](const std::string& density) {
        settings.density = density;
        return make_surface_set(settings, 1, {.engine = Engine::reference, .device = {}}).notes;
    };
    EXPECT_THAT(notes("1 + z"), testing::IsEmpty());
    EXPECT_THAT(notes("1 + 9*exp(-1e7*(x*x + y*y + (z - 1)^2))"),
                testing::ElementsAre("the density is more than a tenth larger at 24 of 1584 corners of triangles than "
                                     "the largest value that was looked for: peaks are flattened"));
}

/// Units of a density do not matter, however large or small: powers of two change no digit.
TEST(SurfaceDensities, HaveAnyUnit)
{
    const PointSet set = points_of_density({square_mesh(), "1 + x", 200});
    for (const char* unit : {"2^1022", "2^(-1020)"})
        EXPECT_EQ(points_of_density({square_mesh(), std::string(unit) + "*(1 + x)", 200}), set);
}

/// Places with larger densities than the first 131,072 have are counted: those of a small square.
TEST(SurfaceDensities, CountFlattenedPlaces)
{
    const TriangleMesh mesh = square_mesh();
    const FixedSurface surface = fixed_surface(mesh);
    SurfaceDensity density("1 + 9*(x > 0.5)*(x < 0.501)*(y > 0.5)*(y < 0.503)", "light", mesh);
    const auto pieces = whole_pieces(surface);
    const auto choice = surface_piece_choice(surface, pieces);
    std::uint64_t flattened = 0;
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
        const StreamKey stream = stream_key(seed, Purpose::surface_candidates, 0);
        const DensityCandidates candidates = density_candidates(surface, density, 400'000, stream);
        std::uint64_t first = 0, later = 0;
        for (std::uint64_t i = 0; i < candidates.darts; ++i)
            (i < 131'072 ? first : later) +=
                density.at(surface, reference::surface_dart(surface, pieces, choice, stream, i)) > 5;
        EXPECT_EQ(candidates.larger, first > 0 ? 0 : later);
        flattened += candidates.larger;
    }
    EXPECT_GT(flattened, 0U);
}

TEST(SurfaceDensities, RefuseWhatIsNone)
{
    TriangleMesh mesh = square_mesh();
    mesh.columns = {{"red"}, {false}, {0, 1, NAN, 1}};
    const auto refusal = [&](const std::string& text) {
        return message_of([&] { points_of_density({mesh, text, 10}); });
    };
    EXPECT_THAT(refusal("0.5 - x"),
                testing::MatchesRegex("0.5 - x: is -0\\.[0-9]+ at .*: must be a finite number of.*"));
    EXPECT_THAT(refusal("1/0"), testing::HasSubstr("must be a finite number"));
    EXPECT_THAT(refusal("red"), testing::HasSubstr("red: is nan at"));
    EXPECT_THAT(refusal("0*x"), testing::StartsWith("0*x: is 0 everywhere on the mesh"));
    EXPECT_THAT(refusal("quality"), testing::HasSubstr("numbers of the mesh's vertices: red"));
    const TemporaryFolder folder;
    const std::filesystem::path picture = folder.path() / "grey.pgm";
    write_whole_file(picture, "P2\n1 1\n1\n1\n");
    EXPECT_THAT(refusal(picture.string()), testing::HasSubstr("needs texture coordinates, and the mesh has none"));
}

}
}
