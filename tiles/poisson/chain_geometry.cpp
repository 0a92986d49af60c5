#include "tiles/poisson/chain_geometry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace poissonlab {
namespace {

/// Positive where `c` is to the left of the line from `a` to `b`.
std::int64_t turn(const UnitPosition& a, const UnitPosition& b, const UnitPosition& c)
{
    return std::int64_t{b[0] - a[0]} * (c[1] - a[1]) - std::int64_t{b[1] - a[1]} * (c[0] - a[0]);
}

int sign(std::int64_t value) { return (value > 0) - (value < 0); }

/// True if a point that is in line with a segment is on it.
bool is_between(const UnitPosition& a, const UnitPosition& b, const UnitPosition& point)
{
    for (std::size_t k = 0; k < 2; ++k)
        if (point[k] < std::min(a[k], b[k]) || point[k] > std::max(a[k], b[k])) return false;
    return true;
}

/// True if two closed segments have a point in common.
bool do_meet(const UnitPosition& a, const UnitPosition& b, const UnitPosition& c, const UnitPosition& d)
{
    const int abc = sign(turn(a, b, c)), abd = sign(turn(a, b, d)), cda = sign(turn(c, d, a)),
              cdb = sign(turn(c, d, b));
    if (abc * abd < 0 && cda * cdb < 0) return true;
    return (abc == 0 && is_between(a, b, c)) || (abd == 0 && is_between(a, b, d)) ||
           (cda == 0 && is_between(c, d, a)) || (cdb == 0 && is_between(c, d, b));
}

/// The square of twice the distance from the nearer side of a cone; 0 outside.
std::int64_t cone_clearance(const UnitPosition& point, const UnitPosition& corner, std::size_t direction, int outward)
{
    const std::int64_t along = std::int64_t{outward} * (point[direction] - corner[direction]);
    const std::int64_t across = std::abs(std::int64_t{point[1 - direction] - corner[1 - direction]});
    const std::int64_t deep = along - across; // sqrt 2 times the distance from the nearer side
    return deep > 0 ? 2 * deep * deep : 0;
}

/// The square of twice what is left to half a tile; 0 beyond.
std::int64_t edge_clearance(const UnitPosition& point, std::size_t direction)
{
    const std::int64_t left = tile_units - 2 * std::abs(std::int64_t{point[1 - direction]});
    return left > 0 ? left * left : 0;
}

std::string described(const UnitPosition& point) { return fmt::format("({}, {})", point[0], point[1]); }

}

std::int64_t squared_length(const UnitPosition& a, const UnitPosition& b)
{
    const std::int64_t x = a[0] - b[0], y = a[1] - b[1];
    return x * x + y * y;
}

bool is_in_cone(const UnitPosition& point, const UnitPosition& corner, std::size_t direction, int outward,
                std::int64_t squared_distance)
{
    return cone_clearance(point, corner, direction, outward) >= squared_distance;
}

bool is_near_edge(const UnitPosition& point, std::size_t direction, std::int64_t squared_distance)
{
    return edge_clearance(point, direction) >= squared_distance;
}

std::int64_t squared_clearance(const ChainPieces& pieces, std::size_t direction, std::uint32_t lower,
                               std::uint32_t upper)
{
    const PlacedChain placed{direction, lower, upper, {0, 0}};
    const auto [first, last] = chain_ends(pieces, placed);
    std::int64_t least = INT64_MAX;
    for (const UnitPosition& point : pieces.chains[direction][placed.number(pieces.colors)])
        least = std::min({least, cone_clearance(point, first, direction, 1), cone_clearance(point, last, direction, -1),
                          edge_clearance(point, direction)});
    return least;
}

std::optional<std::string> fault_of_chain(const ChainPieces& pieces, std::size_t direction, std::uint32_t lower,
                                          std::uint32_t upper, std::int64_t squared_distance)
{
    const PlacedChain placed{direction, lower, upper, {0, 0}};
    const auto [first, last] = chain_ends(pieces, placed);
    const Chain& chain = pieces.chains[direction][placed.number(pieces.colors)];
    UnitPosition before = first;
    for (std::size_t i = 0; i <= chain.size(); ++i) {
        const UnitPosition& point = i < chain.size() ? chain[i] : last;
        if (!is_short_link(squared_length(before, point), squared_distance))
            return fmt::format(
                "link from {} to {} of length {:.1f}: must be at most sqrt 3 times the minimum distance, "
                "{:.1f}",
                described(before), described(point), std::sqrt(static_cast<double>(squared_length(before, point))),
                std::sqrt(3 * static_cast<double>(squared_distance)));
        before = point;
    }
    for (const UnitPosition& point : chain) {
        if (!is_in_cone(point, first, direction, 1, squared_distance) ||
            !is_in_cone(point, last, direction, -1, squared_distance))
            return fmt::format("point at {}: must be in the cones of its ends", described(point));
        if (!is_near_edge(point, direction, squared_distance))
            return fmt::format("point at {}: must be nearer to its edge", described(point));
    }
    return {};
}

bool is_strictly_inside(std::span<const UnitPosition> polygon, const UnitPosition& point)
{
    bool is_inside = false;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const UnitPosition& a = polygon[i];
        const UnitPosition& b = polygon[(i + 1) % polygon.size()];
        const std::int64_t side = turn(a, b, point);
        if (side == 0 && is_between(a, b, point)) return false;
        if ((a[1] > point[1]) != (b[1] > point[1]) && (side > 0) == (b[1] > a[1])) is_inside = !is_inside;
    }
    return is_inside;
}

bool is_simple(std::span<const UnitPosition> polygon)
{
    const std::size_t n = polygon.size();
    for (std::size_t i = 0; i < n; ++i) {
        const UnitPosition& a = polygon[i];
        const UnitPosition& b = polygon[(i + 1) % n];
        const UnitPosition& c = polygon[(i + 2) % n];
        // Neighbouring segments may only touch where they join.
        if (a == b || (turn(a, b, c) == 0 && (is_between(a, b, c) || is_between(b, c, a)))) return false;
        for (std::size_t j = i + 2; j < n; ++j) {
            if (i == 0 && j == n - 1) continue;
            if (do_meet(a, b, polygon[j], polygon[(j + 1) % n])) return false;
        }
    }
    return true;
}

std::int64_t twice_area(std::span<const UnitPosition> polygon)
{
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const UnitPosition& a = polygon[i];
        const UnitPosition& b = polygon[(i + 1) % polygon.size()];
        sum += std::int64_t{a[0]} * b[1] - std::int64_t{b[0]} * a[1];
    }
    return sum;
}

}
