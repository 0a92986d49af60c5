#include "host/tile_construction/chains/chain_evening.hpp"

#include "host/tile_construction/moments/moment_step.hpp"

#include <algorithm>
#include <cmath>

namespace poissonlab {
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
