// The map of HEALPix against numbers of healpy, its areas against a random sample, and its inverse.
#include "tiles/sphere/healpix.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace poissonlab {
namespace {

struct HealpyPixel
{
    std::uint32_t square;
    int x, y;
    UnitVector middle;
};

/// Pixels of 4096 x 4096 in each square, in its midst and at corners: xyf2pix_nest() and pix2vec_nest() of healpy
/// 1.16.1.
const std::vector<HealpyPixel> healpy_pixels{
    {0, 1938, 2096, {0.54915036320015687, 0.51684495599544322, 0.65673828125}},
    {0, 4095, 4095, {0.00014095465486374414, 0.00014095465486374412, 0.99999998013178504}},
    {0, 0, 4095, {0.74535597879762538, 0.00014292022070299613, 0.66666666666666663}},
    {1, 3093, 3893, {-0.062219826963578424, 0.23020579821455842, 0.97115085522333777}},
    {1, 4095, 4095, {-0.00014095465486374412, 0.00014095465486374414, 0.99999998013178504}},
    {1, 0, 4095, {-0.00014292022070288278, 0.74535597879762538, 0.66666666666666663}},
    {2, 142, 590, {-0.75970232312335861, -0.63923319881643692, 0.11930338541666666}},
    {2, 4095, 4095, {-0.00014095465486374414, -0.00014095465486374412, 0.99999998013178504}},
    {2, 0, 4095, {-0.74535597879762538, -0.00014292022070300263, 0.66666666666666663}},
    {3, 3370, 3885, {0.064268403066510327, -0.17429720203581542, 0.98259353637695312}},
    {3, 4095, 4095, {0.00014095465486374409, -0.00014095465486374414, 0.99999998013178504}},
    {3, 0, 4095, {0.00014292022070262601, -0.74535597879762538, 0.66666666666666663}},
    {4, 1020, 1277, {0.95506087526684103, -0.047102706476817802, -0.29264322916666663}},
    {4, 4095, 4095, {0.74550153786125162, 0, 0.66650390625}},
    {4, 0, 4095, {0.70724235421373427, -0.7069711821610658, 0}},
    {5, 3559, 1733, {-0.33644806209762967, 0.92132851106388836, 0.19482421875}},
    {5, 4095, 4095, {4.5648803605060558e-17, 0.74550153786125162, 0.66650390625}},
    {5, 0, 4095, {0.70697118216106547, 0.7072423542137346, 0}},
    {6, 1118, 3390, {-0.90454514311563727, 0.42104577977201635, 0.067220052083333329}},
    {6, 4095, 4095, {-0.74550153786125162, 9.1297607210121115e-17, 0.66650390625}},
    {6, 0, 4095, {-0.70724235421373438, 0.70697118216106569, 0}},
    {7, 1052, 1676, {-0.11637322731789589, -0.9679638004887624, -0.22249348958333331}},
    {7, 4095, 4095, {-1.3694641081518166e-16, -0.74550153786125162, 0.66650390625}},
    {7, 0, 4095, {-0.70697118216106569, -0.70724235421373427, 0}},
    {8, 2637, 2251, {0.55051142285137233, 0.63869079632061754, -0.53759765625}},
    {8, 0, 0, {0.00014095465486374414, 0.00014095465486374412, -0.99999998013178504}},
    {8, 0, 4095, {0.74535597879762538, 0.00014292022070299613, -0.66666666666666663}},
    {9, 351, 112, {-0.085774597570348221, 0.034344073762933212, -0.99572245279947913}},
    {9, 0, 0, {-0.00014095465486374412, 0.00014095465486374414, -0.99999998013178504}},
    {9, 0, 4095, {-0.00014292022070288278, 0.74535597879762538, -0.66666666666666663}},
    {10, 3545, 3086, {-0.62117002893032891, -0.74140367639338833, -0.25390625}},
    {10, 0, 0, {-0.00014095465486374414, -0.00014095465486374412, -0.99999998013178504}},
    {10, 0, 4095, {-0.74535597879762538, -0.00014292022070300263, -0.66666666666666663}},
    {11, 3431, 2204, {0.775190660702055, -0.47540555246670269, -0.416015625}},
    {11, 0, 0, {0.00014095465486374409, -0.00014095465486374414, -0.99999998013178504}},
    {11, 0, 4095, {0.00014292022070262601, -0.74535597879762538, -0.66666666666666663}},
};

constexpr double rounding = 1e-14;

TEST(Healpix, HasThePixelsOfHealpy)
{
    for (const HealpyPixel& pixel : healpy_pixels) {
        const HealpixPlace place{pixel.square, (pixel.x + 0.5) / 4096, (pixel.y + 0.5) / 4096};
        const UnitVector found = direction_of(sphere_place(place));
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_NEAR(found[k], pixel.middle[k], rounding) << pixel.square << " " << pixel.x << " " << pixel.y;
        const HealpixPlace back = healpix_place(place_of_direction(pixel.middle));
        EXPECT_EQ(back.square, pixel.square);
        EXPECT_NEAR(back.x, place.x, 1e-11);
        EXPECT_NEAR(back.y, place.y, 1e-11);
    }
}

/// Published heights of pixel centres (Gorski et al., equations 4 and 8) of 12 and of 48 pixels.
TEST(Healpix, HasThePublishedRings)
{
    const std::array<double, 3> one{2 / 3.0, 0, -2 / 3.0};
    for (std::uint32_t square = 0; square < 12; ++square)
        EXPECT_NEAR(sphere_place({square, 0.5, 0.5}).z, one.at(square / 4), rounding);
    EXPECT_NEAR(sphere_place({0, 0.75, 0.75}).z, 11 / 12.0, rounding);
    EXPECT_NEAR(sphere_place({0, 0.25, 0.75}).z, 2 / 3.0, rounding);
    EXPECT_NEAR(sphere_place({0, 0.25, 0.25}).z, 1 / 3.0, rounding);
    EXPECT_NEAR(sphere_place({4, 0.75, 0.25}).z, 0, rounding);
}

TEST(Healpix, InverseFindsEveryPlaceAgain)
{
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> part;
    for (int i = 0; i < 100'000; ++i) {
        // A third of the places lie on borders, or so near to poles and vertices that squares of cosines would be 1.
        const auto coordinate = [&] {
            const double c = part(random);
            return i % 3 > 0 ? c : c < 0.3 ? 0.0 : c < 0.6 ? 1.0 : c < 0.8 ? 1e-12 * c : 1 - 1e-9 * c;
        };
        const HealpixPlace place{static_cast<std::uint32_t>(random() % 12), coordinate(), coordinate()};
        const SpherePlace on_sphere = sphere_place(place);
        ASSERT_NEAR(on_sphere.z * on_sphere.z + on_sphere.away * on_sphere.away, 1, rounding);
        ASSERT_TRUE(on_sphere.turns >= 0 && on_sphere.turns < 1) << on_sphere.turns;
        const HealpixPlace back = healpix_place(on_sphere);
        ASSERT_TRUE(back.x >= 0 && back.x <= 1 && back.y >= 0 && back.y <= 1) << back.x << " " << back.y;
        const UnitVector first = direction_of(on_sphere), again = direction_of(sphere_place(back));
        for (std::size_t k = 0; k < 3; ++k) ASSERT_NEAR(first[k], again[k], rounding);
        if (i % 3 == 0) continue;
        ASSERT_EQ(back.square, place.square);
        ASSERT_NEAR(back.x, place.x, 1e-11); // longitudes near poles are rounded
        ASSERT_NEAR(back.y, place.y, 1e-11);
    }
    for (const double z : {1.0, -1.0}) {
        const HealpixPlace pole = healpix_place({z, 0, 0});
        EXPECT_EQ(sphere_place(pole).z, z);
        EXPECT_EQ(sphere_place(pole).away, 0);
    }
}

/// Random directions fall on all parts of squares equally often: chi-square over 12 x 8 x 8 parts.
TEST(Healpix, PartsOfSquaresHaveEqualAreas)
{
    std::mt19937_64 random(11);
    std::normal_distribution<double> normal;
    std::vector<double> counts(12 * 64);
    constexpr int darts = 768'000;
    for (int i = 0; i < darts; ++i) {
        UnitVector v{normal(random), normal(random), normal(random)};
        const double length = std::hypot(v[0], v[1], v[2]);
        for (double& c : v) c /= length;
        const HealpixPlace place = healpix_place(place_of_direction(v));
        const auto cell = [](double c) { return std::min(7, static_cast<int>(8 * c)); };
        ++counts[place.square * 64 + static_cast<std::size_t>(8 * cell(place.y) + cell(place.x))];
    }
    double chi_square = 0;
    for (const double count : counts) chi_square += std::pow(count - darts / 768.0, 2) / (darts / 768.0);
    EXPECT_NEAR(chi_square, 767, 4 * std::sqrt(2 * 767.0));
}

/// The areas of small quads and their least stretch, by differences: no area differs, and the stretch is reached.
TEST(Healpix, HasOneJacobianAndTheStatedStretch)
{
    double least = 2;
    constexpr int steps = 64;
    constexpr double h = 1e-6;
    for (std::uint32_t square = 0; square < 12; ++square)
        for (int i = 0; i < steps * steps; ++i) {
            const double x = (i % steps + 0.5) / steps, y = (static_cast<double>(i / steps) + 0.5) / steps;
            if (square % 8 < 4 && std::abs(x + y - 1) < 1e-3) continue; // the border of a cap
            const auto slope = [&](double dx, double dy) {
                const UnitVector a = direction_of(sphere_place({square, x - dx, y - dy})),
                                 b = direction_of(sphere_place({square, x + dx, y + dy}));
                UnitVector d{};
                for (std::size_t k = 0; k < 3; ++k) d[k] = (b[k] - a[k]) / (2 * h);
                return d;
            };
            const UnitVector u = slope(h, 0), v = slope(0, h);
            const auto dot = [](const UnitVector& a, const UnitVector& b) {
                return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
            };
            const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v);
            ASSERT_NEAR(std::sqrt(uu * vv - uv * uv), std::numbers::pi / 3, 1e-8);
            const double half = (uu + vv) / 2, squared = half - std::sqrt(half * half - (uu * vv - uv * uv));
            ASSERT_GT(std::sqrt(squared), least_healpix_stretch() - 1e-8);
            least = std::min(least, std::sqrt(squared));
        }
    EXPECT_NEAR(least, least_healpix_stretch(), 0.005); // the places nearest to the pole are a 128th from it
}

/// Places beyond each side continue on the sphere: the map is continuous across all 24 borders, in all directions.
TEST(Healpix, SquaresFitAcrossTheirSides)
{
    constexpr std::int64_t side = 1 << 20;
    for (std::uint32_t square = 0; square < 12; ++square)
        for (std::int64_t along = 1; along < side; along += side / 16)
            for (const LatticePlace& place : {LatticePlace{-1, along}, LatticePlace{side + 1, along},
                                              LatticePlace{along, -1}, LatticePlace{along, side + 1}}) {
                const SeenSquare seen = square_around(square, place, side, true);
                EXPECT_NE(seen.square, square);
                const LatticePlace moved = turned(seen.pose.turn, place) + side * seen.pose.shift;
                ASSERT_TRUE(moved.x >= 0 && moved.x <= side && moved.y >= 0 && moved.y <= side);
                const auto direction = [](std::uint32_t of, const LatticePlace& at) {
                    return direction_of(
                        sphere_place({of, static_cast<double>(at.x) / side, static_cast<double>(at.y) / side}));
                };
                const LatticePlace inside{std::clamp<std::int64_t>(place.x, 0, side),
                                          std::clamp<std::int64_t>(place.y, 0, side)};
                const UnitVector a = direction(square, inside), b = direction(seen.square, moved);
                // A unit across becomes no more than the greatest stretch: the area over the least one.
                EXPECT_LT(std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]),
                          std::numbers::pi / 3 / least_healpix_stretch() / side * 1.0001);
            }
}

/// The squares meet at 14 vertices: eight of them have three squares each, and six have four.
TEST(Healpix, HasEightVerticesOfThreeSquares)
{
    int corners_of_three = 0;
    for (std::uint32_t square = 0; square < 12; ++square)
        for (const LatticePlace& place :
             {LatticePlace{-1, -1}, LatticePlace{-1, 9}, LatticePlace{9, -1}, LatticePlace{9, 9}})
            corners_of_three += square_around(square, place, 8, true) != square_around(square, place, 8, false);
    EXPECT_EQ(corners_of_three, 8 * 3);
}

}
}
