// The search for periods: rows that close after some number of tiles, stacked until nothing fits.
//
// The graph of all closed rows of w tiles decides for all heights and shears at once. Without a cycle no tiling has the
// period (w, 0), and the longest path is the tallest cylinder of that circumference; a cycle is a tiling with two
// periods. A set with any period has one along the rows (Wang), but for no width does a search prove that there is none
// at all.
#pragma once

#include "tiles/aperiodic/tile_list.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace poissonlab {

enum class CylinderAxis
{
    horizontal, ///< rows close, period (w, 0)
    vertical    ///< columns close, period (0, w)
};

/// A rectangle of tiles that repeats: along rows, copies lie side by side; the copy below is moved `shear` tiles to the
/// east. Along columns: copies lie one below the other, and the copy to the east is moved `shear` tiles to the south.
struct PeriodicTiling
{
    CylinderAxis axis = CylinderAxis::horizontal;
    std::size_t width = 0;
    std::size_t height = 0;
    std::size_t shear = 0;
    std::vector<ListPlace> tiles; ///< row after row, north first

    /// The tile at any place of the plane to the east and south of the first.
    ListPlace at(std::size_t x, std::size_t y) const
    {
        const bool is_horizontal = axis == CylinderAxis::horizontal;
        const std::size_t moved_x = is_horizontal ? x + y / height * (width - shear) : x;
        const std::size_t moved_y = is_horizontal ? y : y + x / width * (height - shear);
        return tiles[moved_y % height * width + moved_x % width];
    }
};

/// The tallest cylinder of a circumference.
struct Cylinder
{
    std::size_t height = 0;                 ///< in rows (columns); 0: no row closes. Without meaning where it repeats
    std::optional<PeriodicTiling> period{}; ///< the tiling that repeats, where cylinders are of any height
};

/// Searches one circumference >= 1. Throws InputError for more rows than a RowGraph holds, and Interrupted.
Cylinder longest_cylinder(const WangList& list, std::size_t circumference, CylinderAxis axis);

struct PeriodSearch
{
    /// The heights of the longest cylinders of circumferences 1, 2, ...; those of an axis end before the first
    /// circumference that has cylinders of any height.
    std::vector<std::size_t> horizontal_heights;
    std::vector<std::size_t> vertical_heights;
    std::optional<PeriodicTiling> period; ///< the first that was found
};

/// Searches the circumferences 1 to `widest` along both axes, along each up to its first period. Calls `on_step` with
/// what is known after each circumference. Throws as longest_cylinder().
PeriodSearch search_periods(const WangList& list, std::size_t widest,
                            const std::function<void(const PeriodSearch& search)>& on_step = {});

// Rows of Wang tiles as a graph: the words of colours on the north and south of a row are its nodes, and rows lead from
// one to the other. Rows stack where the south of one is the north of the next.
//
// It is what counts blocks and finds cylinders; Jeandel and Rao, An aperiodic set of 11 Wang tiles, 2015, section 1.1,
// call the rows a transducer.

/// The most rows of a graph.
inline constexpr std::size_t max_graph_rows = std::size_t{1} << 25;

/// The colours of a word, west first, as the digits of a number in base `colors`, of which the first one is the last
/// digit.
__extension__ using WordNumber = unsigned __int128;

std::vector<Color> colors_of_word(WordNumber word, std::size_t width, Color colors);

struct RowGraph
{
    std::vector<WordNumber> words;    ///< different ones
    std::vector<std::uint32_t> north; ///< of each row, the place of the word on its north
    std::vector<std::uint32_t> south;

    std::size_t rows() const { return north.size(); }
};

/// All rows that go around a cylinder: the last tile fits to the west of the first. Rows that are rotations of each
/// other are one row, and so are words: each is there as its smallest rotation, because any row that fits below a word
/// fits, rotated, below its rotations. Throws InputError for more than max_graph_rows rows, and for words that have no
/// number of 128 bits; and Interrupted.
RowGraph closed_rows(const WangList& list, std::size_t width);

}
