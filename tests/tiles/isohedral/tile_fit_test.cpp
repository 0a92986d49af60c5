// The nearest tile in closed form: against bases of tiles that are made of random ones, for all types.
#include "tiles/isohedral/tile_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace poissonlab {
namespace {

using FitVector = std::vector<double>;

/// A type with pieces for its curves, and the steps of random tiles.
class RandomTiles
{
public:
    RandomTiles(const IsohedralType& type, std::mt19937& random) : type_(type), random_(random)
    {
        for (const EdgeShape shape : type.shape.curve_shapes) {
            const std::size_t half = 1 + random_() % 2;
            pieces_.push_back(shape == EdgeShape::straight ? 1 : shape == EdgeShape::free ? 2 * half - 1 : 2 * half);
        }
    }

    const std::vector<std::size_t>& pieces() const { return pieces_; }

    std::vector<PlaneStep> steps()
    {
        IsohedralParameters parameters;
        for (std::size_t i = 0; i < type_.shape.parameters(); ++i) parameters.deformations.push_back(uniform(0.2));
        for (std::size_t c = 0; c < pieces_.size(); ++c) {
            const EdgeShape shape = type_.shape.curve_shapes[c];
            const std::size_t own = shape == EdgeShape::free ? pieces_[c] : (pieces_[c] + 1) / 2;
            PlaneCurve curve{{0, 0}};
            for (std::size_t i = 1; i < own; ++i)
                curve.push_back({(static_cast<double>(i) + uniform(0.3)) / static_cast<double>(own), uniform(0.1)});
            curve.push_back({1, shape == EdgeShape::mirrored ? uniform(0.1) : 0});
            parameters.curves.push_back(std::move(curve));
        }
        const IsohedralTile tile(type_, parameters);
        // Sizes, and directions where there are no mirrors, are free as well.
        bool has_mirrors = false;
        for (const PlaneMotion& hop : type_.shape.hops) has_mirrors = has_mirrors || hop.is_mirror();
        for (const PlaneMotion& symmetry : type_.shape.symmetries) has_mirrors = has_mirrors || symmetry.is_mirror();
        const PlaneStep scale(1 + uniform(0.5), has_mirrors ? 0 : uniform(1));
        std::vector<PlaneStep> steps;
        const auto& outline = tile.outline();
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const PlanePoint &a = outline[i], &b = outline[(i + 1) % outline.size()];
            steps.push_back(scale * PlaneStep(b[0] - a[0], b[1] - a[1]));
        }
        return steps;
    }

    double uniform(double most) { return std::uniform_real_distribution<double>(-most, most)(random_); }

private:
    const IsohedralType& type_;
    std::mt19937& random_;
    std::vector<std::size_t> pieces_;
};

FitVector weighted(const std::vector<PlaneStep>& steps, const std::vector<double>& weights)
{
    FitVector vector;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        vector.push_back(std::sqrt(weights[i]) * steps[i].real());
        vector.push_back(std::sqrt(weights[i]) * steps[i].imag());
    }
    return vector;
}

double fit_dot(const FitVector& a, const FitVector& b)
{
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
}

/// Gram and Schmidt, twice; stops where ten tiles in a row are combinations of others.
std::vector<FitVector> basis_of(RandomTiles& tiles, const std::vector<double>& weights)
{
    std::vector<FitVector> basis;
    for (int without = 0; without < 10;) {
        FitVector v = weighted(tiles.steps(), weights);
        const double length = std::sqrt(fit_dot(v, v));
        for (int again = 0; again < 2; ++again)
            for (const FitVector& b : basis) {
                const double share = fit_dot(v, b);
                for (std::size_t i = 0; i < v.size(); ++i) v[i] -= share * b[i];
            }
        const double left = std::sqrt(fit_dot(v, v));
        if (left < 1e-7 * length) {
            ++without;
            continue;
        }
        without = 0;
        for (double& x : v) x /= left;
        basis.push_back(std::move(v));
    }
    return basis;
}

TEST(TileFits, FindTheNearestOfAllTiles)
{
    std::mt19937 random(7);
    for (const IsohedralType& type : isohedral_types())
        for (int round = 0; round < 3; ++round) {
            RandomTiles tiles(type, random);
            const TileFit fit(type);
            GoalSteps goal{tiles.pieces(), {}, nullptr};
            std::vector<double> weights; // of each step
            for (std::size_t e = 0; e < type.shape.base.size(); ++e) {
                goal.weights.push_back(round == 0 ? 1 : 1.5 + tiles.uniform(1));
                weights.insert(weights.end(), goal.pieces[type.shape.edge_curves[e].curve], goal.weights.back());
            }
            std::vector<PlaneStep> steps = tiles.steps(); // and a large deviation
            const PlaneStep turn = std::polar(1.0, tiles.uniform(3));
            for (PlaneStep& step : steps) step = turn * (step + PlaneStep(tiles.uniform(0.4), tiles.uniform(0.4)));
            goal.steps = steps.data();

            // The square of the part in the basis, over rotations c + r cos(2 angle - p), at three of them.
            const std::vector<FitVector> basis = basis_of(tiles, weights);
            const auto part_at = [&](double angle) {
                std::vector<PlaneStep> rotated = steps;
                for (PlaneStep& step : rotated) step *= std::polar(1.0, angle);
                double sum = 0;
                for (const FitVector& b : basis) sum += std::pow(fit_dot(b, weighted(rotated, weights)), 2);
                return sum;
            };
            const double at_0 = part_at(0), at_45 = part_at(std::numbers::pi / 4),
                         at_90 = part_at(std::numbers::pi / 2);
            const double middle = (at_0 + at_90) / 2, most = middle + std::hypot(at_0 - middle, at_45 - middle);
            ASSERT_LT(basis.size(), 2 * steps.size());
            EXPECT_NEAR(fit.likeness(goal), most, 1e-8 * most) << "IH" << type.number;
            const TileFit::Nearest nearest = fit.nearest(goal);
            EXPECT_NEAR(part_at(nearest.angle), most, 1e-8 * most) << "IH" << type.number;
            EXPECT_EQ(nearest.likeness, fit.likeness(goal));

            // The nearest tile's steps, as IsohedralTile has them, have this part of the rotated goal's.
            std::vector<PlaneStep> own, rotated = steps;
            for (PlaneStep& step : rotated) step *= std::polar(1.0, nearest.angle);
            for (std::size_t i = 0; i < steps.size(); ++i) {
                const PlanePoint &a = nearest.outline[i], &b = nearest.outline[(i + 1) % steps.size()];
                own.emplace_back(b[0] - a[0], b[1] - a[1]);
            }
            double square = 0; // of the part along the tile's steps, in any direction where directions are free
            const FitVector v = weighted(own, weights), w = weighted(rotated, weights);
            for (PlaneStep& step : own) step *= PlaneStep(0, 1);
            square = std::pow(fit_dot(v, w), 2) + std::pow(fit_dot(weighted(own, weights), w), 2);
            EXPECT_GE(square / fit_dot(v, v), most * (1 - 1e-8)) << "IH" << type.number;
        }
}

/// The parameters make the outline that the fit says.
TEST(TileFits, HaveTheirParameters)
{
    std::mt19937 random(3);
    for (const IsohedralType& type : isohedral_types()) {
        RandomTiles tiles(type, random);
        std::vector<PlaneStep> steps = tiles.steps();
        for (PlaneStep& step : steps) step += PlaneStep(tiles.uniform(0.02), tiles.uniform(0.02));
        const TileFit fit(type);
        const GoalSteps goal{tiles.pieces(), std::vector<double>(type.shape.base.size(), 1.0), steps.data()};
        const TileFit::Nearest nearest = fit.nearest(goal);
        const IsohedralTile tile(type, nearest.parameters);
        double farthest = 0;
        for (const PlanePoint& p : nearest.outline) {
            double gap = 1e300;
            for (const PlanePoint& q : tile.outline()) gap = std::min(gap, std::hypot(p[0] - q[0], p[1] - q[1]));
            farthest = std::max(farthest, gap);
        }
        EXPECT_LT(farthest, 1e-9) << "IH" << type.number;
    }
}

}
}
