// Closures of tiles against the tilings that they are cut out of.
#include "tiles/poisson/proof/shared_pieces.hpp"

#include "tests/tiles/poisson/made_up_tile_sets.hpp"
#include "tests/tiles/poisson/made_up_tilings.hpp"

#include <gtest/gtest.h>

namespace poissonlab {
namespace {

/// True if a cell of the tile at `place` is on the border of the tile at the origin, or is its interior.
bool is_at_origin(const TileCell& cell, const std::array<int, 3>& place)
{
    for (unsigned k = 0; k < 3; ++k) {
        const int base = place[k] + (cell.upper >> k & 1);
        if (base != 0 && (base != 1 || cell.axes >> k & 1)) return false;
    }
    return true;
}

/// The points around a place of a tiling whose cells are at that tile.
std::vector<UnitPosition> cut_out(const PoissonTileSet& set, const MadeUpTiling& tiling, int x, int y, int z)
{
    std::vector<UnitPosition> result;
    const auto dimension = static_cast<std::size_t>(set.parameters.dimension);
    const TileRegions regions = regions_of(set.parameters);
    for (int n = 0; n < (dimension == 3 ? 27 : 9); ++n) {
        const std::array<int, 3> place{n % 3 - 1, n / 3 % 3 - 1, dimension == 3 ? n / 9 - 1 : 0};
        const auto points = set.tile(tiling.tile(x + place[0], y + place[1], z + place[2]));
        for (std::size_t i = 0; i < points.size(); i += dimension) {
            if (!is_at_origin(regions.cell_of(points.subspan(i, dimension)), place)) continue;
            UnitPosition position{};
            for (std::size_t k = 0; k < dimension; ++k) position[k] = points[i + k] + place[k] * tile_units;
            result.push_back(position);
        }
    }
    return result;
}

TEST(SharedPieces, ClosuresAreWhatTilingsHave)
{
    for (const PoissonTileParameters& p : {corner_parameters(2), corner_parameters(3), edge_parameters(1),
                                           edge_parameters(2), template_parameters(3), sphere_parameters(2)}) {
        const PoissonTileSet set = made_up(p);
        const SharedPieces pieces(set);
        const int period = p.dimension == 3 ? 4 : 10;
        const MadeUpTiling tiling(p, period, 1);
        std::vector<UnitPosition> closure;
        for (int n = 0; n < period * period; ++n) {
            const int x = n % period;
            const int y = n / period;
            const int z = p.dimension == 3 ? (x + 2 * y) % period : 0;
            pieces.closure(tiling.tile(x, y, z), closure);
            std::vector<UnitPosition> expected = cut_out(set, tiling, x, y, z);
            std::ranges::sort(closure);
            std::ranges::sort(expected);
            ASSERT_EQ(closure, expected) << kind_name(p) << " " << x << " " << y;
        }
    }
}

}
}
