#include "host/tile_construction/chain_paths.hpp"

#include "tiles/poisson/chain_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace poissonlab {
namespace {

/// A link counts as this much longer for each spacing's square that it is away from where it should be.
constexpr double cost_of_deviation = 4;

/// The area between a chain and the straight edge of the lattice, in square units, as a tile's area counts it: what is
/// left of the edge lies on the positive side; the corners' share makes the four chains of a tile add up.
double area_beside(std::size_t direction, const Chain& chain, const std::array<UnitPosition, 2>& ends)
{
    const std::size_t across = 1 - direction;
    double area = 0;
    UnitPosition before = ends[0];
    for (std::size_t i = 0; i <= chain.size(); ++i) {
        const UnitPosition& point = i < chain.size() ? chain[i] : ends[1];
        area += 0.5 * (static_cast<double>(before[across]) + point[across]) * (point[direction] - before[direction]);
        before = point;
    }
    UnitPosition last = ends[1];
    last[direction] -= tile_units;
    return area + 0.5 * (static_cast<double>(ends[0][0]) * ends[0][1] - static_cast<double>(last[0]) * last[1]);
}

/// The line that a chain should follow, and how far points are from it.
class TargetLine
{
public:
    TargetLine(const std::array<UnitPosition, 2>& ends, std::size_t direction) : first_(ends[0])
    {
        for (std::size_t k = 0; k < 2; ++k) along_[k] = ends[1][k] - ends[0][k];
        squared_ = along_[0] * along_[0] + along_[1] * along_[1];
        // The straight line and the edge enclose this area, which a half wave of sagitta s makes up for: 2 s length /
        // pi.
        const std::size_t across = 1 - direction;
        const double straight = 0.5 * (static_cast<double>(ends[0][across]) + ends[1][across]) * along_[direction];
        sagitta_ = -straight * std::numbers::pi / (2 * along_[direction]);
        side_ = direction == 0 ? 1 : -1;
    }

    /// The distance of a point from the line, in units.
    double distance(const UnitPosition& point) const
    {
        const double x = point[0] - first_[0], y = point[1] - first_[1];
        const double part = std::clamp((x * along_[0] + y * along_[1]) / squared_, 0.0, 1.0);
        const double left = (along_[0] * y - along_[1] * x) / std::sqrt(squared_);
        return std::abs(side_ * left - sagitta_ * std::sin(std::numbers::pi * part));
    }

private:
    UnitPosition first_;
    std::array<double, 2> along_{};
    double squared_ = 0, sagitta_ = 0;
    double side_ = 1; ///< across axes point to the left of axis 0, to the right of axis 1
};

/// Dijkstra's algorithm from number 0 to the last; numbers of the path between them. `cost`: infinite, no link.
template <class Cost>
std::optional<std::vector<std::size_t>> shortest_path(std::size_t count, Cost cost)
{
    constexpr double unreached = std::numeric_limits<double>::infinity();
    std::vector<double> length(count, unreached);
    std::vector<std::size_t> before(count, 0);
    std::vector<bool> is_done(count);
    length[0] = 0;
    for (std::size_t round = 0; round < count; ++round) {
        std::size_t nearest = count;
        for (std::size_t i = 0; i < count; ++i)
            if (!is_done[i] && length[i] < unreached && (nearest == count || length[i] < length[nearest])) nearest = i;
        if (nearest == count) return {};
        if (nearest == count - 1) break;
        is_done[nearest] = true;
        for (std::size_t i = 0; i < count; ++i) {
            const double through = length[nearest] + cost(nearest, i);
            if (is_done[i] || through >= length[i]) continue;
            length[i] = through;
            before[i] = nearest;
        }
    }
    std::vector<std::size_t> path;
    for (std::size_t i = before[count - 1]; i != 0; i = before[i]) path.push_back(i);
    std::ranges::reverse(path);
    return path;
}

}

double chain_balance(const ChainPieces& pieces, std::size_t direction, std::uint32_t lower, std::uint32_t upper,
                     std::uint32_t points_per_tile)
{
    const PlacedChain placed{direction, lower, upper, {0, 0}};
    const Chain& chain = pieces.chains[direction][placed.number(pieces.colors)];
    const double area = area_beside(direction, chain, chain_ends(pieces, placed)) / tile_units / tile_units;
    return points_per_tile * area - 0.5 * static_cast<double>(chain.size());
}

ChainFinder::ChainFinder(const PoissonTileParameters& parameters)
    : squared_distance_(static_cast<std::int64_t>(asked_squared_distance(parameters))),
      spacing_(tile_units / std::sqrt(parameters.points_per_tile)), points_per_tile_(parameters.points_per_tile)
{}

std::optional<ChainCandidate> ChainFinder::find(const ChainPieces& corners, const PlacedChain& edge,
                                                const std::vector<TilePosition>& points) const
{
    PlacedChain at_origin = edge;
    at_origin.base = {0, 0};
    const auto ends = chain_ends(corners, at_origin);
    std::vector<UnitPosition> known{ends[0]};
    for (const TilePosition& point : points) {
        UnitPosition relative{};
        for (std::size_t k = 0; k < 2; ++k) {
            const std::int32_t middle = k == edge.direction ? tile_units / 2 : 0;
            relative[k] = shortest(point[k] - edge.base[k] * tile_units - middle) + middle;
        }
        if (is_in_cone(relative, ends[0], edge.direction, 1, squared_distance_) &&
            is_in_cone(relative, ends[1], edge.direction, -1, squared_distance_) &&
            is_near_edge(relative, edge.direction, squared_distance_))
            known.push_back(relative);
    }
    known.push_back(ends[1]);
    const TargetLine target(ends, edge.direction);
    std::vector<double> away;
    for (const UnitPosition& point : known) away.push_back(target.distance(point) / spacing_);
    const auto path = shortest_path(known.size(), [&](std::size_t i, std::size_t j) {
        const std::int64_t squared = squared_length(known[i], known[j]);
        if (!is_short_link(squared, squared_distance_)) return std::numeric_limits<double>::infinity();
        const double deviation = (away[i] * away[i] + away[i] * away[j] + away[j] * away[j]) / 3;
        return std::sqrt(static_cast<double>(squared)) / spacing_ * (1 + cost_of_deviation * deviation);
    });
    if (!path) return {};
    ChainCandidate candidate;
    for (const std::size_t i : *path) candidate.chain.push_back(known[i]);
    const double area = area_beside(edge.direction, candidate.chain, ends) / tile_units / tile_units;
    candidate.balance = points_per_tile_ * area - 0.5 * static_cast<double>(candidate.chain.size());
    return candidate;
}

}
