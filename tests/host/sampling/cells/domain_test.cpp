// Movement in domains against closed forms, and against a walk along the way in small steps.
#include "host/sampling/cells/domain.hpp"

#include "tests/support/convex_regions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace poissonlab {
namespace {

/// A few sums and products of numbers up to 1.
constexpr double rounding = 16 * std::numeric_limits<double>::epsilon();

/// The distance that counts as on the boundary, and rounding.
constexpr double depth_allowed = 0x1p-46 + rounding;

constexpr double r = 0.08;
const double a = r * (1 + std::sqrt(2.0));
const std::vector<std::array<double, 2>> octagon{{a, -r}, {a, r},   {r, a},   {-r, a},
                                                 {-a, r}, {-a, -r}, {-r, -a}, {r, -a}};

Vector sum_of(const Vector& p, const Vector& q, double factor = 1)
{
    return {p[0] + factor * q[0], p[1] + factor * q[1], p[2] + factor * q[2]};
}

double product(const Vector& p, const Vector& q) { return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]; }
double length(const Vector& p) { return std::sqrt(product(p, p)); }

Vector wrapped(Vector p)
{
    for (double& x : p) {
        x -= std::floor(x);
        if (x >= 1) x = 0;
    }
    return p;
}

/// The height of a position above a region's boundary, by the half-space that it is farthest above; negative
/// inside.
double height_over(const ConvexRegion& region, const Vector& position)
{
    Vector difference;
    for (int k = 0; k < 3; ++k) {
        difference[k] = position[k] - region.centre[k];
        difference[k] -= std::rint(difference[k]);
    }
    double height = -1;
    for (const HalfSpace& h : region.half_spaces) height = std::max(height, product(h.normal, difference) - h.offset);
    return height;
}

double height_over(const Domain& domain, const Vector& position)
{
    double height = 1;
    for (const ConvexRegion& region : domain.forbidden) height = std::min(height, height_over(region, position));
    return height;
}

Vector random_vector(std::mt19937_64& random, int dimension, double low, double high)
{
    std::uniform_real_distribution<double> uniform(low, high);
    Vector v{};
    for (int k = 0; k < dimension; ++k) v[k] = uniform(random);
    return v;
}

Vector random_direction(std::mt19937_64& random, int dimension)
{
    for (;;) {
        Vector v = random_vector(random, dimension, -1, 1);
        const double size = length(v);
        if (size > 1 || size < 0.1) continue;
        for (double& x : v) x /= size;
        return v;
    }
}

/// Regions of every kind, some overlapping, some across the border of the torus.
Domain domain_of(int dimension)
{
    Domain domain;
    domain.forbidden.push_back(polygon_region({0, 0, 0}, octagon));
    domain.forbidden.push_back(box_region({0, 0, 0}, {0.5, r, 0.5}, dimension));
    domain.forbidden.push_back(box_region({0.45, 0.5, 0.97}, {0.1, 0.15, 0.2}, dimension));
    if (dimension == 3) {
        domain.forbidden.push_back(polygon_region({0.8, 0.5, 0.5}, octagon, 0));
        domain.forbidden.push_back(polygon_region({0.1, 0.4, 0.9}, octagon, 1, 0.3));
    }
    return domain;
}

void expect_near(const Vector& found, const Vector& expected, double tolerance = rounding)
{
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(found[k], expected[k], tolerance) << "axis " << k;
}

TEST(Domain, BoxesAreBounded)
{
    const ConvexRegion square = box_region({0.5, 0.5, 0}, {0.1, 0.1, 0}, 2);
    EXPECT_EQ(square.half_spaces.size(), 4);
    EXPECT_NEAR(height_over(square, {0.65, 0.5, 0}), 0.05, rounding);
    EXPECT_NEAR(height_over(square, {0.5, 0.5, 0}), -0.1, rounding);
    EXPECT_EQ(box_region({0, 0, 0}, {0.5, 0.1, 0.5}, 3).half_spaces.size(), 2);
    EXPECT_EQ(box_region({0, 0, 0}, {0.1, 0.1, 0.1}, 3).half_spaces.size(), 6);
}

TEST(Domain, TheOctagonIsRegular)
{
    const ConvexRegion region = polygon_region({0, 0, 0}, octagon);
    ASSERT_EQ(region.half_spaces.size(), 8);
    for (const HalfSpace& h : region.half_spaces) {
        EXPECT_NEAR(length(h.normal), 1, rounding);
        EXPECT_NEAR(h.offset, a, rounding); // regular: all sides are as far from the centre
        EXPECT_EQ(h.normal[2], 0);
    }
    for (const auto& v : octagon) EXPECT_NEAR(height_over(region, {v[0], v[1], 0}), 0, rounding);
}

TEST(Domain, PrismsLieAlongTheirAxes)
{
    for (int axis = 0; axis < 3; ++axis) {
        const ConvexRegion prism = polygon_region({0, 0, 0}, octagon, axis, 0.3);
        ASSERT_EQ(prism.half_spaces.size(), 10);
        EXPECT_EQ(polygon_region({0, 0, 0}, octagon, axis).half_spaces.size(), 8);
        Vector position{};
        position[axis] = 0.35;
        EXPECT_NEAR(height_over(prism, position), 0.05, rounding);
        Vector displacement{};
        displacement[axis] = -0.2;
        Vector expected{};
        expected[axis] = -0.05;
        expect_near(allowed_displacement({{prism}, {}}, position, displacement, false), expected);

        // A rectangle shows which coordinates its vertices are.
        const std::vector<std::array<double, 2>> flat{{0.2, -0.1}, {0.2, 0.1}, {-0.2, 0.1}, {-0.2, -0.1}};
        Vector beside{};
        beside[(axis + 1) % 3] = 0.3;
        EXPECT_NEAR(height_over(polygon_region({0, 0, 0}, flat, axis), beside), 0.1, rounding);
    }
}

TEST(Domain, MovementEndsAtASquareOrSlidesAlongIt)
{
    const Domain domain{{box_region({0.5, 0.5, 0}, {0.1, 0.1, 0}, 2)}, {}};
    const Vector left{0.3, 0.5, 0};
    expect_near(allowed_displacement(domain, left, {0.2, 0.02, 0}, false), {0.1, 0.01, 0});
    expect_near(allowed_displacement(domain, left, {0.2, 0.02, 0}, true), {0.1, 0.02, 0});
    EXPECT_EQ(allowed_displacement(domain, left, {-0.2, 0.02, 0}, true), (Vector{-0.2, 0.02, 0}));
    EXPECT_EQ(allowed_displacement(domain, left, {0.05, 0.02, 0}, true), (Vector{0.05, 0.02, 0}));
    // A step that would pass over it ends before it.
    expect_near(allowed_displacement(domain, left, {0.5, 0, 0}, false), {0.1, 0, 0});
    // A step from the other side, across the border, ends at that place, too.
    expect_near(allowed_displacement(domain, {0.9, 0.5, 0}, {0.7, 0, 0}, false), {0.5, 0, 0});
}

TEST(Domain, ASlidingPointMayMeetTwoSides)
{
    // Along the strip's side into the octagon's, which is inclined by 45 degrees, and up that.
    const Domain domain{{polygon_region({0.5, 0.5, 0}, octagon), box_region({0.5, 0.5, 0}, {0.5, r, 0}, 2)}, {}};
    const Vector moved = allowed_displacement(domain, {0.5 + a + 0.05, 0.5 + r, 0}, {-0.09, -0.01, 0}, true);
    expect_near(moved, {-0.05 - 0.02, 0.02, 0});
}

TEST(Domain, SlabsSpanTheTorus)
{
    const Domain domain{{box_region({0.5, 0.25, 0.1}, {0.5, 0.05, 0.5}, 3)}, {}};
    for (const double x : {0.0, 0.01, 0.499, 0.5, 0.501, 0.999}) {
        expect_near(allowed_displacement(domain, {x, 0.35, 0.6}, {0.3, -0.1, 0.4}, false), {0.15, -0.05, 0.2});
        expect_near(allowed_displacement(domain, {x, 0.35, 0.6}, {0.3, -0.1, 0.4}, true), {0.3, -0.05, 0.4});
        expect_near(allowed_displacement(domain, {x, 0.9, 0.6}, {0.3, 0.5, 0.4}, false), {0.18, 0.3, 0.24});
    }
}

TEST(Domain, RegionsWithoutBoundsAreNone)
{
    const Domain domain{{box_region({0, 0, 0}, {0.5, 0.5, 0.5}, 2)}, {}};
    EXPECT_EQ(allowed_displacement(domain, {0.3, 0.3, 0}, {0.1, 0, 0}, true), (Vector{0.1, 0, 0}));
}

TEST(Domain, SlidingKeepsTheTangentialComponent)
{
    std::mt19937_64 random(1);
    for (int i = 0; i < 20000; ++i) {
        const int dimension = 2 + i % 2;
        const HalfSpace half_space{random_direction(random, dimension), 0.1};
        const Domain domain{{{{0.5, 0.5, 0.5}, {half_space}}}, {}};
        // Close above the boundary, on it but for rounding, or just inside.
        const double above = i % 3 == 0 ? 0.02 : i % 3 == 1 ? 0 : -1e-15;
        Vector position = sum_of({0.5, 0.5, dimension == 3 ? 0.5 : 0}, half_space.normal, 0.1 + above);
        const Vector movement = random_vector(random, dimension, -0.1, 0.1);
        const Vector moved = allowed_displacement(domain, position, movement, true);
        const double along_normal = product(movement, half_space.normal);
        if (above + along_normal >= rounding) {
            EXPECT_EQ(moved, movement);
            continue;
        }
        const Vector expected = sum_of(movement, half_space.normal, -along_normal - std::max(above, 0.0));
        expect_near(moved, expected);
    }
}

TEST(Domain, PointsAtCornersLeaveInEveryFreeDirection)
{
    // Whichever side of the corner rounding put the point on.
    const Domain domain{{polygon_region({0.5, 0.5, 0}, octagon)}, {}};
    std::mt19937_64 random(2);
    std::uniform_int_distribution<int> ulps(-2, 2);
    for (int i = 0; i < 20000; ++i) {
        const auto& v = octagon[i % 8];
        const Vector position{0.5 + v[0] + ulps(random) * 0x1p-53, 0.5 + v[1] + ulps(random) * 0x1p-53, 0};
        const Vector movement = random_vector(random, 2, -0.05, 0.05);
        const double after = height_over(domain, sum_of(position, movement, 1e-3));
        const Vector stopped = allowed_displacement(domain, position, movement, false);
        if (after > 1e-9) {
            EXPECT_EQ(stopped, movement);
        }
        if (after < -1e-9) {
            EXPECT_LE(length(stopped), 1e-12);
        }
    }
}

TEST(Domain, MovementEndsWhereAWalkWouldEnter)
{
    std::mt19937_64 random(3);
    int stops = 0;
    for (int i = 0; i < 6000; ++i) {
        const int dimension = 2 + i % 2;
        const Domain domain = domain_of(dimension);
        const Vector position = random_vector(random, dimension, 0, 1);
        if (height_over(domain, position) <= 0) continue;
        const Vector movement = random_vector(random, dimension, -0.8, 0.8);
        const Vector moved = allowed_displacement(domain, position, movement, false);
        const double part = length(moved) / length(movement);
        expect_near(moved, sum_of({}, movement, part));

        for (int step = 0; step <= 300; ++step)
            ASSERT_GE(height_over(domain, sum_of(position, moved, step / 300.0)), -rounding);
        if (moved == movement) continue;
        ++stops;
        EXPECT_NEAR(height_over(domain, sum_of(position, moved)), 0, rounding);
        EXPECT_LT(height_over(domain, sum_of(position, movement, part + 1e-9)), 0);
    }
    EXPECT_GT(stops, 1000);
}

TEST(Domain, ManyMovementsDoNotLeadIn)
{
    std::mt19937_64 random(4);
    for (const int dimension : {2, 3}) {
        const Domain domain = domain_of(dimension);
        for (int i = 0; i < 100; ++i) {
            Vector position = random_vector(random, dimension, 0, 1);
            if (height_over(domain, position) <= 0) continue;
            // A steady push, as by neighbours, and some noise.
            const Vector push = random_vector(random, dimension, -0.05, 0.05);
            for (int pass = 0; pass < 400; ++pass) {
                const Vector noise = random_vector(random, dimension, -0.02, 0.02);
                const Vector movement = sum_of(pass % 100 < 50 ? push : Vector{}, noise);
                position = wrapped(sum_of(position, allowed_displacement(domain, position, movement, i % 4 > 0)));
                ASSERT_GE(height_over(domain, position), -depth_allowed) << "pass " << pass;
            }
        }
    }
}

TEST(Domain, APointThatIsHeldDownDoesNotDriftIn)
{
    std::mt19937_64 random(5);
    for (int i = 0; i < 200; ++i) {
        const int dimension = 2 + i % 2;
        const HalfSpace half_space{random_direction(random, dimension), 0.1};
        const Domain domain{{{{0.5, 0.5, 0}, {half_space}}}, {}};
        Vector position = sum_of({0.5, 0.5, 0}, half_space.normal, 0.1);
        for (int pass = 0; pass < 2000; ++pass) {
            const Vector movement = sum_of(random_vector(random, dimension, -1e-3, 1e-3), half_space.normal, -0.01);
            position = sum_of(position, allowed_displacement(domain, position, movement, true));
            ASSERT_GE(height_over(domain, position), -rounding) << "pass " << pass;
        }
    }
}

TEST(Domain, PointsInsideLeaveButDoNotGetDeeper)
{
    std::mt19937_64 random(6);
    for (int i = 0; i < 4000; ++i) {
        const int dimension = 2 + i % 2;
        const Domain domain{{domain_of(dimension).forbidden[i / 2 % 3]}, {}};
        const Vector position = random_vector(random, dimension, 0, 1);
        const double before = height_over(domain, position);
        if (before > 0) continue;
        const Vector movement = random_vector(random, dimension, -0.1, 0.1);
        for (const bool slides : {false, true}) {
            const Vector moved = allowed_displacement(domain, position, movement, slides);
            EXPECT_GE(height_over(domain, sum_of(position, moved)), std::min(before, -depth_allowed) - rounding);
        }
    }
    const Domain square{{box_region({0.5, 0.5, 0}, {0.1, 0.1, 0}, 2)}, {}};
    EXPECT_EQ(allowed_displacement(square, {0.58, 0.5, 0}, {0.1, 0.01, 0}, false), (Vector{0.1, 0.01, 0}));
    EXPECT_EQ(allowed_displacement(square, {0.58, 0.5, 0}, {-0.1, 0.01, 0}, false), (Vector{}));
}

}
}
