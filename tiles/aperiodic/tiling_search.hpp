// Tilings with any set, by search: cells are given tiles one after the other, and what no longer fits anywhere is left
// out at once.
//
// Each cell keeps the tiles that may be there. Whenever tiles are taken away, those of its neighbours that fit beside
// none of the rest go as well (Mackworth, Consistency in networks of relations, 1977). Where a cell has none left, the
// last choice was wrong. The search begins again with other choices when it has gone wrong often, as backtracking that
// was wrong early never ends.
#pragma once

#include "tiles/aperiodic/tile_list.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace poissonlab {

/// The largest set and rectangle that are searched.
inline constexpr std::size_t max_searched_tiles = 2048;
inline constexpr std::size_t max_searched_cells = 65'536;

struct SearchedRectangle
{
    std::size_t width = 1;
    std::size_t height = 1;
    std::uint64_t seed = 1;
    std::size_t trials = 64; ///< how often the search may begin
};

/// The tiles of a rectangle, rows from north to south; nothing where no trial came to an end. That there is none is not
/// known then, except where `proven` is set: then the first trial has gone through everything. Calls `on_step` with the
/// trial now and then. Throws InputError for sets and rectangles that are too large, and Interrupted.
std::optional<std::vector<ListPlace>> search_tiling(const WangList& list, const SearchedRectangle& rectangle,
                                                    bool* proven = nullptr,
                                                    const std::function<void(std::size_t trial)>& on_step = {});

}
