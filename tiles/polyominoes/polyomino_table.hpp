// The table of corrections: where the point of each tile is, for every threshold and every neighbourhood.
//
// Ostromoukhov, Sampling with polyominoes, 2007: a sample per polyomino, kept by comparing its code with a threshold,
// and displaced by a table that structural index and importance look up. How digits, index and table of the paper are
// made is not published; here the index is the class of a tile's neighbourhood some divisions ago with the way from
// there, a row is a part of these ways that have points, and points are relaxed in all neighbourhoods at once that
// tilings can have (see neighbourhoods.hpp), so that the least distance of every row is known exactly, of tilings of
// the whole plane.
#pragma once

#include "tiles/polyominoes/neighbourhoods.hpp"
#include "tiles/polyominoes/point_pairs.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

// The frequencies of neighbourhoods and pairs of tiles, by the automaton.

/// Frequencies per tile after a few divisions of tiles that had all classes, and all pairs, equally often: of the
/// classes, then of the pairs. Those that last occur as often as in the long run, within some percent; those that die
/// out are there still.
std::vector<double> frequencies_of(const Neighbourhoods& neighbourhoods);

// The order in which the children of a polyomino get points.

/// Greedy farthest points: the first child is the one whose copies keep the largest distance in all tilings, each
/// further one is the farthest from copies of all before and of its own. Middles of tiles decide, ties go to the lower
/// number.
std::vector<std::uint32_t> farthest_children(const Neighbourhoods& neighbourhoods);

/// Reorders the children of neighbourhoods.
Neighbourhoods with_children_in_order(const Neighbourhoods& neighbourhoods, const std::vector<std::uint32_t>& order);

/// Units of positions, in a cell.
inline constexpr std::int64_t cell_units = 4096;

/// A displacement in the frame of its tile, in units.
using Correction = std::array<std::int16_t, 2>;

/// Divisions between the tiles whose neighbourhoods the table is about and the tiles that have points.
constexpr std::uint32_t table_depth_of(Polyomino shape) { return shape == Polyomino::P ? 2 : 1; }

/// The proof about a row: two points have at least this distance, over all tilings of the plane and of tori whose
/// tiles have been divided so often, whatever they were before. Points are few in the first rows, and further ancestors
/// have to be known.
///
/// Tiles that have been divided less often, down to the first level that the table is for, have fewer known ancestors.
/// The proof of them looks at all pairs of tiles that can be seen from each other, of which tilings may not have
/// all: it may be less.
struct RowProof
{
    std::uint64_t squared_distance = 0; ///< in squared units
    std::uint32_t divisions = 0;
    std::uint64_t squared_distance_before = 0; ///< after fewer divisions

    /// The squared distance after so many divisions.
    std::uint64_t squared_distance_after(std::uint32_t level) const
    {
        return level < divisions ? squared_distance_before : squared_distance;
    }
};

struct PolyominoTable
{
    Neighbourhoods neighbourhoods;             ///< children in the order in which they get points
    std::uint32_t depth = 1;                   ///< divisions between the classified ancestor and a tile
    std::vector<std::vector<Correction>> rows; ///< row M - 1, of tiles with numbers below M: [class * M + number]
    std::vector<RowProof> proofs;              ///< of row M - 1

    /// The number of rows: all tiles have points in the last one.
    std::uint32_t last_row() const { return static_cast<std::uint32_t>(rows.size()); }

    const Correction& correction(std::uint32_t row, std::uint32_t tile_class, std::uint64_t number) const
    {
        return rows[row - 1][tile_class * row + number];
    }
};

/// The place in a tile that corrections start from, next to its centroid, in units.
LatticePlace anchor_of(Polyomino shape);

/// The point of a tile, in units.
inline LatticePlace point_of(const Pose& tile, const LatticePlace& anchor, const Correction& correction)
{
    return turned(tile.turn, anchor + LatticePlace{correction[0], correction[1]}) + cell_units * tile.shift;
}

/// Told of the steps of building: what, how many are done, and how many there are. What it throws ends the work.
using PolyominoProgress = std::function<void(const std::string& what, std::size_t done, std::size_t total)>;

/// Builds the table from nothing: the rule, the neighbourhoods, the order of children, the corrections and the proof.
/// Always the same for a polyomino, on any machine and number of threads.
PolyominoTable build_polyomino_table(Polyomino shape, const PolyominoProgress& progress = {});

/// Proves the distance of a row by visiting all pairs of points that can be near.
RowProof proof_of_row(const PolyominoTable& table, std::uint32_t row);

/// The relative radius that this distance is of a row's density.
double proven_relative_radius(const PolyominoTable& table, std::uint32_t row);

// The corrections of a row of the table, by relaxation in all neighbourhoods at once.

/// Corrections [class * kept + number]: see relaxed_points(). Published tables were relaxed by Lloyd's method, in
/// patches. `frequencies`: see frequencies_of().
std::vector<Correction> relaxed_row(const KeptTiles& tiles, const std::vector<double>& frequencies);

// The table of corrections as a file, for the cache: only programs built from the same sources read it again.

/// Writes bytes and their checksum. Throws StorageError.
void write_with_checksum(const std::filesystem::path& file, const std::string& bytes);

/// Returns no value where the file is missing or damaged. Throws InputError where it cannot be read.
std::optional<std::string> read_with_checksum(const std::filesystem::path& file);

/// Throws StorageError.
void write_polyomino_table(const std::filesystem::path& file, const PolyominoTable& table);

/// No value where the file is missing, cannot be read, is damaged, or holds something else.
std::optional<PolyominoTable> read_polyomino_table(const std::filesystem::path& file);

}
