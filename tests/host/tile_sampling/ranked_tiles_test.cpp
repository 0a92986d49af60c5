// Every part of a ranked tile set is even in every tiling: by the definition of the power spectrum.
#include "host/tile_sampling/tile_set_cache.hpp"
#include "tests/support/small_tile_sets.hpp"
#include "tiles/poisson/tile_lookup.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <numbers>

namespace poissonlab {
namespace {

using PlaceOnTorus = std::array<double, 3>;

/// The points of a tiling that closes after `period` tiles with a level below the density, in [0, 1).
std::vector<PlaceOnTorus> tiling_points(const PoissonTileSet& set, std::uint32_t seed, int period, double density)
{
    const ptiles_tiling tiling = runtime_tiling(set, {seed, period});
    std::vector<PlaceOnTorus> points;
    const int layers = set.parameters.dimension == 3 ? period : 1;
    for (std::int32_t k = 0; k < layers; ++k)
        for (std::int32_t j = 0; j < period; ++j)
            for (std::int32_t i = 0; i < period; ++i) {
                const std::int32_t place[] = {i, j, k};
                const std::uint16_t* numbers = ptiles_points(&tiling.set, ptiles_tile(&tiling, i, j, k));
                for (std::uint32_t n = 0; n < tiling.set.points_per_tile; ++n, numbers += tiling.set.dimension) {
                    const ptiles_point point = ptiles_point_at(&tiling, place, n, numbers);
                    if (point.level >= density) continue;
                    points.push_back({point.position[0] / period, point.position[1] / period,
                                      set.parameters.dimension == 3 ? point.position[2] / period : 0});
                }
            }
    return points;
}

using Wave = std::vector<std::complex<double>>; // its values at all points

/// exp(-2 pi i k x) at the points' places x along an axis, for k from -reach to reach.
std::vector<Wave> waves_along(std::size_t axis, const std::vector<PlaceOnTorus>& points, int reach)
{
    std::vector<Wave> waves;
    for (int k = -reach; k <= reach; ++k) {
        waves.emplace_back();
        for (const PlaceOnTorus& place : points)
            waves.back().push_back(std::polar(1.0, -2 * std::numbers::pi * k * place[axis]));
    }
    return waves;
}

/// The power of the points at the frequency whose waves along the axes are given.
double power_at(const Wave& x, const Wave& y, const Wave& z)
{
    std::complex<double> transform = 0;
    for (std::size_t i = 0; i < x.size(); ++i) transform += x[i] * y[i] * z[i];
    return std::norm(transform) / static_cast<double>(x.size());
}

/// The mean power over frequencies below half the principal frequency of as many points, by the definition.
double low_power(const std::vector<PlaceOnTorus>& points, int dimension)
{
    // Distances of hexagonal lattices, and of face-centred cubic ones.
    const auto n = static_cast<double>(points.size());
    const double principal = dimension == 2 ? std::sqrt(2 / std::sqrt(3.0) * n) : std::sqrt(3.0) * std::cbrt(n / 4);
    const int reach = static_cast<int>(principal / 2), layers = dimension == 3 ? reach : 0;
    const auto along_x = waves_along(0, points, reach), along_y = waves_along(1, points, reach),
               along_z = waves_along(2, points, layers);
    double sum = 0;
    int count = 0;
    for (int x = 0; x <= reach; ++x)
        for (int y = -reach; y <= reach; ++y)
            for (int z = -layers; z <= layers; ++z) {
                const bool is_first_of_two = x > 0 || y > 0 || (y == 0 && z > 0);
                if (!is_first_of_two || x * x + y * y + z * z >= principal * principal / 4) continue;
                sum += power_at(along_x[reach + x], along_y[reach + y], along_z[layers + z]);
                ++count;
            }
    return sum / count;
}

struct RankedCase
{
    const char* name;
    PoissonTileParameters parameters;
    int period; ///< of the tilings that are looked at
};

void PrintTo(const RankedCase& c, std::ostream* out) { *out << c.name; }

PoissonTileParameters ranked(PoissonTileParameters p, TileBorder border = TileBorder::strip)
{
    p.ranked = true;
    if (border == TileBorder::chain) set_border(p, border, 8);
    return p;
}

class RankedTiles : public testing::TestWithParam<RankedCase>
{
};

/// A random order leaves 1 - f + f P of the whole tiling's power P, ranks at most half of that. They leave least room
/// at three quarters, where holes are single points.
TEST_P(RankedTiles, AreEvenAtAnyDensity)
{
    const RankedCase& c = GetParam();
    const PoissonTileParameters& p = c.parameters;
    Device device = Device::open();
    const PoissonTileSet set = build_tile_set(p, Engine::opencl, [&]() -> Device& { return device; }).set;
    const auto tiles = static_cast<std::size_t>(std::pow(c.period, p.dimension));
    constexpr std::uint32_t tilings = 4;
    double whole = 0;
    for (std::uint32_t seed = 1; seed <= tilings; ++seed)
        whole += low_power(tiling_points(set, seed, c.period, 1), p.dimension) / tilings;
    for (const double density : {0.25, 0.5, 0.75}) {
        double part = 0;
        for (std::uint32_t seed = 1; seed <= tilings; ++seed) {
            const auto points = tiling_points(set, seed, c.period, density);
            EXPECT_EQ(points.size(), tiles * static_cast<std::size_t>(std::lround(density * p.points_per_tile)));
            part += low_power(points, p.dimension) / tilings;
        }
        EXPECT_LT(part, (1 - density + density * whole) / 2) << "at the density " << density;
    }
}

const RankedCase ranked_cases[] = {
    {"chains", ranked(tile_set_parameters(PoissonTileKind::corner, 2, 3, 32, 0.75), TileBorder::chain), 12},
    {"strips", ranked(tile_set_parameters(PoissonTileKind::corner, 2, 3, 32, 0.75)), 12},
    {"edges", ranked(tile_set_parameters(PoissonTileKind::edge, 2, 2, 32, 0.7)), 12},
    {"templates", ranked(tile_set_parameters(PoissonTileKind::frame, 2, 16, 32, 0.75)), 12},
    {"spheres", ranked(tile_set_parameters(PoissonTileKind::corner, 3, 2, 64, 0.7)), 4},
};

INSTANTIATE_TEST_SUITE_P(Kinds, RankedTiles, testing::ValuesIn(ranked_cases),
                         [](const auto& test) { return std::string(test.param.name); });

}
}
