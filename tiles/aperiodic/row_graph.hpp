// Rows of Wang tiles as a graph: the words of colours on the north and south of a row are its nodes, and rows lead from
// one to the other. Rows stack where the south of one is the north of the next.
//
// It is what counts blocks and finds cylinders; Jeandel and Rao, An aperiodic set of 11 Wang tiles, 2015, section 1.1,
// call the rows a transducer.
#pragma once

#include "tiles/aperiodic/tile_list.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace poissonlab {

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
