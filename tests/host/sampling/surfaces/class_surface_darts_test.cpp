// Darts of several classes on surfaces: kernels against their twin, distances of all pairs, the order of classes, where
// points fall, saturation by places that would show a gap, and the density of one kind for equal distances.
#include "host/sampling/surfaces/class_surface_darts.hpp"

#include "base/errors/errors.hpp"
#include "tests/support/chi_square.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/meshes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>
#include <string>

namespace poissonlab {
namespace {

struct ClassSurfaceCase
{
    std::string name;
    TriangleMesh mesh;
    std::vector<double> distances;
    std::vector<std::size_t> points = {}; ///< empty: to saturation
    double between = 0;                   ///< of all pairs of classes; 0: by Wei's matrix
    double factor = 1;
    double angle = 120;
    bool has_densities = false; ///< class i follows (1 + x) to the power i
};

void PrintTo(const ClassSurfaceCase& c, std::ostream* out) { *out << c.name; }

ClassSurfaceRequest class_request(const ClassSurfaceCase& c, std::uint32_t realization = 0)
{
    const auto surface = std::make_shared<const FixedSurface>(fixed_surface(c.mesh));
    ClassSurfaceRequest request{.surface = surface,
                                .distances = wei_distances(c.distances, 2),
                                .angle = c.angle,
                                .shares = {},
                                .points = c.points,
                                .factor = c.factor,
                                .stream = stream_key(7, Purpose::class_darts, realization)};
    for (const double d : c.distances) request.shares.push_back(std::pow(d, -2));
    if (!c.points.empty()) request.shares.assign(c.points.begin(), c.points.end());
    for (std::size_t i = 0; i < c.distances.size(); ++i) {
        for (std::size_t j = 0; c.between > 0 && j < i; ++j) request.distances.set(i, j, c.between);
        if (c.has_densities)
            request.densities.push_back([surface, i](const SurfacePoint& at) {
                return std::pow(1 + surface->origin[0] + at.place[0] * surface->unit, static_cast<double>(i));
            });
    }
    return request;
}

ClassSurfaceDarts plain_classes(const ClassSurfaceRequest& request)
{
    return throw_class_surface_darts(request, *reference::class_surface_engine(request));
}

ClassSurfaceDarts classes_by_kernels(const ClassSurfaceRequest& request, std::size_t group_size)
{
    return throw_class_surface_darts(request, *class_surface_engine(request, Device::open(), group_size));
}

bool are_equal(const ClassSurfaceDarts& a, const ClassSurfaceDarts& b)
{
    return a.points.size() == b.points.size() && a.classes == b.classes && a.is_full == b.is_full &&
           a.scale == b.scale && a.small_area == b.small_area &&
           std::memcmp(a.points.data(), b.points.data(), a.points.size() * sizeof(SurfacePoint)) == 0;
}

/// The least distance of points of two classes that see each other, from all pairs, by doubles.
double least_of_classes(const FixedSurface& surface, const ClassSurfaceDarts& set, std::size_t one, std::size_t other,
                        double angle)
{
    const PointSet places = points_of(surface, set.points);
    double least = INFINITY;
    for (std::size_t i = 0; i < set.points.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            if (std::minmax<std::size_t>(set.classes[i], set.classes[j]) != std::minmax(one, other)) continue;
            const MeshPoint a = normal_of(surface.triangles[set.points[i].triangle]);
            const MeshPoint b = normal_of(surface.triangles[set.points[j].triangle]);
            if (angle < 180 && a[0] * b[0] + a[1] * b[1] + a[2] * b[2] < std::cos(angle * std::numbers::pi / 180))
                continue;
            least = std::min(least, std::hypot(places[i][0] - places[j][0], places[i][1] - places[j][1],
                                               places[i][2] - places[j][2]));
        }
    return least;
}

class ClassSurfaceSets : public testing::TestWithParam<ClassSurfaceCase>
{
};

TEST_P(ClassSurfaceSets, AreTheSameByKernels)
{
    const ClassSurfaceRequest request = class_request(GetParam());
    const ClassSurfaceDarts expected = plain_classes(request);
    for (const std::size_t group_size : {0, 16, 1})
        EXPECT_TRUE(are_equal(classes_by_kernels(request, group_size), expected)) << group_size;
}

TEST_P(ClassSurfaceSets, KeepTheDistanceOfEachPair)
{
    const ClassSurfaceRequest request = class_request(GetParam());
    const ClassSurfaceDarts set = plain_classes(request);
    const ClassDistances kept = request.distances.scaled(set.scale);
    for (std::size_t a = 0; a < kept.classes(); ++a)
        for (std::size_t b = 0; b <= a; ++b) {
            const double least = least_of_classes(*request.surface, set, a, b, request.angle);
            EXPECT_GE(least, kept.at(a, b) * (1 - 1e-15)) << a << " and " << b;
            if (request.points.empty() && set.points.size() > 300) {
                EXPECT_LT(least, kept.at(a, b) * 1.2) << a << " and " << b;
            }
        }
}

TEST_P(ClassSurfaceSets, FillClassesEvenly)
{
    const ClassSurfaceRequest request = class_request(GetParam());
    const ClassSurfaceDarts set = plain_classes(request);
    if (request.points.empty()) {
        EXPECT_EQ(set.is_full, std::vector<bool>(request.shares.size(), true));
        return;
    }
    EXPECT_EQ(set.counts(), request.points);
    std::vector<std::size_t> counts(request.points.size());
    for (const std::uint32_t own : set.classes) {
        for (std::size_t i = 0; i < counts.size(); ++i) // the one that comes is filled least
            EXPECT_LE(counts[own] * request.points[i], counts[i] * request.points[own]);
        ++counts[own];
    }
}

// Oclgrind interprets these as well: see tests/CMakeLists.txt.
INSTANTIATE_TEST_SUITE_P(Small, ClassSurfaceSets,
                         testing::Values(ClassSurfaceCase{"square", square_mesh(), {0.7, 0.4}},
                                         ClassSurfaceCase{"sheet", sheet_mesh(0.1), {0.9, 0.6}, {2, 6}, 0, 0.8}));
INSTANTIATE_TEST_SUITE_P(
    Sizes, ClassSurfaceSets,
    testing::Values(ClassSurfaceCase{"one class, saturated", sphere_mesh(12), {0.2}},
                    ClassSurfaceCase{"sphere, saturated", sphere_mesh(12), {0.5, 0.25, 0.15}},
                    ClassSurfaceCase{"sphere, to numbers", sphere_mesh(30), {0.3, 0.1, 0.1}, {40, 300, 200}},
                    ClassSurfaceCase{"sphere, relaxed", sphere_mesh(12), {0.45, 0.3}, {40, 120}, 0, 0.95},
                    ClassSurfaceCase{"square, own matrix", square_mesh(3), {0.05, 0.08}, {}, 0.15},
                    ClassSurfaceCase{"sheet", sheet_mesh(0.01), {0.2, 0.1}},
                    ClassSurfaceCase{"sheet, all see each other", sheet_mesh(0.01), {0.2, 0.1}, {}, 0, 1, 180},
                    ClassSurfaceCase{"square, densities", square_mesh(2), {0.05, 0.02}, {60, 300}, 0, 1, 120, true},
                    ClassSurfaceCase{"few points", sphere_mesh(6), {0.1, 0.1, 0.1}, {1, 2, 3}}));

/// Returns by how much the loneliest of some places is farther from all points than a class keeps from them.
double class_gap(const ClassSurfaceRequest& request, const ClassSurfaceDarts& set, std::size_t own,
                 const std::vector<SurfacePoint>& places)
{
    const FixedSurface& surface = *request.surface;
    double largest = -INFINITY;
    for (const SurfacePoint& place : places) {
        double gap = INFINITY;
        for (std::size_t i = 0; i < set.points.size(); ++i)
            if (cosine_between(surface.triangles[place.triangle], surface.triangles[set.points[i].triangle]) >=
                least_cosine(request.angle))
                gap = std::min(
                    gap, std::sqrt(static_cast<double>(squared_distance(place_of(place), place_of(set.points[i])))) *
                                 surface.unit -
                             request.distances.at(own, set.classes[i]));
        largest = std::max(largest, gap);
    }
    return largest;
}

TEST(SaturatedClassSurfaces, LeaveNoGap)
{
    for (const ClassSurfaceCase& c : {ClassSurfaceCase{"sphere", sphere_mesh(10), {0.6, 0.3}},
                                      ClassSurfaceCase{"sheet", sheet_mesh(0.05), {0.3, 0.2}}}) {
        const ClassSurfaceRequest request = class_request(c);
        ClassSurfaceDarts set = plain_classes(request);
        EXPECT_EQ(set.small_area, 0);
        const std::vector<SurfacePiece> pieces = whole_pieces(*request.surface);
        const SurfacePieceChoice choice = surface_piece_choice(*request.surface, pieces);
        std::vector<SurfacePoint> places;
        for (std::size_t i = 0; i < 15'000; ++i)
            places.push_back(reference::surface_dart(*request.surface, pieces, choice,
                                                     stream_key(9, Purpose::surface_coverage, 0), i));
        for (std::size_t own = 0; own < 2; ++own) EXPECT_LT(class_gap(request, set, own, places), 0) << c.name;
        // The measure sees the gap that a point leaves that is taken away, at least there.
        const std::uint32_t last = set.classes.back();
        places.push_back(set.points.back());
        set.points.pop_back();
        set.classes.pop_back();
        EXPECT_GE(class_gap(request, set, last, places), 0) << c.name;
    }
}

/// Classes that all keep one distance are a set of one kind whose points have colours: those have the number of random
/// sequential addition, 0.547 of the area under disks, as sets of surface_darts.hpp have.
TEST(SaturatedClassSurfaces, OfOneDistanceAreAsDenseAsOneKind)
{
    const std::shared_ptr<const FixedSurface> sphere =
        std::make_shared<const FixedSurface>(fixed_surface(sphere_mesh(40)));
    const double d = std::sqrt(saturated_count(sphere->area, 1) / 1000);
    double sum = 0, squares = 0;
    constexpr int sets = 8;
    for (std::uint32_t i = 0; i < sets; ++i) {
        ClassSurfaceRequest request{.surface = sphere, .distances = ClassDistances(2), .angle = 120};
        for (std::size_t a = 0; a < 2; ++a)
            for (std::size_t b = 0; b <= a; ++b) request.distances.set(a, b, d);
        request.shares = {1, 3};
        request.stream = stream_key(4, Purpose::class_darts, i);
        const auto count = static_cast<double>(classes_by_kernels(request, 0).points.size());
        sum += count / sets;
        squares += count * count / sets;
    }
    const double error = std::sqrt((squares - sum * sum) / (sets - 1));
    EXPECT_LT(error, 8);
    EXPECT_NEAR(sum, 1000, 4 * error + 1000 * d * d);
}

/// Darts that hardly reject each other fall by the areas of triangles: rows of a sphere from pole to pole.
TEST(ClassSurfaceDarts, FallByAreas)
{
    ClassSurfaceCase c{"sphere", sphere_mesh(8), {2e-4, 2e-4}, {30'000, 10'000}};
    const ClassSurfaceRequest request = class_request(c);
    const ClassSurfaceDarts set = classes_by_kernels(request, 0);
    for (std::uint32_t own = 0; own < 2; ++own) {
        std::vector<double> counts(request.surface->triangles.size());
        for (const SurfacePoint& point : set.of_class(own)) ++counts[point.triangle];
        double statistic = 0;
        for (std::size_t i = 0; i < counts.size(); ++i) {
            const double expected =
                request.surface->areas[i] / request.surface->area * static_cast<double>(request.points[own]);
            statistic += (counts[i] - expected) * (counts[i] - expected) / expected;
        }
        const double tail = test::chi_square_tail(statistic, static_cast<double>(counts.size() - 1));
        EXPECT_GT(tail, 1e-4);
        EXPECT_LT(tail, 1 - 1e-4);
    }
}

/// Class i follows x + 1 to the power i over the unit square: its part below x is ((x + 1)^(i + 1) - 1) / (2^(i + 1) -
/// 1). Targets are evenly spread, so that counts of ten bands are nearer to it than those of independent points.
TEST(ClassSurfaceDarts, FollowTheirDensities)
{
    ClassSurfaceCase c{"square", square_mesh(2), {0.016, 0.016}, {1000, 1000}};
    c.has_densities = true;
    const ClassSurfaceRequest request = class_request(c);
    const ClassSurfaceDarts set = plain_classes(request);
    for (std::uint32_t own = 0; own < 2; ++own) {
        std::vector<double> counts(10);
        for (const SurfacePoint& point : set.of_class(own)) {
            const double x = request.surface->origin[0] + point.place[0] * request.surface->unit;
            ++counts[std::min<std::size_t>(9, static_cast<std::size_t>(10 * x))];
        }
        double statistic = 0;
        const auto below = [own](double x) { return (std::pow(x + 1, own + 1) - 1) / (std::pow(2, own + 1) - 1); };
        for (std::size_t i = 0; i < 10; ++i) {
            const double expected =
                1000 * (below(static_cast<double>(i + 1) / 10) - below(static_cast<double>(i) / 10));
            statistic += (counts[i] - expected) * (counts[i] - expected) / expected;
        }
        EXPECT_LT(statistic, 9) << own; // the mean of independent points; a wrong density has hundreds
    }
}

TEST(ClassSurfaceDarts, HaveWeightsOfTheirDensities)
{
    const FixedSurface surface = fixed_surface(square_mesh(2));
    const std::vector<SurfacePiece> pieces = small_pieces(surface);
    double area = 0;
    for (const SurfacePiece& piece : pieces) {
        area += area_of(surface, piece);
        EXPECT_LE(area_of(surface, piece), surface.area * 0x1p-16);
    }
    EXPECT_NEAR(area, 1, 1e-12);
    // The mean of x (1 - x) is 1/6, its largest value 1/4; the corners of pieces' places lie on a grid of 2^-31.
    const auto weighted = weighted_pieces(surface, pieces, [&](const SurfacePoint& at) {
        const double x = surface.origin[0] + at.place[0] * surface.unit;
        return x * (1 - x);
    });
    EXPECT_NEAR(weighted.fullness, 2.0 / 3, 1e-4);
    EXPECT_TRUE(weighted_pieces(surface, pieces, [](const SurfacePoint&) { return 0; }).pieces.empty());
    ClassSurfaceCase c{"square", square_mesh(), {0.1, 0.1}, {5, 5}};
    ClassSurfaceRequest request = class_request(c);
    request.densities = {[](const SurfacePoint&) { return 1; }, [](const SurfacePoint&) { return 0; }};
    EXPECT_EQ(message_of([&] { plain_classes(request); }), "the density of class 1 is 0 everywhere");
}

}
}
