// What tiles are asked for when they are moved together, held against differences and direct sums.
#include "host/tile_construction/joint/joint_moments.hpp"
#include "host/tile_construction/joint/tile_conditions.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <random>

namespace poissonlab {
namespace {

using namespace std::complex_literals;

PoissonTileParameters parameters_with(TileBorder border)
{
    PoissonTileParameters p;
    p.dimension = 2;
    p.tiles = 6;
    p.points_per_tile = 40;
    p.equal_moments = 2;
    p.border = border;
    return p;
}

TEST(TileConditions, HaveTheSlopesOfTheirValues)
{
    const TileConditions conditions(parameters_with(TileBorder::chain));
    EXPECT_EQ(conditions.count(), 5U + 2 * 16);
    constexpr double step = 1e-5; // differences are right to step squared times third derivatives, below 5 pi / 4 cubed
    for (const TileConditions::Position at :
         {TileConditions::Position{0.3, -0.8, 0}, {-1.05, 0.1, 0}, {0.9, 0.95, 0}}) {
        std::vector<double> slopes(2 * conditions.count()), above(conditions.count()), below(conditions.count());
        conditions.slopes(at, slopes);
        for (std::size_t axis = 0; axis < 2; ++axis) {
            TileConditions::Position up = at, down = at;
            up[axis] += step;
            down[axis] -= step;
            conditions.values(up, above);
            conditions.values(down, below);
            for (std::size_t c = 0; c < conditions.count(); ++c)
                EXPECT_NEAR(slopes[axis * conditions.count() + c], (above[c] - below[c]) / (2 * step), 1e-8) << c;
        }
    }
}

class TileMovement : public testing::Test
{
protected:
    /// Tiles of points of their own, all pushed along a field that suits none of them. Corners of squares around the
    /// middle, which have a size and any turn, have equal moments.
    TileMovement()
    {
        std::mt19937 random(5);
        std::uniform_real_distribution<double> turn(0, 2 * std::numbers::pi);
        for (std::uint32_t tile = 0; tile < tiles; ++tile) {
            std::vector<UnitPosition> inside;
            for (std::size_t square = 0; square < points / 4; ++square) {
                const std::complex<double> corner =
                    std::polar((0.05 + 0.05 * static_cast<double>(square)) * tile_units, turn(random));
                for (const std::complex<double> at : {corner, corner * 1i, -corner, corner * -1i})
                    inside.push_back({from_middle(at.real()), from_middle(at.imag()), 0});
            }
            stored_.add(inside, 1.0 / tiles, true);
        }
        for (const WeightedPoint& point : stored_.mean_tile())
            pushed_.push_back(
                {300 * std::sin(0.0004 * point.position[1]), 300 * std::cos(0.0003 * point.position[0]), 0});
    }

    std::vector<Displacement> evened(TileBorder border) const
    {
        std::vector<Displacement> result = pushed_;
        add_moment_step(
            result, stored_,
            [&](std::uint32_t tile) {
                std::vector<OwnPoint> own;
                for (std::size_t i = stored_.first(tile); i < stored_.end(tile); ++i)
                    own.push_back({static_cast<std::uint32_t>(i), {}});
                return own;
            },
            parameters_with(border));
        return result;
    }

    /// The mean square, over tiles and frequencies from 0.7 to 1.5 cycles a tile, of how the change of a tile's
    /// transform differs from the mean change.
    double spread_of_changes(const std::vector<Displacement>& displacements) const
    {
        double sum = 0;
        int count = 0;
        for (const double u : {-1.2, -0.7, 0.0, 0.7, 1.2})
            for (const double v : {0.7, 0.9}) {
                std::vector<std::complex<double>> changes;
                std::complex<double> mean = 0;
                for (std::uint32_t tile = 0; tile < tiles; ++tile) {
                    changes.push_back(transform(tile, u, v, displacements) - transform(tile, u, v, no_movement()));
                    mean += changes.back() / double{tiles};
                }
                for (const auto& change : changes) sum += std::norm(change - mean);
                count += tiles;
            }
        return sum / count;
    }

    double second_moment(std::uint32_t tile, const std::vector<Displacement>& displacements) const
    {
        double sum = 0;
        for (std::size_t i = stored_.first(tile); i < stored_.end(tile); ++i)
            sum += std::pow((stored_.mean_tile()[i].position[0] + displacements[i][0]) / tile_units - 0.5, 2);
        return sum;
    }

    std::vector<Displacement> no_movement() const { return std::vector<Displacement>(stored_.count()); }

    static std::int32_t from_middle(double x) { return tile_units / 2 + static_cast<std::int32_t>(std::lround(x)); }

    static constexpr std::uint32_t tiles = 6;
    static constexpr std::size_t points = 40;
    StoredPoints stored_;
    std::vector<Displacement> pushed_;

private:
    std::complex<double> transform(std::uint32_t tile, double u, double v, const std::vector<Displacement>& by) const
    {
        std::complex<double> sum = 0;
        for (std::size_t i = stored_.first(tile); i < stored_.end(tile); ++i) {
            const auto& at = stored_.mean_tile()[i].position;
            sum +=
                std::polar(1.0, -2 * std::numbers::pi * (u * (at[0] + by[i][0]) + v * (at[1] + by[i][1])) / tile_units);
        }
        return sum;
    }
};

TEST_F(TileMovement, HoldsLowWavesOfTilesWithChains)
{
    const double free = spread_of_changes(evened(TileBorder::strip)),
                 held = spread_of_changes(evened(TileBorder::chain));
    EXPECT_LT(held, free / 3);
}

TEST_F(TileMovement, BringsMomentsTogether)
{
    for (const TileBorder border : {TileBorder::strip, TileBorder::chain}) {
        const auto spread = [&](const std::vector<Displacement>& displacements) {
            double least = 1e9, most = -1e9;
            for (std::uint32_t tile = 0; tile < tiles; ++tile) {
                least = std::min(least, second_moment(tile, displacements));
                most = std::max(most, second_moment(tile, displacements));
            }
            return most - least;
        };
        EXPECT_LT(spread(evened(border)), 0.1 * spread(pushed_)); // a step, of what is not linear
    }
}

}
}
