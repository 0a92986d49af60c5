#include "host/sampling/optimized/listed_cells.hpp"

#include "kernels/common/optimized/sample_elimination.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace poissonlab {
namespace {

using namespace contract::sample_elimination;

template <int D>
class CellList
{
public:
    CellList(const PointSet& points, double reach, std::size_t most_tiles)
    {
        const double least = std::exp2(31 - axis_bits);
        width_ = static_cast<std::uint64_t>(std::clamp(std::ceil(reach * 0x1p32), least, 0x1p31));
        last_ = static_cast<std::int64_t>(0x7fffffff / width_);
        count_cells(points, most_tiles);
        sort(points);
        find_tiles();
        list_runs();
        list_around();
    }

    ListedCells take() { return std::move(list_); }

private:
    /// Bits of a cell's coordinate: keys have those of all axes, and a bit for each axis of the colour.
    static constexpr int axis_bits = D == 2 ? 30 : 20;
    using Coordinates = std::array<std::int64_t, D>;

    Coordinates cell_of(const PointSet& points, std::size_t i) const
    {
        Coordinates cell;
        for (std::size_t k = 0; k < D; ++k)
            cell[k] = static_cast<std::int64_t>(static_cast<std::uint64_t>(points[i][k] * 0x1p32) / width_);
        return cell;
    }

    /// Colour, tile, and cell in the tile: the last axis first in each. Tiles are 2^tile_bits_ cells wide.
    std::uint64_t key_of(const Coordinates& cell) const
    {
        std::uint64_t colour = 0, tile = 0, within = 0;
        for (std::size_t k = D; k-- > 0;) {
            const auto c = static_cast<std::uint64_t>(cell[k]);
            colour = colour << 1 | (c >> tile_bits_ & 1);
            tile = tile << (axis_bits - tile_bits_) | c >> tile_bits_;
            within = within << tile_bits_ | (c & ((1u << tile_bits_) - 1));
        }
        return colour << D * axis_bits | tile << D * tile_bits_ | within;
    }

    std::uint64_t tile_key(std::uint64_t key) const { return key >> D * tile_bits_; }

    Coordinates coordinates_of(std::uint64_t key) const
    {
        Coordinates cell{};
        std::uint64_t within = key, tile = tile_key(key);
        for (std::int64_t& c : cell) {
            const std::uint64_t rest = (1u << tile_bits_) - 1, tiles = (1u << (axis_bits - tile_bits_)) - 1;
            c = static_cast<std::int64_t>((tile & tiles) << tile_bits_ | (within & rest));
            within >>= tile_bits_;
            tile >>= axis_bits - tile_bits_;
        }
        return cell;
    }

    /// Chooses the width of tiles by the tiles that points are in.
    void count_cells(const PointSet& points, std::size_t most_tiles)
    {
        std::vector<std::uint64_t> tiles(points.size());
        for (std::size_t i = 0; i < tiles.size(); ++i) tiles[i] = tile_key(key_of(cell_of(points, i)));
        for (;;) {
            tbb::parallel_sort(tiles);
            tiles.erase(std::ranges::unique(tiles).begin(), tiles.end());
            if (tiles.size() <= most_tiles || tile_bits_ + 1 >= axis_bits) return;
            std::vector<Coordinates> corners;
            for (const std::uint64_t tile : tiles) corners.push_back(coordinates_of(tile << D * tile_bits_));
            ++tile_bits_;
            std::ranges::transform(corners, tiles.begin(), [&](const Coordinates& c) { return tile_key(key_of(c)); });
        }
    }

    void sort(const PointSet& points)
    {
        std::vector<std::pair<std::uint64_t, std::uint32_t>> sorted(points.size());
        for (std::uint32_t i = 0; i < sorted.size(); ++i) sorted[i] = {key_of(cell_of(points, i)), i};
        tbb::parallel_sort(sorted);
        for (const auto& [key, id] : sorted) {
            if (keys_.empty() || keys_.back() != key) {
                keys_.push_back(key);
                starts_.push_back(static_cast<std::uint32_t>(list_.ids.size()));
            }
            list_.ids.push_back(id);
            list_.cells.push_back(static_cast<std::uint32_t>(keys_.size() - 1));
        }
        starts_.push_back(static_cast<std::uint32_t>(points.size()));
    }

    void find_tiles()
    {
        list_.colour_starts.assign((std::size_t{1} << D) + 1, 0);
        for (std::size_t i = 0; i < keys_.size(); ++i) {
            if (!tiles_.empty() && tiles_.back() == tile_key(keys_[i])) continue;
            tiles_.push_back(tile_key(keys_[i]));
            list_.tile_starts.push_back(starts_[i]);
            ++list_.colour_starts[(keys_[i] >> D * axis_bits) + 1];
        }
        list_.tile_starts.push_back(starts_.back());
        for (std::size_t c = 1; c < list_.colour_starts.size(); ++c)
            list_.colour_starts[c] += list_.colour_starts[c - 1];
    }

    /// Calls what(row) for the row of cells and each row beside it: coordinates from the second one on differ by at
    /// most 1 and are from 0 to `last`.
    template <typename What>
    static void for_each_row_around(const Coordinates& row, std::int64_t last, const What& what)
    {
        for (int number = 0; number < (D == 2 ? 3 : 9); ++number) {
            Coordinates other = row;
            bool is_there = true;
            for (std::size_t k = 1, digits = static_cast<std::size_t>(number); k < D; ++k, digits /= 3) {
                other[k] += static_cast<std::int64_t>(digits % 3) - 1;
                is_there = is_there && other[k] >= 0 && other[k] <= last;
            }
            if (is_there) what(other);
        }
    }

    void list_runs()
    {
        list_.runs.assign(keys_.size() * 2 * RUNS(D), 0);
        tbb::parallel_for(std::size_t{0}, keys_.size(), [&](std::size_t cell) {
            std::uint32_t* next = &list_.runs[cell * 2 * RUNS(D)];
            for_each_row_around(coordinates_of(keys_[cell]), last_, [&](const Coordinates& row) {
                const std::int64_t last = std::min(row[0] + 1, last_);
                for (std::int64_t first = std::max<std::int64_t>(row[0] - 1, 0); first <= last;) {
                    const std::int64_t end = std::min(last, first | ((std::int64_t{1} << tile_bits_) - 1));
                    Coordinates from = row, to = row;
                    from[0] = first;
                    to[0] = end;
                    const auto begin = std::ranges::lower_bound(keys_, key_of(from));
                    const auto beyond = std::upper_bound(begin, keys_.end(), key_of(to));
                    *next++ = starts_[static_cast<std::size_t>(begin - keys_.begin())];
                    *next++ = starts_[static_cast<std::size_t>(beyond - keys_.begin())];
                    first = end + 1;
                }
            });
        });
    }

    void list_around()
    {
        list_.tiles_around.assign(tiles_.size() * TILES_AROUND(D), NO_TILE);
        const std::int64_t width = std::int64_t{1} << tile_bits_;
        for (std::size_t tile = 0; tile < tiles_.size(); ++tile) {
            std::uint32_t* next = &list_.tiles_around[tile * TILES_AROUND(D)];
            Coordinates at = coordinates_of(tiles_[tile] << D * tile_bits_);
            for (std::int64_t& c : at) c >>= tile_bits_;
            for_each_row_around(at, last_ >> tile_bits_, [&](const Coordinates& row) {
                for (std::int64_t x = std::max<std::int64_t>(row[0] - 1, 0);
                     x <= std::min(row[0] + 1, last_ >> tile_bits_); ++x) {
                    Coordinates corner = row;
                    corner[0] = x;
                    for (std::int64_t& c : corner) c *= width;
                    const auto found = std::ranges::lower_bound(tiles_, tile_key(key_of(corner)));
                    if (found != tiles_.end() && *found == tile_key(key_of(corner)))
                        *next++ = static_cast<std::uint32_t>(found - tiles_.begin());
                }
            });
        }
    }

    std::uint64_t width_ = 1; ///< of a cell, in positions
    std::int64_t last_ = 0;   ///< the last cell along each axis
    int tile_bits_ = 1;
    std::vector<std::uint64_t> keys_;   ///< of cells, ascending
    std::vector<std::uint32_t> starts_; ///< the first point of each, and the end
    std::vector<std::uint64_t> tiles_;  ///< keys of tiles
    ListedCells list_;
};

}

ListedCells listed_cells(const PointSet& points, double reach, std::size_t most_tiles)
{
    return points.dimension == 2 ? CellList<2>(points, reach, most_tiles).take()
                                 : CellList<3>(points, reach, most_tiles).take();
}

}
