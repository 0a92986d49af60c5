// Dart throwing, plain and sequential: what the kernels must reproduce.
#include "host/sampling/dart_throwing.hpp"
#include "host/sampling/cells/cell_hierarchy.hpp"
#include "host/sampling/reference/dart_grid.hpp"
#include "host/sampling/reference/request_land.hpp"

#include <algorithm>

namespace poissonlab::reference {
namespace {

template <int D>
class Throwing
{
public:
    explicit Throwing(const DartThrowingRequest& request)
        : request_(request), hierarchy_(cell_hierarchy(request.min_distance, D)),
          block_(request.bricks ? DartBlock{{}, hierarchy_.size}
                                : request.block.value_or(DartBlock{{}, hierarchy_.size})),
          grid_(block_.size, hierarchy_.reach, squared_threshold(request.min_distance), request.bricks != nullptr)
    {}

    std::vector<OrderedDart<D>> run()
    {
        const std::size_t target = request_.points.value_or(SIZE_MAX);
        std::vector<Cell<D>> open = all_cells();
        int level = 0;
        for (std::uint32_t batch = 0; batch < request_.most_batches && points_.size() < target && !open.empty();
             ++batch) {
            thresholds_ = poisson_thresholds(darts_per_cell(batch, D));
            const bool split = splits_cells(batch) && level < hierarchy_.last_level;
            if (split) ++level;
            std::vector<Dart<D>> darts;
            open = split_and_throw(open, split, level, batch, darts);
            std::sort(darts.begin(), darts.end());
            for (const Dart<D>& dart : darts) {
                if (grid_.conflicts(dart.position, dart.cell)) continue;
                grid_.insert(dart.position, dart.cell);
                OrderedDart<D> point{batch, dart.time};
                std::copy(dart.position.begin(), dart.position.end(), point.begin() + 2);
                points_.push_back(point);
            }
        }
        return points_;
    }

private:
    /// The cells of the request's bricks.
    std::vector<Cell<D>> cells_of_bricks() const
    {
        const DartBricks& bricks = *request_.bricks;
        const std::uint32_t side = brick_side(D);
        std::vector<Cell<D>> cells;
        for (std::size_t i = 0; i < bricks.cells(); ++i) {
            const std::size_t brick = i / contract::dart_throwing::BRICK_CELLS;
            Cell<D> cell;
            std::size_t digits = i;
            for (int k = 0; k < D; ++k, digits /= side)
                cell[k] =
                    bricks.corners[brick * D + static_cast<std::size_t>(k)] + static_cast<std::uint32_t>(digits % side);
            cells.push_back(cell);
        }
        return cells;
    }

    /// All cells of level 0 that darts fall into.
    std::vector<Cell<D>> all_cells() const
    {
        if (request_.bricks) return cells_of_bricks();
        std::vector<Cell<D>> cells;
        Cell<D> in_grid{};
        for (;;) {
            Cell<D> cell;
            for (int k = 0; k < D; ++k)
                cell[k] = static_cast<std::uint32_t>((std::uint64_t{in_grid[k]} + block_.first[k]) % hierarchy_.size);
            cells.push_back(cell);
            int k = 0;
            while (k < D && ++in_grid[k] == block_.size) in_grid[k++] = 0;
            if (k == D) return cells;
        }
    }

    /// The cell of the grid that a cell of a level lies in.
    Cell<D> base_of(const Cell<D>& cell, int level) const
    {
        Cell<D> base;
        for (int k = 0; k < D; ++k)
            base[k] = ((cell[k] >> level) + (hierarchy_.size - block_.first[k])) % hierarchy_.size;
        return base;
    }

    Box<D> box_of(const Cell<D>& cell, int level) const
    {
        Box<D> box;
        for (int k = 0; k < D; ++k) {
            const std::uint64_t low = hierarchy_.lower_bound(cell[k], level);
            const std::uint64_t high = hierarchy_.lower_bound(std::uint64_t{cell[k]} + 1, level);
            box.low[k] = static_cast<std::uint32_t>(low);
            box.extent[k] = static_cast<std::uint32_t>(high - low - 1);
        }
        return box;
    }

    /// At the last level single coordinates are looked at, so that saturation is exact.
    bool closed(const Box<D>& box, const Cell<D>& base, int level) const
    {
        if (level < hierarchy_.last_level) return grid_.covers(box, base) || is_outside(box);
        for (int corner = 0; corner < 1 << D; ++corner) {
            TorusPoint<D> position = box.low;
            for (int k = 0; k < D; ++k) {
                if (corner >> k & 1) position[k] += box.extent[k];
            }
            if (!grid_.conflicts(position, base) && is_allowed(position)) return false;
        }
        return true;
    }

    bool is_outside(const Box<D>& box) const
    {
        TorusPoint<D> high = box.low;
        for (int k = 0; k < D; ++k) high[k] += box.extent[k];
        const auto& land = land_of<D>(request_);
        return land && land->side_of({box.low, high}) == RegionSide::outside;
    }

    bool is_allowed(const TorusPoint<D>& position) const
    {
        const auto& land = land_of<D>(request_);
        return !land || land->contains(position);
    }

    /// Replaces the open cells, or their children, by those that are still open, and draws the darts of the
    /// batch there.
    std::vector<Cell<D>> split_and_throw(const std::vector<Cell<D>>& parents, bool split, int level,
                                         std::uint32_t batch, std::vector<Dart<D>>& darts) const
    {
        std::vector<Cell<D>> open;
        for (const Cell<D>& parent : parents) {
            const auto counts = dart_counts(parent, batch);
            for (std::size_t c = 0; c < (split ? std::size_t{1} << D : 1); ++c) {
                Cell<D> child = parent;
                for (int k = 0; split && k < D; ++k) child[k] = 2 * parent[k] + (c >> k & 1);
                const Cell<D> base = base_of(child, level);
                const Box<D> box = box_of(child, level);
                if (closed(box, base, level)) continue;
                open.push_back(child);
                for (std::uint32_t i = 0; i < counts[c]; ++i) {
                    const Dart<D> dart = draw(child, base, box, batch, i);
                    if (is_allowed(dart.position)) darts.push_back(dart);
                }
            }
        }
        return open;
    }

    /// The number of darts in each child: one random word each, from the parent's own counters.
    std::array<std::uint32_t, 1 << D> dart_counts(const Cell<D>& parent, std::uint32_t batch) const
    {
        std::array<std::uint32_t, 1 << D> counts;
        for (std::uint32_t c = 0; c < 1 << D; c += 4) {
            const auto words = random_words(parent, batch, 0xfffc + c / 4);
            for (std::uint32_t i = 0; i < 4; ++i) {
                counts[c + i] = static_cast<std::uint32_t>(std::count_if(
                    thresholds_.begin(), thresholds_.end(), [&](std::uint32_t t) { return t <= words[i]; }));
            }
        }
        return counts;
    }

    Dart<D> draw(const Cell<D>& cell, const Cell<D>& base, const Box<D>& box, std::uint32_t batch,
                 std::uint32_t number) const
    {
        const auto words = random_words(cell, batch, number);
        Dart<D> dart{words[0], box.low, base};
        for (int k = 0; k < D; ++k) {
            const std::uint64_t width = std::uint64_t{box.extent[k]} + 1;
            dart.position[k] += static_cast<std::uint32_t>((words[k + 1] * width) >> 32);
        }
        return dart;
    }

    std::array<std::uint32_t, 4> random_words(const Cell<D>& cell, std::uint32_t batch, std::uint32_t number) const
    {
        std::array<std::uint32_t, 4> counter{};
        std::copy(cell.begin(), cell.end(), counter.begin());
        counter[3] = batch << 16 | number;
        return philox(counter, request_.stream);
    }

    DartThrowingRequest request_;
    CellHierarchy hierarchy_;
    DartBlock block_;
    std::vector<std::uint32_t> thresholds_; ///< of the batch at hand
    DartGrid<D> grid_;
    std::vector<OrderedDart<D>> points_;
};

template <int D>
PointSet points_of(const DartThrowingRequest& request)
{
    const std::vector<OrderedDart<D>> darts = Throwing<D>(request).run();
    PointSet set{D, {}};
    for (const OrderedDart<D>& dart : std::span(darts).first(std::min(darts.size(), request.points.value_or(SIZE_MAX))))
        for (int k = 0; k < D; ++k) set.coordinates.push_back(dart[k + 2] * 0x1p-32);
    return set;
}

}

template <int D>
std::vector<OrderedDart<D>> ordered_darts(const DartThrowingRequest& request)
{
    return Throwing<D>(request).run();
}

template std::vector<OrderedDart<2>> ordered_darts<2>(const DartThrowingRequest& request);
template std::vector<OrderedDart<3>> ordered_darts<3>(const DartThrowingRequest& request);

PointSet throw_darts(const DartThrowingRequest& request)
{
    return request.dimension == 2 ? points_of<2>(request) : points_of<3>(request);
}

}
