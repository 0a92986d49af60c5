// The torus on which all tiles of a set are relaxed together, and nulling: kernel against plain twin, and against
// what the gradient of the mean tile's power is.
#include "host/tile_construction/joint/joint_relaxation.hpp"

#include "host/tile_construction/joint/joint_tiling.hpp"
#include "tests/support/small_tile_sets.hpp"
#include "tiles/poisson/tile_pieces.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <map>
#include <numbers>
#include <random>

namespace poissonlab {
namespace {

class JointTiling : public testing::TestWithParam<SmallSet>
{
protected:
    const PoissonTileParameters& p_ = GetParam().parameters;
    const std::uint32_t side_ = joint_side(p_);
};

TEST_P(JointTiling, ShowsEveryTile)
{
    std::map<std::uint32_t, int> counts;
    for (const std::uint32_t tile : joint_tiling(p_, 3)) ++counts[tile];
    EXPECT_EQ(counts.size(), p_.tiles);
    if (p_.tiles > 1) {
        EXPECT_NE(joint_tiling(p_, 3), joint_tiling(p_, 4));
    }
}

/// The pieces around each tile that are at the same place on the torus are the same.
TEST_P(JointTiling, HasTilesThatFitTogether)
{
    const auto tiles = joint_tiling(p_, 0);
    std::map<std::array<std::uint32_t, 4>, std::uint32_t> variants; // by axes and place
    for (std::uint32_t i = 0; i < tiles.size(); ++i) {
        const std::array<std::uint32_t, 3> at{i % side_, i / side_ % side_, i / side_ / side_};
        for (const PlacedPiece& piece : pieces_around(p_, tiles[i])) {
            std::array<std::uint32_t, 4> key{piece.axes};
            for (std::size_t k = 0; k < 3; ++k)
                key[k + 1] = (at[k] + static_cast<std::uint32_t>(piece.base[k])) % side_;
            EXPECT_EQ(variants.emplace(key, piece.variant).first->second, piece.variant);
        }
    }
    EXPECT_EQ(variants.size(), tiles.size() * ((1u << p_.dimension) - 1));
}

constexpr auto corner_chains = PoissonTileKind::corner;

INSTANTIATE_TEST_SUITE_P(Sets, JointTiling,
                         testing::Values(SmallSet{"corner_2", tile_set_parameters(corner_chains, 2, 2, 32, 0.75)},
                                         SmallSet{"corner_4", tile_set_parameters(corner_chains, 2, 4, 32, 0.75)},
                                         SmallSet{"sphere", tile_set_parameters(corner_chains, 3, 2, 32, 0.5)},
                                         SmallSet{"edge", tile_set_parameters(PoissonTileKind::edge, 2, 2, 32, 0.75)},
                                         SmallSet{"template",
                                                  tile_set_parameters(PoissonTileKind::frame, 2, 50, 32, 0.75)}),
                         [](const auto& sets) { return sets.param.name; });

class JointNulling : public testing::TestWithParam<int>
{
protected:
    static constexpr std::uint32_t points_per_tile = 32;
    static constexpr double longest = 200;

    std::vector<WeightedPoint> points() const
    {
        std::mt19937 random(4);
        const auto coordinate = [&] { return static_cast<std::int32_t>(random() % 98304) - 16384; };
        std::vector<WeightedPoint> all;
        for (int i = 0; i < 300; ++i) {
            const std::int32_t x = coordinate(), y = coordinate(), z = dimension_ == 3 ? coordinate() : 0;
            all.push_back({{x, y, z}, i < 10 ? 0.25 : 0.01, i >= 10});
        }
        return all;
    }

    const int dimension_ = GetParam();
    const std::vector<TileFrequency> frequencies = nulled_frequencies(points_per_tile, dimension_);
};

TEST_P(JointNulling, KernelAndTwinMoveAlike)
{
    const auto by_kernel =
        make_joint_engine(dimension_, Device::open(), 7)->nulling_displacements(points(), frequencies, longest);
    EXPECT_EQ(by_kernel,
              reference::make_joint_engine(dimension_)->nulling_displacements(points(), frequencies, longest));
    for (std::size_t i = 0; i < by_kernel.size(); ++i)
        EXPECT_LE(std::hypot(by_kernel[i][0], by_kernel[i][1], by_kernel[i][2]), i < 10 ? 0 : longest + 0.0001);
}

/// The power that nulling lowers: sum |F(k)|^2 / |k|^2 over 0 < |k|^2 <= 4 N^(2 / dimension), here of all points.
double weighted_power(const std::vector<WeightedPoint>& points, int dimension, std::uint32_t points_per_tile)
{
    const double end = 4 * std::pow(points_per_tile, 2.0 / dimension);
    const int reach = static_cast<int>(std::sqrt(end)), slices = dimension == 3 ? reach : 0;
    double sum = 0;
    for (int z = -slices; z <= slices; ++z)
        for (int y = -reach; y <= reach; ++y)
            for (int x = -reach; x <= reach; ++x) {
                const int squared = x * x + y * y + z * z;
                if (squared == 0 || squared > end) continue;
                std::complex<double> transform = 0;
                for (const WeightedPoint& point : points) {
                    const std::array<int, 3> f{x, y, z};
                    double turns = 0;
                    for (std::size_t k = 0; k < 3; ++k) turns += 1.0 * f[k] * point.position[k] / tile_units;
                    transform += point.weight * std::polar(1.0, -2 * std::numbers::pi * turns);
                }
                sum += std::norm(transform) / squared;
            }
    return sum;
}

TEST_P(JointNulling, GoesDownTheGradient)
{
    std::vector<WeightedPoint> all = points();
    const double before = weighted_power(all, dimension_, points_per_tile);
    const auto moves = reference::make_joint_engine(dimension_)->nulling_displacements(all, frequencies, 1e9);
    // The direction is that of steepest descent: movement and weight are in proportion to the derivative, which
    // differences over 64 units tell to some parts in a thousand.
    constexpr std::int32_t step = 32;
    double product = 0, moved = 0, sloped = 0;
    for (const std::size_t i : {20u, 100u, 250u})
        for (std::size_t k = 0; k < static_cast<std::size_t>(dimension_); ++k) {
            auto there = all, back = all;
            there[i].position[k] += step;
            back[i].position[k] -= step;
            const double slope =
                weighted_power(there, dimension_, points_per_tile) - weighted_power(back, dimension_, points_per_tile);
            product -= slope * moves[i][k];
            moved += moves[i][k] * moves[i][k];
            sloped += slope * slope;
        }
    EXPECT_GT(product / std::sqrt(moved * sloped), 0.999);
    for (std::size_t i = 0; i < all.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k)
            all[i].position[k] += static_cast<std::int32_t>(std::nearbyint(moves[i][k]));
    EXPECT_LT(weighted_power(all, dimension_, points_per_tile), before);
}

INSTANTIATE_TEST_SUITE_P(Dimensions, JointNulling, testing::Values(2, 3));

}
}
