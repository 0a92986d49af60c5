// Points of a sphere that is tiled with polyominoes, over the twelve squares of HEALPix.
//
// Ostromoukhov, part IV of the SIGGRAPH 2008 class notes (slides): polyominoes on the sphere by HEALPix, whose squares
// are divided into parts of equal area. The slides say no more. Here tiles go on across the borders of squares: the
// lattices of neighbouring squares fit, turned by quarters near the poles, so that the tiling, the divisions and the
// table of corrections are those of the plane all over the sphere but at the eight vertices of three squares. Tiles
// there take the corrections of the neighbourhood of the plane that has the most tiles in common with theirs.
#pragma once

#include "tiles/polyominoes/polyomino_points.hpp"
#include "tiles/sphere/healpix.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace poissonlab {

class PolyominoSphere : public PolyominoTiles
{
public:
    /// The tiling before divisions is random. `table` must outlive this. Throws InputError where no tiling was found.
    PolyominoSphere(const PolyominoTable& table, std::uint64_t seed, std::uint32_t realization);

    /// Cells along each side of a square before divisions: the least number for which there are tilings that cross the
    /// borders.
    static constexpr std::uint32_t side_of(Polyomino shape) { return shape == Polyomino::P ? 5 : 3; }

    /// The point of a tile with the corrections of a row, and the place that these start from.
    HealpixPlace point(const LevelTile& tile, std::uint32_t level, std::uint32_t row) const
    {
        return on_sphere(point_units(tile, row), level);
    }
    HealpixPlace middle(const LevelTile& tile, std::uint32_t level) const
    {
        return on_sphere(middle_units(tile), level);
    }

    /// The number, in first_tiles(), of the tile that has a place.
    std::uint32_t first_tile_at(const HealpixPlace& place) const;

    /// Tiles among first_tiles() whose neighbourhood no tiling of the plane has: they lie at vertices of three squares.
    const std::vector<std::uint32_t>& strange_tiles() const { return strange_; }

private:
    struct CellOwner
    {
        std::uint32_t tile = 0;
        Pose pose; ///< of the tile in the lattice of the cell's square
    };

    HealpixPlace on_sphere(const LatticePlace& units, std::uint32_t level) const;
    void find_owners();
    Collar collar_of(std::uint32_t tile) const;
    void classify();
    void order_roots(std::uint64_t seed, std::uint32_t realization);

    std::int64_t first_side_; ///< cells along each side of a square after the first divisions
    std::vector<CellOwner> owners_;
    std::vector<std::uint32_t> strange_;
};

/// Exactly `points` points, evenly. Two of them that have none of the eight vertices of three squares between them are
/// apart by proven_distance() times least_healpix_stretch() at least, along the sphere.
std::vector<SpherePlace> polyomino_points(const PolyominoSphere& sphere, std::size_t points);

/// Points that follow a density: `wanted` says how many points the whole sphere would have with the density at a place.
/// Nowhere may it be more than `values`.
std::vector<SpherePlace> polyomino_points(const PolyominoSphere& sphere, std::uint64_t values,
                                          const std::function<double(const SpherePlace& place)>& wanted);

}
