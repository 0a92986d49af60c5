#include "host/tile_sampling/penrose/penrose_walk.hpp"

#include <algorithm>

namespace poissonlab {
namespace {

using namespace contract::penrose;

constexpr std::int64_t fixed_one = std::int64_t{1} << FRACTION_BITS;
constexpr int unit_shift = FRACTION_BITS - UNIT_BITS;

FixedPlace fixed_place(const RingPlace& place, const PenroseScale& scale)
{
    FixedPlace sum = penrose_root;
    for (std::size_t k = 0; k < 4; ++k) {
        sum[0] += place.c[k] * scale.axis_x[k];
        sum[1] += place.c[k] * scale.axis_y[k];
    }
    return sum;
}

/// The nearest place of the density's square.
DensityPlace in_square(const FixedPlace& place)
{
    const auto unit = [](std::int64_t c) {
        return static_cast<std::uint32_t>(std::clamp<std::int64_t>(c, 0, fixed_one - 1) >> unit_shift);
    };
    return {unit(place[0]), unit(place[1])};
}

}

PenroseTile tile_of(const Tile& record)
{
    PenroseTile tile;
    std::ranges::copy(record.place, tile.p1.c.begin());
    tile.value = record.value;
    tile.kind = static_cast<PenroseKind>(record.kind);
    tile.direction = static_cast<std::uint8_t>(record.direction);
    tile.digits = static_cast<std::uint8_t>(record.digits);
    tile.level = static_cast<std::uint8_t>(record.level);
    return tile;
}

Tile record_of(const PenroseTile& tile)
{
    Tile record{{}, tile.value, static_cast<uint>(tile.kind), tile.direction, tile.digits, tile.level};
    std::ranges::copy(tile.p1.c, record.place);
    return record;
}

std::uint64_t PenroseWalk::importance_at(std::uint64_t weight) const
{
    __extension__ using Wide = unsigned __int128;
    return static_cast<std::uint64_t>(Wide{importance_} * weight / full_weight);
}

bool PenroseWalk::needs(const PenroseTile& triangle) const
{
    const PenroseScale& scale = tiling_.scales[triangle.level];
    FixedPlace low{INT64_MAX, INT64_MAX}, high{INT64_MIN, INT64_MIN};
    for (const RingPlace& corner : corners_of(triangle)) {
        const FixedPlace place = fixed_place(corner, scale);
        for (std::size_t k = 0; k < 2; ++k) {
            low[k] = std::min(low[k], place[k]);
            high[k] = std::max(high[k], place[k]);
        }
    }
    for (std::size_t k = 0; k < 2; ++k) {
        const std::int64_t begin = std::int64_t{window_.low[k]} << unit_shift;
        const std::int64_t end = begin + static_cast<std::int64_t>(window_.side << unit_shift);
        if (high[k] + scale.reach < begin || low[k] - scale.reach >= end) return false;
    }
    // Rounding may put points a little outside of their triangle.
    constexpr std::int64_t rounding = std::int64_t{1} << 26;
    for (std::size_t k = 0; k < 2; ++k) {
        low[k] -= rounding;
        high[k] += rounding;
    }
    // Points of the next level have this value at least.
    const std::uint64_t least = tiling_.scales[triangle.level + 1U].ones[0];
    return importance_at(tiling_.density.over(in_square(low), in_square(high))) > least;
}

FixedPlace StayingPoint::moved(const PenroseVector& vector, const PenroseScales& scales) const
{
    const PenroseScale& scale = scales[row.level];
    const std::size_t left = (direction + TURNS / 4) % TURNS;
    return {corner[0] + vector.along * scale.turn_x[direction] + vector.left * scale.turn_x[left],
            corner[1] + vector.along * scale.turn_y[direction] + vector.left * scale.turn_y[left]};
}

std::optional<StayingPoint> PenroseWalk::staying(const PenroseTile& point) const
{
    const FixedPlace corner = fixed_place(point.p1, tiling_.scales[point.level]);
    const std::uint64_t importance = importance_at(tiling_.density.at(in_square(corner)));
    if (point.value >= importance) return std::nullopt;
    // The point stays as it is, but for its frame, down to the level of the importance.
    const PenroseRow row = row_of_importance(tiling_.scales, importance);
    const std::size_t older = row.level - point.level;
    const auto digits = static_cast<std::uint8_t>(older < 3 ? point.digits << 2 * older & 63 : 0);
    return StayingPoint{corner, row, static_cast<std::size_t>(structural_index(digits)),
                        (point.direction + older / 2 * 10) % TURNS};
}

void PenroseWalk::keep(const PenroseTile& point, std::vector<PenrosePoint>& points) const
{
    const auto found = staying(point);
    if (!found) return;
    const FixedPlace place = found->moved(tiling_.table.rows[found->row.row][found->index], tiling_.scales);
    PenrosePoint kept{{}, point.value};
    for (std::size_t k = 0; k < 2; ++k) {
        const std::int64_t unit = place[k] >> unit_shift;
        if (unit < std::int64_t{window_.low[k]} ||
            unit >= std::int64_t{window_.low[k]} + static_cast<std::int64_t>(window_.side))
            return;
        kept.place[k] = static_cast<std::uint32_t>(unit);
    }
    points.push_back(kept);
}

}
