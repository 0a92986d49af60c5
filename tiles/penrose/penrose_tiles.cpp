#include "tiles/penrose/penrose_tiles.hpp"

namespace poissonlab {
namespace {

/// The tile of a kind at a place, turned from its parent by so many twentieths, with a pair of digits behind the code.
PenroseTile child(const PenroseTile& parent, PenroseKind kind, const RingPlace& place, std::uint32_t turn,
                  std::uint32_t pair)
{
    PenroseTile tile{place, parent.value, kind};
    tile.level = static_cast<std::uint8_t>(parent.level + 1);
    tile.direction = static_cast<std::uint8_t>((parent.direction + turn) % 20);
    tile.digits = static_cast<std::uint8_t>((parent.digits << 2 | pair) & 63);
    if (pair > 0) tile.value += fibonacci(2 * tile.level + (pair == 2 ? 1 : 0));
    return tile;
}

RingPlace second_corner(const PenroseTile& tile) { return corners_of(tile)[1]; }
RingPlace third_corner(const PenroseTile& tile) { return corners_of(tile)[2]; }

}

std::array<RingPlace, 3> corners_of(const PenroseTile& t)
{
    const bool is_fat = t.kind >= PenroseKind::fat;
    const std::uint32_t tenths = t.direction / 2U;
    const RingPlace first = unit_vector(tenths), other = unit_vector((tenths + (is_fat ? 1 : 2)) % 10);
    return {t.p1, t.p1 + (is_fat ? times_phi(times_phi(first)) : first), t.p1 + times_phi(other)};
}

PenroseChildren divided(const PenroseTile& tile)
{
    using enum PenroseKind;
    std::array<RingPlace, 3> p{times_phi(tile.p1), {}, {}};
    if (!is_point(tile)) {
        p = corners_of(tile);
        for (RingPlace& corner : p) corner = times_phi(corner);
    }
    switch (tile.kind) {
    case point:
        return {{child(tile, old_point, p[0], 0, 0)}, 1};
    case old_point:
        return {{child(tile, point, p[0], 10, 0)}, 1};
    case thin: {
        const PenroseTile f = child(tile, fat_twin, p[2], 14, 0);
        return {{child(tile, point, third_corner(f), 1, 2), f, child(tile, thin, p[1], 6, 2)}, 3};
    }
    case thin_twin: {
        const PenroseTile e = child(tile, fat, p[1], 6, 0);
        return {{e, child(tile, thin_twin, third_corner(e), 14, 2)}, 2};
    }
    case fat: {
        const PenroseTile c = child(tile, thin, p[2], 12, 2);
        return {{child(tile, point, second_corner(c), 7, 2), c, child(tile, fat, p[1], 8, 1),
                 child(tile, fat_twin, p[0], 0, 0)},
                4};
    }
    case fat_twin:
        break;
    }
    const PenroseTile f = child(tile, fat_twin, p[2], 12, 1), e = child(tile, fat, third_corner(f), 0, 0);
    return {{child(tile, point, third_corner(f), 15, 1), f, e, child(tile, thin_twin, third_corner(e), 8, 2)}, 4};
}

std::uint64_t fibonacci(int n)
{
    static constexpr auto numbers = [] {
        std::array<std::uint64_t, 94> f{0, 1};
        for (std::size_t i = 2; i < f.size(); ++i) f[i] = f[i - 1] + f[i - 2];
        return f;
    }();
    return numbers.at(static_cast<std::size_t>(n));
}

int structural_index(std::uint8_t digits)
{
    constexpr std::array<std::array<int, 3>, 3> weights{{{0, 8, 13}, {0, 3, 5}, {0, 1, 2}}};
    int index = 0;
    for (std::size_t i = 0; i < 3; ++i) index += weights[i][digits >> 2 * i & 3U];
    return index;
}

}
