#include "tiles/tilings/lattice_rows.hpp"

#include <algorithm>

namespace poissonlab {
namespace {

/// The number of steps from a coordinate to the last one.
std::uint64_t steps_to(std::int64_t last, std::int64_t from)
{
    return static_cast<std::uint64_t>(last) - static_cast<std::uint64_t>(from);
}

}

const std::uint8_t* LatticeRows::row(unsigned series, const ColorHash& hash, const PointRow& points)
{
    auto& kept = kept_[series];
    unsigned& newest = newest_[series];
    for (unsigned i = 0; i < 2; ++i) {
        if (kept[i].points != points) continue;
        newest = i;
        return kept[i].colors.data();
    }
    newest = 1 - newest;
    Row& row = kept[newest];
    row.points = points;
    if (row.colors.size() < points.count) row.colors.resize(points.count);
    evaluate(row, hash);
    return row.colors.data();
}

void LatticeRows::evaluate(Row& row, const ColorHash& hash) const
{
    const PointRow& points = row.points;
    std::span<std::uint8_t> left(row.colors.data(), points.count);
    std::int64_t x = points.x;
    std::visit(
        [&](const auto& h) {
            while (!left.empty()) {
                // One piece ends where a coordinate starts again: the tile's, the reduced one, or the lattice point's.
                const std::int64_t reduced = torus_.x(x);
                const std::int64_t first = stepped(points.scale == 2 ? doubled(reduced) : reduced, points.offset);
                std::uint64_t steps = std::min(steps_to(INT64_MAX, x), steps_to(INT64_MAX, first) / points.scale);
                if (torus_.period.x > 0) steps = std::min(steps, steps_to(torus_.period.x - 1, reduced));
                const std::size_t count = std::min<std::uint64_t>(left.size() - 1, steps) + 1;
                h.fill_row(first, points.scale, points.y, left.first(count));
                left = left.subspan(count);
                x = stepped(x, count);
            }
        },
        hash);
}

}
