#include "host/tile_construction/chains/chain_mending.hpp"

#include "host/tile_construction/moments/moment_step.hpp"
#include "tiles/poisson/chain_geometry.hpp"

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

constexpr int max_passes = 400;

using Position = std::array<double, 2>;

Position position_of(const UnitPosition& point)
{
    return {static_cast<double>(point[0]), static_cast<double>(point[1])};
}

std::int32_t even(double x) { return 2 * static_cast<std::int32_t>(std::nearbyint(x / 2)); }

class Mending
{
public:
    Mending(const LooseChain& chain, std::int64_t squared_distance)
        : chain_(chain), squared_distance_(squared_distance),
          distance_(std::sqrt(static_cast<double>(squared_distance)))
    {
        points_.push_back(position_of(chain.ends[0]));
        points_.insert(points_.end(), chain.points.begin(), chain.points.end());
        points_.push_back(position_of(chain.ends[1]));
    }

    std::optional<Chain> run()
    {
        for (int pass = 0; pass < max_passes; ++pass) {
            Chain chain = rounded();
            if (is_sound(chain)) return chain;
            step();
        }
        return {};
    }

private:
    std::size_t last() const { return points_.size() - 1; }

    Chain rounded() const
    {
        Chain chain;
        for (std::size_t i = 1; i < last(); ++i) chain.push_back({even(points_[i][0]), even(points_[i][1]), 0});
        return chain;
    }

    bool is_sound(const Chain& chain) const
    {
        std::vector<UnitPosition> all{chain_.ends[0]};
        all.insert(all.end(), chain.begin(), chain.end());
        all.push_back(chain_.ends[1]);
        for (std::size_t i = 0; i < all.size(); ++i) {
            for (std::size_t j = i + 1; j < all.size(); ++j)
                if (squared_length(all[i], all[j]) < squared_distance_) return false;
            if (i > 0 && !is_short_link(squared_length(all[i - 1], all[i]), squared_distance_)) return false;
        }
        return std::ranges::all_of(chain, [&](const UnitPosition& point) {
            return is_in_cone(point, chain_.ends[0], chain_.direction, 1, squared_distance_) &&
                   is_in_cone(point, chain_.ends[1], chain_.direction, -1, squared_distance_) &&
                   is_near_edge(point, chain_.direction, squared_distance_);
        });
    }

    /// All movements at once.
    void step()
    {
        moves_.assign(points_.size(), {0, 0});
        for (std::size_t i = 0; i < last(); ++i)
            for (std::size_t j = i + 1; j <= last(); ++j) {
                keep_length(i, j, distance_ + chain_rounding, true);
                if (j == i + 1) keep_length(i, j, std::sqrt(3.0) * distance_ - chain_rounding, false);
            }
        for (std::size_t i = 1; i < last(); ++i) {
            push_into_cone(i, points_.front(), 1);
            push_into_cone(i, points_.back(), -1);
            push_to_edge(i);
        }
        for (std::size_t i = 1; i < last(); ++i)
            for (std::size_t k = 0; k < 2; ++k) points_[i][k] += moves_[i][k];
    }

    bool is_end(std::size_t i) const { return i == 0 || i == last(); }

    /// Moves two points apart to at least (or together to at most) this length, half each, or one all of it.
    void keep_length(std::size_t i, std::size_t j, double wanted, bool is_least)
    {
        const Position difference{points_[j][0] - points_[i][0], points_[j][1] - points_[i][1]};
        const double length = std::hypot(difference[0], difference[1]);
        if (length == 0 || (is_least ? length >= wanted : length <= wanted)) return;
        const double part = (wanted - length) / length * (is_end(i) || is_end(j) ? 1 : 0.5);
        for (std::size_t k = 0; k < 2; ++k) {
            if (!is_end(i)) moves_[i][k] -= part * difference[k];
            if (!is_end(j)) moves_[j][k] += part * difference[k];
        }
    }

    void push_into_cone(std::size_t i, const Position& corner, int outward)
    {
        const std::size_t d = chain_.direction;
        const double along = outward * (points_[i][d] - corner[d]), across = points_[i][1 - d] - corner[1 - d];
        const double lacking =
            (distance_ / 2 + chain_rounding - (along - std::abs(across)) / std::sqrt(2.0)) / std::sqrt(2.0);
        if (lacking <= 0) return;
        moves_[i][d] += outward * lacking;
        moves_[i][1 - d] -= across > 0 ? lacking : -lacking;
    }

    void push_to_edge(std::size_t i)
    {
        const double across = points_[i][1 - chain_.direction];
        const double beyond = std::abs(across) - (tile_units - distance_) / 2 + chain_rounding;
        if (beyond > 0) moves_[i][1 - chain_.direction] -= across > 0 ? beyond : -beyond;
    }

    const LooseChain& chain_;
    std::int64_t squared_distance_;
    double distance_;
    std::vector<Position> points_, moves_;
};

}

std::optional<Chain> mended(const LooseChain& chain, std::int64_t squared_distance)
{
    return Mending(chain, squared_distance).run();
}

namespace {

/// Chains have too few points for shares of higher orders.
constexpr unsigned highest_share = 2;
constexpr double length_unit = tile_units / 2.0;

/// An iteration makes up for this part of what a chain's share lacks.
constexpr double evening_gain = 0.3;

/// Added to the squares of what moving points changes, so that what can hardly be changed is left alone.
constexpr double reluctance = 30;

/// The parts of a chain's points that its own tile has of them more than an even tile would have; the tile on the other
/// side has as much less. A corner point is of one tile and at the border of four.
constexpr double share_of_point = 0.5, share_of_lower_end = 0.375, share_of_upper_end = 0.125;

/// Along and across the chain.
using ChainPosition = std::array<double, 2>;

double monomial(const ChainPosition& at, unsigned along, unsigned across)
{
    double product = 1;
    for (unsigned i = 0; i < along; ++i) product *= at[0];
    for (unsigned i = 0; i < across; ++i) product *= at[1];
    return product;
}

/// The integral over the rectangle from the end of the edge, at -1 or 1, to a point.
double corner_rectangle(const ChainPosition& at, double end, unsigned along, unsigned across)
{
    return (monomial({at[0], at[1]}, along + 1, across + 1) - monomial({end, at[1]}, along + 1, across + 1)) /
           ((along + 1) * (across + 1));
}

/// The integral along a straight line of a monomial's integral across; exact up to degree 5.
double below_line(const ChainPosition& from, const ChainPosition& to, unsigned along, unsigned across)
{
    static const double node = std::sqrt(0.6);
    constexpr std::array weights{5.0 / 18, 8.0 / 18, 5.0 / 18};
    double sum = 0;
    for (int i = 0; i < 3; ++i) {
        const double part = 0.5 + 0.5 * (i - 1) * node;
        const ChainPosition at{from[0] + part * (to[0] - from[0]), from[1] + part * (to[1] - from[1])};
        sum += weights[static_cast<std::size_t>(i)] * monomial(at, along, across + 1);
    }
    return sum * (to[0] - from[0]) / (across + 1);
}

/// The movement of a chain's points that changes shares by what is wanted, nearly.
std::vector<std::array<double, 2>> evening_movement(const LooseChain& chain, const ChainShares& shares,
                                                    std::vector<double> wanted)
{
    constexpr double step = 16; // units, for differences
    const std::size_t conditions = shares.count(), numbers = 2 * chain.points.size();
    std::vector<std::vector<double>> slopes;
    for (std::size_t i = 0; i < numbers; ++i) {
        LooseChain up = chain, down = chain;
        up.points[i / 2][i % 2] += step;
        down.points[i / 2][i % 2] -= step;
        slopes.push_back(shares.of(up));
        const std::vector<double> lower = shares.of(down);
        for (std::size_t c = 0; c < conditions; ++c)
            slopes.back()[c] = (slopes.back()[c] - lower[c]) / (2 * step / length_unit);
    }
    std::vector<double> triangle;
    for (std::size_t c = 0; c < conditions; ++c)
        for (std::size_t e = 0; e <= c; ++e) {
            double sum = c == e ? reluctance : 0;
            for (const auto& slope : slopes) sum += slope[c] * slope[e];
            triangle.push_back(sum);
        }
    factorize(triangle, conditions);
    solve(triangle, wanted);
    std::vector<std::array<double, 2>> movement(chain.points.size());
    for (std::size_t i = 0; i < numbers; ++i)
        for (std::size_t c = 0; c < conditions; ++c) movement[i / 2][i % 2] += length_unit * wanted[c] * slopes[i][c];
    return movement;
}

}

ChainShares::ChainShares(const PoissonTileParameters& p) : points_per_area_(p.points_per_tile / 4.0)
{
    for (unsigned order = 0; order <= std::min<unsigned>(p.equal_moments, highest_share); ++order)
        for (unsigned across = 0; across <= order; ++across) exponents_.push_back({order - across, across});
}

std::vector<double> ChainShares::of(const LooseChain& chain) const
{
    const std::size_t d = chain.direction;
    const auto placed = [&](const auto& point) {
        return ChainPosition{static_cast<double>(point[d]) / length_unit - 1,
                             static_cast<double>(point[1 - d]) / length_unit};
    };
    std::vector<ChainPosition> points{placed(chain.ends[0])};
    for (const auto& point : chain.points) points.push_back(placed(point));
    points.push_back(placed(chain.ends[1]));
    std::vector<double> shares;
    for (const auto& [along, across] : exponents_) {
        double share = share_of_lower_end * monomial(points.front(), along, across) +
                       share_of_upper_end * monomial(points.back(), along, across);
        for (std::size_t i = 1; i + 1 < points.size(); ++i)
            share += share_of_point * monomial(points[i], along, across);
        // The rectangle between a corner point and its lattice point is half this chain's, half its neighbour's.
        double area = 0.5 * (corner_rectangle(points.front(), -1, along, across) -
                             corner_rectangle(points.back(), 1, along, across));
        for (std::size_t i = 1; i < points.size(); ++i) area += below_line(points[i - 1], points[i], along, across);
        shares.push_back(share - points_per_area_ * area);
    }
    return shares;
}

void even_out(std::vector<LooseChain>& chains, const PoissonTileParameters& parameters, double longest)
{
    const ChainShares shares(parameters);
    std::vector<std::vector<double>> found;
    std::vector<double> mean(shares.count());
    for (const LooseChain& chain : chains) {
        found.push_back(shares.of(chain));
        for (std::size_t c = 0; c < mean.size(); ++c) mean[c] += found.back()[c] / static_cast<double>(chains.size());
    }
    for (std::size_t i = 0; i < chains.size(); ++i) {
        std::vector<double> wanted;
        for (std::size_t c = 0; c < mean.size(); ++c) wanted.push_back(evening_gain * (mean[c] - found[i][c]));
        const auto movement = evening_movement(chains[i], shares, wanted);
        for (std::size_t j = 0; j < movement.size(); ++j) {
            const double length = std::hypot(movement[j][0], movement[j][1]);
            const double scale = length > longest ? longest / length : 1;
            for (std::size_t k = 0; k < 2; ++k) chains[i].points[j][k] += scale * movement[j][k];
        }
    }
}

}
