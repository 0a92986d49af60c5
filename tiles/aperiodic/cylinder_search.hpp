// The search for periods: rows that close after some number of tiles, stacked until nothing fits.
//
// The graph of all closed rows of w tiles decides for all heights and shears at once. Without a cycle no tiling has the
// period (w, 0), and the longest path is the tallest cylinder of that circumference; a cycle is a tiling with two
// periods. A set with any period has one along the rows (Wang), but for no width does a search prove that there is none
// at all.
#pragma once

#include "tiles/aperiodic/tile_list.hpp"

#include <cstddef>
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

}
