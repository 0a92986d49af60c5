#include "tiles/prototiles/polygon_tiling.hpp"

#include <algorithm>
#include <cctype>

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
    return tiling.ring.value(quadruple_area(tiling.ring, tiling.prototiles[prototile].corners))[1] / 4;
}

double scale_of(const RootRing& ring, const TileMotion& motion) { return ring.sizes(motion.turn)[0]; }

}
