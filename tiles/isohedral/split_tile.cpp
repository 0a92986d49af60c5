#include "tiles/isohedral/split_tile.hpp"

#include "base/errors/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

double squared_gap(const PlanePoint& a, const PlanePoint& b)
{
    return (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]);
}

std::size_t place_on_outline(const IsohedralTile& tile, std::size_t corner)
{
    const auto& outline = tile.outline();
    const auto nearest = std::ranges::min_element(
        outline, {}, [&](const PlanePoint& p) { return squared_gap(p, tile.corners()[corner]); });
    return static_cast<std::size_t>(nearest - outline.begin());
}

/// The edge of the neighbour of a tile across `edge` that is the same line: the one whose middle lies nearest.
std::size_t edge_across(const IsohedralTile& tile, const TilePlace& place, std::size_t edge)
{
    const auto& corners = tile.corners();
    const auto twice_middle = [&](const PlaneMotion& motion, std::size_t k) {
        const PlanePoint a = motion(corners[k]), b = motion(corners[(k + 1) % corners.size()]);
        return PlanePoint{a[0] + b[0], a[1] + b[1]};
    };
    const PlaneMotion beyond = tile.motion(tile.neighbour(place, edge));
    const PlanePoint own = twice_middle(tile.motion(place), edge);
    const auto gap = [&](std::size_t k) { return squared_gap(twice_middle(beyond, k), own); };
    std::size_t best = 0;
    for (std::size_t k = 1; k < corners.size(); ++k)
        if (gap(k) < gap(best)) best = k;
    return best;
}

}

SplitTile split_tile(const IsohedralTile& tile, const TileSplit& split)
{
    const std::size_t corners = tile.corners().size();
    if (split.from >= corners || split.to >= corners || split.from == split.to)
        throw InputError(fmt::format("a path joins two different corners of the {}, 0 to {}", corners, corners - 1));
    const PlanePoint &a = tile.corners()[split.from], &b = tile.corners()[split.to];
    std::vector<PlanePoint> path;
    for (const auto& [x, y] : split.path)
        if (x != 0 || y != 0)
            path.push_back(
                {a[0] + x * (b[0] - a[0]) - y * (b[1] - a[1]), a[1] + x * (b[1] - a[1]) + y * (b[0] - a[0])});
    if (!path.empty()) path.pop_back(); // the corner `to` itself
    const auto& outline = tile.outline();
    const std::size_t first = place_on_outline(tile, split.from), last = place_on_outline(tile, split.to);
    SplitTile result;
    for (std::size_t i = first; i != last; i = (i + 1) % outline.size()) result.parts[0].push_back(outline[i]);
    for (std::size_t i = last; i != first; i = (i + 1) % outline.size()) result.parts[1].push_back(outline[i]);
    result.parts[0].push_back(b);
    result.parts[0].insert(result.parts[0].end(), path.rbegin(), path.rend());
    result.parts[1].push_back(a);
    result.parts[1].insert(result.parts[1].end(), path.begin(), path.end());
    const double least = 1e-9 * area_of(outline);
    for (const auto& part : result.parts)
        if (crosses_itself(part) || !(area_of(part) > least))
            throw InputError("the path that splits the tile meets its outline or itself");
    const auto is_of_first = [&](std::size_t edge) {
        return (edge + corners - split.from) % corners < (split.to + corners - split.from) % corners;
    };
    // Tiles that have symmetries lose them with the path, so that aspects may differ.
    for (std::uint32_t aspect = 0; aspect < tile.aspects().size(); ++aspect)
        for (std::size_t edge = 0; edge < corners; ++edge)
            result.alike += is_of_first(edge) == is_of_first(edge_across(tile, {aspect, 0, 0}, edge));
    return result;
}

}
