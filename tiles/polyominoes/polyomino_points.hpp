// Point sets of a torus that is tiled with polyominoes: any number of points, or any density. The order of tiles is
// that of other surfaces as well (tiles/sphere).
//
// The torus is tiled at random, which is what realizations differ in, and divided. A tile's value is its code times the
// number of tiles in the beginning, plus its first ancestor's place in a random order; the tiles of the lowest values
// have points. Code: the sum of digit i times (k^2)^i, where digit i is the number of the child of division i. So a
// value says on which way to find its tile, and points are made independently of each other, in the order of their
// values.
#pragma once

#include "base/densities/density.hpp"
#include "base/geometry/point_set.hpp"
#include "tiles/polyominoes/polyomino_table.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace poissonlab {

/// The number of tiles of a surface, and which row of the table is for so many points.
struct PolyominoCounts
{
    /// The surface consists of squares with so many cells along each side.
    PolyominoCounts(Polyomino shape, std::uint32_t side, std::uint32_t squares = 1);

    /// Tiles at a level.
    std::uint64_t tiles(std::uint32_t level) const;

    /// The least level with at least so many tiles of which the table knows the neighbourhoods.
    std::uint32_t level_of(double points) const;

    /// The row of the table for so many points at a level, at least 1.
    std::uint32_t row_of(double points, std::uint32_t level) const;

    std::uint64_t roots = 0;    ///< tiles before divisions
    std::uint64_t children = 1; ///< of a tile
    std::uint32_t least_level = 0;
    std::uint32_t last_row = 1;
};

/// A tile at some level, which is a number of divisions.
struct LevelTile
{
    Pose pose;                    ///< in a surface of side * k^level cells; the shift may be outside
    std::uint32_t tile_class = 0; ///< of the ancestor that the table is about
    std::uint64_t number = 0;     ///< below that
};

/// A tile that has a point, and the level and the row for the density around it.
struct ChosenTile
{
    LevelTile tile;
    std::uint32_t level = 0;
    std::uint32_t row = 1;
};

/// The tiles of a surface at all levels, by their values.
class PolyominoTiles
{
public:
    const PolyominoTable& table() const { return table_; }
    const PolyominoCounts& counts() const { return counts_; }

    /// The tile of a value below counts().tiles(level). `level` is at least counts().least_level.
    LevelTile tile(std::uint64_t value, std::uint32_t level) const;

    /// The point of a tile with the corrections of this row, and the place that these start from, in units.
    LatticePlace point_units(const LevelTile& tile, std::uint32_t row) const;
    LatticePlace middle_units(const LevelTile& tile) const { return point_of(tile.pose, anchor_, {}); }

    /// The side of a square at a level, in units of cells.
    std::int64_t side_units(std::uint32_t level) const;

    /// The tile of a value where a density asks for a point: `wanted` says how many points the whole surface would have
    /// with the density around a tile of level `finest`, which decides, so that none is missing among points of that
    /// level. The tile is that of the level which is for so many points.
    std::optional<ChosenTile> chosen_tile(std::uint64_t value, std::uint32_t finest,
                                          const std::function<double(const LevelTile& tile)>& wanted) const;

    // The places of the roots in their order; tiles at the table's first level, those of a root one after the other;
    // and the classes of these.
    const std::vector<std::uint32_t>& order() const { return order_; }
    const std::vector<Pose>& first_tiles() const { return tiles_; }
    const std::vector<std::uint32_t>& first_classes() const { return classes_; }

protected:
    /// Divides `roots` up to the table's first level; classes and order are left to the surface. `table` must outlive
    /// this.
    PolyominoTiles(const PolyominoTable& table, std::uint32_t side, std::uint32_t squares,
                   const std::vector<Pose>& roots);
    ~PolyominoTiles() = default;

    std::uint32_t side_;
    std::vector<std::uint32_t> order_;
    std::vector<std::uint32_t> classes_;

private:
    const PolyominoTable& table_;
    PolyominoCounts counts_;
    LatticePlace anchor_;
    std::vector<Pose> tiles_;
};

class PolyominoTorus : public PolyominoTiles
{
public:
    /// Throws InputError where no tiling of `side` x `side` cells was found.
    PolyominoTorus(const PolyominoTable& table, std::uint32_t side, std::uint64_t seed, std::uint32_t realization);

    /// The place of a tile's point with the corrections of this row, 0 <= x, y < 1.
    std::array<double, 2> point(const LevelTile& tile, std::uint32_t level, std::uint32_t row) const
    {
        return on_torus(point_units(tile, row), level);
    }

    /// The place in a tile that its correction starts from, 0 <= x, y < 1.
    std::array<double, 2> middle(const LevelTile& tile, std::uint32_t level) const
    {
        return on_torus(middle_units(tile), level);
    }

private:
    std::array<double, 2> on_torus(const LatticePlace& units, std::uint32_t level) const;
};

/// Exactly `points` points, evenly: a part of those of a row of the table.
PointSet polyomino_points(const PolyominoTorus& torus, std::size_t points);

/// The distance that the table proves of so many points, in sides of the surface's squares.
double proven_distance(const PolyominoTiles& tiles, std::size_t points);

/// About `points` points that follow a density over the torus. A value has a point where the density at its tile
/// exceeds it: that of the level and the row that are for so many points. A density that is the same everywhere has the
/// points of none; of others no distance is proven, and those of neighbouring levels may lie close to each other.
PointSet polyomino_points(const PolyominoTorus& torus, std::size_t points, const Density& density);

/// The largest number of values that is looked through for a density.
inline constexpr double most_polyomino_values = 1 << 26;

/// The number of values that are looked through for so many points of a density: those of its densest place.
double polyomino_values(std::size_t points, const Density& density);

}
