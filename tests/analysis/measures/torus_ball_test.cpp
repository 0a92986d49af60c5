#include "analysis/measures/torus_ball.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace poissonlab {
namespace {

/// Simpson's rule on n (even) intervals.
long double simpson(const std::function<long double(long double)>& f, long double a, long double b, int n)
{
    long double sum = f(a) + f(b);
    for (int i = 1; i < n; ++i) sum += (i % 2 == 1 ? 4 : 2) * f(a + (b - a) * i / n);
    return sum * (b - a) / n / 3;
}

/// The part of the square in the disk of radius r, by columns: x = r sin t takes the root out of the integrand.
double disk_by_columns(double r, int n)
{
    const auto column = [&](long double t) { return std::min(1.0L, 2 * r * std::cos(t)) * r * std::cos(t); };
    // Columns are cut off where r cos t > 1/2: integrate both sides of that kink apart.
    const long double end = r <= 0.5 ? std::numbers::pi_v<long double> / 2 : std::asin(0.5L / r);
    const long double kink = r <= 0.5 ? 0 : std::min(end, std::acos(0.5L / r));
    return static_cast<double>(2 * (simpson(column, 0, kink, n) + simpson(column, kink, end, n)));
}

/// The part of the cube in the ball, by slices.
double ball_by_slices(double r, int n)
{
    const auto slice = [&](long double z) {
        const double rho = std::sqrt(std::max(static_cast<double>(r * r - z * z), 0.0));
        return static_cast<long double>(rho > std::sqrt(0.5) ? 1.0 : disk_by_columns(rho, 200));
    };
    const long double end = std::min(0.5L, static_cast<long double>(r));
    long double sum = 0, from = 0;
    for (const double kink : {0.5, 0.25}) { // rho^2 = 1/2 and rho^2 = 1/4
        const long double to = std::sqrt(std::max(static_cast<long double>(r) * r - kink, 0.0L));
        if (to <= from || to >= end) continue;
        sum += simpson(slice, from, to, n);
        from = to;
    }
    return static_cast<double>(2 * (sum + simpson(slice, from, end, n)));
}

TEST(TorusBall, IsTheWholeBallWhereItDoesNotReachItself)
{
    EXPECT_DOUBLE_EQ(torus_ball_volume(0.25, 2), std::numbers::pi / 16);
    EXPECT_DOUBLE_EQ(torus_ball_volume(0.5, 3), std::numbers::pi / 6);
    EXPECT_EQ(torus_ball_volume(0, 2), 0);
    EXPECT_EQ(torus_ball_volume(-1, 3), 0);
    for (const int d : {2, 3}) {
        EXPECT_EQ(torus_ball_volume(std::sqrt(d) / 2, d), 1);
        EXPECT_EQ(torus_ball_volume(5, d), 1);
    }
}

TEST(TorusBall, AgreesWithColumnsAndSlices)
{
    // Away from the kinks the integrands are smooth, but for square roots at the ends of slices: there
    // Simpson's rule converges as n^-1.5, to some 1e-6 for 1,000 intervals.
    for (int i = 1; i < 28; ++i) {
        const double r = i / 40.0;
        EXPECT_NEAR(torus_ball_volume(r, 2), disk_by_columns(r, 2000), 1e-12) << r;
    }
    for (int i = 1; i < 35; ++i) {
        const double r = i / 40.0;
        EXPECT_NEAR(torus_ball_volume(r, 3), ball_by_slices(r, 400), 1e-5) << r;
    }
}

TEST(TorusBall, HasTheMomentsOfTheDistanceInACube)
{
    // E[R^p] = rmax^p - int p r^(p-1) V(r) dr for a uniform position in the unit cube about 0. Closed forms:
    // E[R^2] = d/12, E[R^4] = d/80 + d (d - 1)/144; E[R] = (sqrt 2 + ln(1 + sqrt 2))/6 in 2D and, in 3D,
    // sqrt 3/8 + ln(2 + sqrt 3)/4 - pi/48 (half of the mean distance from the centre of a cube of side 2).
    for (const int d : {2, 3}) {
        const double end = largest_toroidal_distance(d);
        const auto moment = [&](int p) {
            const auto f = [&](long double r) {
                return p * std::pow(r, p - 1.0L) * torus_ball_volume(static_cast<double>(r), d);
            };
            const long double middle = std::min(std::sqrt(0.5), end);
            const long double whole = simpson(f, 0, 0.5, 2000) + simpson(f, 0.5, middle, 20000) +
                                      (d == 3 ? simpson(f, middle, end, 20000) : 0);
            return static_cast<double>(std::pow(static_cast<long double>(end), p) - whole);
        };
        // V has the term (r - 1/2)^1.5 in 2D: Simpson's error is some n^-2.5 = 2e-11.
        EXPECT_NEAR(moment(2), d / 12.0, 1e-10);
        EXPECT_NEAR(moment(4), d / 80.0 + d * (d - 1) / 144.0, 1e-10);
        const double mean = d == 2 ? (std::sqrt(2.0) + std::log(1 + std::sqrt(2.0))) / 6
                                   : std::sqrt(3.0) / 8 + std::log(2 + std::sqrt(3.0)) / 4 - std::numbers::pi / 48;
        EXPECT_NEAR(moment(1), mean, 1e-10);
    }
}

TEST(TorusBall, IsContinuousWhereTheFormsMeet)
{
    for (const int d : {2, 3}) {
        for (const double r : {0.5, std::sqrt(0.5), std::sqrt(0.75)}) {
            // V' is at most 4 pi r^2 < 10.
            EXPECT_NEAR(torus_ball_volume(r - 1e-12, d), torus_ball_volume(r + 1e-12, d), 3e-11);
        }
    }
}

}
}
