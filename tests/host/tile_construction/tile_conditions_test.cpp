// The conditions of tiles that are moved together, held against differences and direct sums.
#include "host/tile_construction/joint/joint_moments.hpp"
#include "host/tile_construction/joint/tile_conditions.hpp"

#include <Eigen/Dense>
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
    constexpr double step =
        1e-5; // differences are right to step squared times third derivatives, below (3 pi / 2) cubed
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

/// Tiles with points that others have, too, at another place, and with points that do not move.
class SharedMovement : public testing::TestWithParam<TileBorder>
{
protected:
    SharedMovement()
    {
        std::mt19937 random(9);
        std::uniform_int_distribution<std::int32_t> place(0, tile_units - 1);
        const auto add = [&](std::size_t count, bool moves) {
            std::vector<UnitPosition> points;
            for (std::size_t i = 0; i < count; ++i) points.push_back({place(random), place(random), 0});
            stored_.add(points, 1, moves);
        };
        for (std::uint32_t tile = 0; tile < p_.tiles; ++tile) add(90, true); // insides
        add(6, true);                                                        // what all have, at its left and right
        add(4, false);
        std::normal_distribution<double> push(0, 100);
        for (std::size_t i = 0; i < stored_.count(); ++i)
            pushed_.push_back(stored_.mean_tile()[i].moves ? Displacement{push(random), push(random), 0}
                                                           : Displacement{});
        for (std::uint32_t tile = 0; tile < p_.tiles; ++tile) {
            own_.emplace_back();
            add_own(tile, tile, {});
            add_own(tile, p_.tiles, {});
            if (tile % 2 == 0) add_own(tile, p_.tiles, {1, 0, 0});
            add_own(tile, p_.tiles + 1, {});
        }
    }

    void add_own(std::uint32_t tile, std::size_t piece, const std::array<std::int8_t, 3>& base)
    {
        for (std::size_t i = stored_.first(piece); i < stored_.end(piece); ++i)
            own_[tile].push_back({static_cast<std::uint32_t>(i), base});
    }

    PoissonTileParameters p_ = parameters_with(GetParam());
    StoredPoints stored_;
    std::vector<Displacement> pushed_;
    std::vector<std::vector<OwnPoint>> own_;
};

/// The least movement is W^-1 A' m with (A W^-1 A' + S) m = b, where W is how many tiles have a point. By dense
/// matrices: what is found has this form, and b is left to a thousandth at most, squared, in the norm of the tiles by
/// themselves.
TEST_P(SharedMovement, IsTheLeastThatConditionsAllow)
{
    const TileConditions conditions(p_);
    const auto count = static_cast<Eigen::Index>(conditions.count());
    const Eigen::Index rows = count * p_.tiles, columns = 2 * static_cast<Eigen::Index>(stored_.count());
    Eigen::MatrixXd slopes = Eigen::MatrixXd::Zero(rows, columns);
    Eigen::VectorXd lacking = Eigen::VectorXd::Zero(rows), owners = Eigen::VectorXd::Zero(columns);
    Eigen::MatrixXd by_themselves = Eigen::MatrixXd::Zero(rows, rows);
    for (std::uint32_t tile = 0; tile < p_.tiles; ++tile)
        for (const OwnPoint& own : own_[tile])
            owners.segment(2 * own.stored, 2).array() += stored_.mean_tile()[own.stored].moves ? 1 : 0;
    for (std::uint32_t tile = 0; tile < p_.tiles; ++tile)
        for (const OwnPoint& own : own_[tile]) {
            const WeightedPoint& point = stored_.mean_tile()[own.stored];
            TileConditions::Position before{}, after{};
            for (std::size_t k = 0; k < 2; ++k) {
                before[k] = (point.position[k] + own.base[k] * tile_units) / (tile_units / 2.0) - 1;
                after[k] = before[k] + pushed_[own.stored][k] / (tile_units / 2.0);
            }
            std::vector<double> was(conditions.count()), is(conditions.count()), slope(2 * conditions.count());
            conditions.values(before, was);
            conditions.values(after, is);
            conditions.slopes(after, slope);
            for (Eigen::Index c = 0; c < count; ++c) {
                const auto number = static_cast<std::size_t>(c);
                const Eigen::Index row = tile * count + c;
                lacking[row] -= is[number] - (conditions.stays(number) ? was[number] : 0);
                for (Eigen::Index k = 0; k < 2 && point.moves; ++k)
                    slopes(row, 2 * own.stored + k) += slope[static_cast<std::size_t>(k * count + c)];
            }
            if (!point.moves) continue;
            for (Eigen::Index k = 0; k < 2; ++k) {
                const Eigen::Map<const Eigen::VectorXd> along(&slope[static_cast<std::size_t>(k * count)], count);
                by_themselves.block(tile * count, tile * count, count, count) +=
                    along * along.transpose() / owners[2 * own.stored];
            }
        }
    for (Eigen::Index row = 0; row < count; ++row) {
        double mean = 0;
        for (Eigen::Index tile = 0; tile < p_.tiles; ++tile) mean += lacking[tile * count + row] / p_.tiles;
        for (Eigen::Index tile = 0; tile < p_.tiles; ++tile) lacking[tile * count + row] -= mean;
    }
    const Eigen::VectorXd shares = owners.array().max(1).inverse() * (owners.array() > 0).cast<double>();
    const Eigen::MatrixXd form = shares.asDiagonal() * slopes.transpose();
    Eigen::MatrixXd matrix = slopes * form;
    for (Eigen::Index row = 0; row < rows; ++row) {
        const double soft = conditions.softness(static_cast<std::size_t>(row % count)) * by_themselves(row, row);
        matrix(row, row) += soft;
        by_themselves(row, row) += soft;
    }

    std::vector<Displacement> moved = pushed_;
    add_moment_step(
        moved, stored_, [&](std::uint32_t tile) { return own_[tile]; }, p_);
    Eigen::VectorXd movement(columns);
    for (Eigen::Index i = 0; i < columns; ++i) {
        const auto point = static_cast<std::size_t>(i / 2), axis = static_cast<std::size_t>(i % 2);
        movement[i] = (moved[point][axis] - pushed_[point][axis]) / (tile_units / 2.0);
    }
    const Eigen::VectorXd multipliers = form.colPivHouseholderQr().solve(movement);
    EXPECT_LT((form * multipliers - movement).norm(), 1e-9 * movement.norm());
    const Eigen::LLT<Eigen::MatrixXd> norm(by_themselves);
    const auto squared = [&](const Eigen::VectorXd& left) { return left.dot(norm.solve(left)); };
    EXPECT_LT(squared(lacking - matrix * multipliers), 1.01e-3 * squared(lacking));
}

INSTANTIATE_TEST_SUITE_P(Borders, SharedMovement, testing::Values(TileBorder::strip, TileBorder::chain),
                         [](const auto& border) {
                             return std::string(border.param == TileBorder::strip ? "strips" : "chains");
                         });

}
}
