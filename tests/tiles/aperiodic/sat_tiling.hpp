// Rectangles, cylinders and tori of tiles by a SAT solver: a second opinion on what fits.
#pragma once

#include "tiles/aperiodic/tile_list.hpp"

#include <cadical.hpp>

#include <cstddef>

namespace poissonlab {

/// The ways in which a rectangle of tiles is closed.
struct SatShape
{
    int width = 1;
    int height = 1;
    bool is_round = false; ///< the last column fits to the west of the first
    bool is_torus = false; ///< also the first row, moved `shear` tiles to the east, fits below the last
    int shear = 0;
};

class SatTiling
{
public:
    SatTiling(const WangList& list, const SatShape& shape) : list_(list), shape_(shape) {}

    bool exists()
    {
        for (int y = 0; y < shape_.height; ++y)
            for (int x = 0; x < shape_.width; ++x) {
                for (std::size_t tile = 0; tile < list_.tiles.size(); ++tile) solver_.add(variable(x, y, tile));
                solver_.add(0);
                if (x + 1 < shape_.width || shape_.is_round)
                    fit(x, y, (x + 1) % shape_.width, y, &WangTile::east, &WangTile::west);
                if (y + 1 < shape_.height)
                    fit(x, y, x, y + 1, &WangTile::south, &WangTile::north);
                else if (shape_.is_torus)
                    fit(x, y, (x + shape_.width - shape_.shear) % shape_.width, 0, &WangTile::south, &WangTile::north);
            }
        return solver_.solve() == 10;
    }

private:
    int variable(int x, int y, std::size_t tile) const
    {
        return 1 + (y * shape_.width + x) * static_cast<int>(list_.tiles.size()) + static_cast<int>(tile);
    }

    /// Neighbours that do not fit are not both there. Several tiles in a cell would do no harm: each of them fits all
    /// tiles around it, so that any one of them will do.
    void fit(int x, int y, int next_x, int next_y, Color WangTile::*edge, Color WangTile::*facing)
    {
        for (std::size_t tile = 0; tile < list_.tiles.size(); ++tile)
            for (std::size_t next = 0; next < list_.tiles.size(); ++next)
                if (list_.tiles[tile].*edge != list_.tiles[next].*facing) {
                    solver_.add(-variable(x, y, tile));
                    solver_.add(-variable(next_x, next_y, next));
                    solver_.add(0);
                }
    }

    const WangList& list_;
    SatShape shape_;
    CaDiCaL::Solver solver_;
};

}
