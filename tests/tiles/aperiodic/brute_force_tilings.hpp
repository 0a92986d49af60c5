// Rectangles of tiles found by trying everything, cell by cell: what counts and searches are held against.
#pragma once

#include "tiles/aperiodic/tile_list.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace poissonlab {

class TriedRectangles
{
public:
    /// With `is_closed`, the first column fits to the east of the last one.
    TriedRectangles(const WangList& list, std::size_t width, std::size_t height, bool is_closed = false)
        : list_(list), width_(width), height_(height), is_closed_(is_closed)
    {}

    std::uint64_t count() const
    {
        std::vector<std::size_t> cells;
        return count_from(cells);
    }

private:
    std::uint64_t count_from(std::vector<std::size_t>& cells) const
    {
        if (cells.size() == width_ * height_) return 1;
        const std::size_t x = cells.size() % width_;
        std::uint64_t sum = 0;
        for (std::size_t i = 0; i < list_.tiles.size(); ++i) {
            const WangTile& tile = list_.tiles[i];
            const auto at = [&](std::size_t back) { return list_.tiles[cells[cells.size() - back]]; };
            if (x > 0 && at(1).east != tile.west) continue;
            if (cells.size() >= width_ && at(width_).south != tile.north) continue;
            const WangTile& first = x == 0 ? tile : at(x);
            if (is_closed_ && x + 1 == width_ && tile.east != first.west) continue;
            cells.push_back(i);
            sum += count_from(cells);
            cells.pop_back();
        }
        return sum;
    }

    const WangList& list_;
    std::size_t width_, height_;
    bool is_closed_;
};

}
