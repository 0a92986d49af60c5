// The table on whose cloth objects are seen, and the noise of their colours.
#include "host/distribution/objects.hpp"
#include "kernels/common/fields/object_views.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

namespace poissonlab {
namespace {

using namespace contract::objects;

/// The cloth of figure 7.14: the rays of its view meet the surfaces that are known. On the top, coordinates are the
/// place of a perspective picture, which gnomonic equations give; on the hanging part the way from the axis is the
/// radius of the table and the drop, and folds stretch a circle of the cloth by less than a fifth.
TEST(ObjectViews, OfTheTableAreAClothOnItsFloor)
{
    int on_top = 0, hanging = 0, on_floor = 0;
    for (int i = -100; i <= 100; ++i)
        for (int j = -100; j <= 100; ++j) {
            const float x = static_cast<float>(i) / 100, y = static_cast<float>(j) / 100;
            const SurfacePlace cloth = surface_place(VIEW_CLOTH, x, y), floor = surface_place(VIEW_FLOOR, x, y);
            ASSERT_EQ(cloth.is_there + floor.is_there, 1) << i << " " << j; // there is no sky
            // A place (X, Y, Z) is seen at its sideways and upward parts over its part ahead.
            const double fall = (1.75 - 0.36) / 2.6, flat = 1 / std::hypot(1, fall);
            const SurfacePlace& seen = cloth.is_there ? cloth : floor;
            const bool is_top = cloth.is_there && std::hypot(cloth.x, cloth.y) <= 0.6;
            const double away = std::hypot(seen.x, seen.y), drop = cloth.is_there && !is_top ? away - 0.6 : 0;
            double px = seen.x, py = seen.y;
            if (drop > 0) {
                const double direction = std::atan2(py, px),
                             radius = 0.6 + drop * (0.16 + 0.19 * std::cos(12 * direction));
                px *= radius / away, py *= radius / away;
                ASSERT_LE(drop, 0.5801);
                ++hanging;
            }
            const double pz = (cloth.is_there ? 0.75 - drop : 0) - 1.75, ahead = flat * (py + 2.6) - fall * flat * pz;
            ASSERT_NEAR(px / ahead, 0.42 * x, 2e-4) << i << " " << j;
            ASSERT_NEAR((fall * flat * (py + 2.6) + flat * pz) / ahead, 0.42 * y, 2e-4) << i << " " << j;
            on_top += is_top, on_floor += floor.is_there != 0;
        }
    EXPECT_GT(on_top, 2000);
    EXPECT_GT(hanging, 2000);
    EXPECT_GT(on_floor, 2000);
    for (const double drop : {0.1, 0.3, 0.58}) {
        double length = 0;
        for (int i = 0; i < 36'000; ++i) {
            const auto place = [&](int step) {
                const double t = 2 * std::numbers::pi * step / 36'000;
                const double r = cloth_radius(static_cast<float>(std::cos(t)), static_cast<float>(std::sin(t)),
                                              static_cast<float>(drop));
                return std::array{r * std::cos(t), r * std::sin(t)};
            };
            const auto a = place(i), b = place(i + 1);
            length += std::hypot(a[0] - b[0], a[1] - b[1]);
        }
        EXPECT_NEAR(length / (2 * std::numbers::pi * (0.6 + drop)), 1, 0.2) << drop;
    }
}

/// Noise by a direct form of Perlin's article: the slopes of the edges of a cube, blended by its polynomial of
/// degree 5.
TEST(ObjectLooks, HavePerlinsNoise)
{
    const double slopes[16][3] = {{1, 1, 0},  {-1, 1, 0},  {1, -1, 0}, {-1, -1, 0}, {1, 0, 1},  {-1, 0, 1},
                                  {1, 0, -1}, {-1, 0, -1}, {0, 1, 1},  {0, -1, 1},  {0, 1, -1}, {0, -1, -1},
                                  {1, 1, 0},  {0, -1, 1},  {-1, 1, 0}, {0, -1, -1}};
    std::mt19937 random(5);
    double least = 1, most = 0;
    for (int n = 0; n < 20'000; ++n) {
        double at[3], sum = 0;
        for (double& x : at) x = static_cast<double>(random() % (1 << 18)) / (1 << 12) - 32;
        for (int corner = 0; corner < 8; ++corner) {
            std::uint32_t bits = 0;
            double weight = 1, way[3];
            for (int a = 0; a < 3; ++a) {
                const double low = std::floor(at[a]), part = at[a] - low;
                const int up = corner >> a & 1;
                const auto lattice = static_cast<std::uint32_t>(static_cast<std::int32_t>(low) + up);
                bits = a == 0 ? lattice : pobjects_bits(bits, lattice);
                way[a] = part - up;
                const double blend = part * part * part * (part * (part * 6 - 15) + 10);
                weight *= up ? blend : 1 - blend;
            }
            const double* slope = slopes[bits >> 28];
            sum += weight * (slope[0] * way[0] + slope[1] * way[1] + slope[2] * way[2]);
        }
        const float found =
            smooth_noise(static_cast<float>(at[0]), static_cast<float>(at[1]), static_cast<float>(at[2]));
        ASSERT_NEAR(found, (sum + 1) / 2, 1e-5);
        least = std::min<double>(least, found), most = std::max<double>(most, found);
    }
    EXPECT_LT(least, 0.1);
    EXPECT_GT(most, 0.9);
}

}
}
