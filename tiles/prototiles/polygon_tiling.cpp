#include "tiles/prototiles/polygon_tiling.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

namespace poissonlab {
namespace {

/// The letter with small and capital exchanged.
char turned_letter(char letter)
{
    const auto code = static_cast<unsigned char>(letter);
    return static_cast<char>(std::islower(code) != 0 ? std::toupper(code) : std::tolower(code));
}

}

RingPlace moved(const RootRing& ring, const TileMotion& motion, const RingPlace& place)
{
    return motion.at + ring.times(motion.turn, motion.is_mirrored ? ring.conjugate(place) : place);
}

std::vector<RingPlace> corners_of(const PolygonTiling& tiling, const PlacedTile& tile)
{
    std::vector<RingPlace> corners;
    for (const RingPlace& corner : tiling.prototiles[tile.prototile].corners)
        corners.push_back(moved(tiling.ring, tile.motion, corner));
    if (tile.motion.is_mirrored) std::ranges::reverse(corners);
    return corners;
}

std::array<double, 2> point_of(const PolygonTiling& tiling, const RingPlace& place)
{
    return tiling.ring.value(place, tiling.lengths);
}

RingPlace place_near(const PolygonTiling& tiling, const std::array<double, 2>& point)
{
    const auto one = point_of(tiling, tiling.ring.unit(0)), two = point_of(tiling, tiling.ring.unit(2));
    const double up = std::round(point[1] / two[1]);
    return {{std::llround((point[0] - up * two[0]) / one[0]), 0, std::llround(up), 0}};
}

bool mixes_mirrored_tiles(const PolygonTiling& tiling)
{
    std::vector<const std::vector<PlacedTile>*> lists{&tiling.unit};
    for (const StartPatch& start : tiling.starts) lists.push_back(&start.tiles);
    const auto mixes = [](const std::vector<PlacedTile>& tiles, bool first) {
        return std::ranges::any_of(tiles, [&](const PlacedTile& t) { return t.motion.is_mirrored != first; });
    };
    if (std::ranges::any_of(lists, [&](const auto* list) { return mixes(*list, false); })) return true;
    const auto has_parts = std::ranges::find_if(tiling.parts, [](const auto& parts) { return !parts.empty(); });
    if (has_parts == tiling.parts.end()) return false;
    const bool first = has_parts->front().motion.is_mirrored;
    return std::ranges::any_of(tiling.parts, [&](const auto& parts) { return mixes(parts, first); });
}

char edge_letter(const PolygonTiling& tiling, const PlacedTile& tile, std::size_t edge)
{
    const std::string& letters = tiling.prototiles[tile.prototile].edges;
    if (letters.empty()) return 0;
    if (!tile.motion.is_mirrored) return letters[edge];
    // In a mirror the corners come in the opposite order, so that edges are walked along the other way.
    return turned_letter(letters[(2 * letters.size() - 2 - edge) % letters.size()]);
}

bool letters_fit(char one, char other) { return turned_letter(one) == other; }

RingPlace quadruple_area(const RootRing& ring, const std::vector<RingPlace>& corners)
{
    RingPlace sum;
    for (std::size_t i = 0; i < corners.size(); ++i)
        sum = sum + ring.times(ring.conjugate(corners[i]), corners[(i + 1) % corners.size()]);
    return sum - ring.conjugate(sum);
}

double area_of(const PolygonTiling& tiling, std::size_t prototile)
{
    const std::vector<RingPlace>& corners = tiling.prototiles[prototile].corners;
    if (tiling.lengths == std::array<double, 2>{1, 1})
        return tiling.ring.value(quadruple_area(tiling.ring, corners))[1] / 4;
    double twice = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const auto a = point_of(tiling, corners[i]), b = point_of(tiling, corners[(i + 1) % corners.size()]);
        twice += a[0] * b[1] - a[1] * b[0];
    }
    return twice / 2;
}

double scale_of(const RootRing& ring, const TileMotion& motion) { return ring.sizes(motion.turn)[0]; }

}
