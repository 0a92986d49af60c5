#include "tiles/packing/closed_packing.hpp"

#include "base/errors/errors.hpp"

#include <array>
#include <cmath>

namespace poissonlab {
namespace {

/// The largest integer whose square is at most n; n < 2^32 is exact as a double, and so is its root where it is one.
Color integer_root(Color n) { return static_cast<Color>(std::sqrt(static_cast<double>(n))); }

/// Rows of the packing of two colours, y upwards: what the lowest digit of a corner's colour is.
constexpr std::array<std::array<Color, 4>, 4> low_digits{{{0, 0, 0, 1}, {0, 0, 1, 0}, {1, 0, 1, 1}, {0, 1, 1, 1}}};

/// 4 (y mod 4) + (x mod 4) of the four low digits (y, x) + 2 (y, x + 1) + 4 (y + 1, x) + 8 (y + 1, x + 1).
constexpr std::array<Color, 16> place_of_low_digits{0, 3, 12, 13, 4, 15, 2, 11, 1, 8, 5, 14, 7, 6, 9, 10};

/// Even rows hold the digits of the row's number a = floor(y / 4) in base C / 2, low where x is even and high where it
/// is odd; odd rows those of the column's number b.
Color even_corner_color(PackingPlace place, Color colors)
{
    const Color base = colors / 2;
    const Color number = (place.y % 2 == 0 ? place.y : place.x) / 4;
    const Color digit = place.x % 2 == 0 ? number % base : number / base;
    return low_digits[place.y % 4][place.x % 4] + 2 * digit;
}

/// The corners of a tile by where they are: (0, 0) is the lower left one, x first.
std::array<std::array<Color, 2>, 2> corners_of(const CornerTile& tile)
{
    return {{{tile.south_west, tile.south_east}, {tile.north_west, tile.north_east}}};
}

PackingPlace place_among_even(const CornerTile& tile, Color colors)
{
    const auto corner = corners_of(tile);
    const Color base = colors / 2, numbers = base * base;
    const Color low = place_of_low_digits[corner[0][0] % 2 + 2 * (corner[0][1] % 2) + 4 * (corner[1][0] % 2) +
                                          8 * (corner[1][1] % 2)];
    const Color low_x = low % 4, low_y = low / 4;
    const Color even_row = low_y % 2, even_column = low_x % 2; // of the window: where the even one of two is
    const auto digit = [&](Color row, Color column) { return corner[row][column] / 2; };
    // The row above y = 3 mod 4 belongs to the next number; the column beyond x = 3 mod 4 likewise.
    const Color next_a = digit(even_row, even_column) + base * digit(even_row, 1 - even_column);
    const Color a = low_y == 3 ? (next_a + numbers - 1) % numbers : next_a;
    const Color of_even_column = digit(1 - even_row, even_column);
    const Color b_low = low_x == 3 ? (of_even_column + base - 1) % base : of_even_column;
    const Color b = b_low + base * digit(1 - even_row, 1 - even_column);
    return {4 * b + low_x, 4 * a + low_y};
}

/// The shift of column x: 0 + 1 + ... + (x - 1).
Color shift_of_column(Color x, Color period)
{
    return static_cast<Color>((std::uint64_t{x} * (std::uint64_t{x} + 1) / 2 - x) % period);
}

PackingPlace place_among_odd(const CornerTile& tile, Color colors)
{
    const Color period = colors * colors;
    const Color west = euler_place(tile.south_west, tile.north_west, colors);
    const Color east = euler_place(tile.south_east, tile.north_east, colors);
    const Color x = (east + period - west) % period;
    return {x, (west + period - shift_of_column(x, period)) % period};
}

}

Color euler_color(Color n, Color colors)
{
    // Block i begins at C^2 - (C - i)^2: i, then i and j by turns for j = i + 1, ..., C - 1.
    const Color left = colors * colors - n;
    const Color root = integer_root(left);
    const Color i = colors - (root * root == left ? root : root + 1);
    const Color within = n - i * (2 * colors - i);
    return within % 2 == 1 ? i : i + within / 2;
}

Color euler_place(Color first, Color second, Color colors)
{
    const auto block = [&](Color i) { return i * (2 * colors - i); };
    if (first == colors - 1) return second == 0 ? colors * colors - 1 : block(second) - 1;
    if (first == second) return block(first);
    return first < second ? block(first) + 2 * (second - first) - 1 : block(second) + 2 * (first - second);
}

Color wei_place(Color west, Color east)
{
    if (west == east) return west == 0 ? 0 : (west + 1) * (west + 1) - 2;
    if (west < east) return east * east + 2 * west;
    return east == 0 ? (west + 1) * (west + 1) - 1 : west * west + 2 * east - 1;
}

Color wei_color(Color place)
{
    // Places k^2, ..., (k + 1)^2 - 1 hold the dominoes with k as larger colour: 0 k, k 1, 1 k, k 2, ..., k k, k 0.
    const Color k = integer_root(place);
    const Color within = place - k * k;
    return within % 2 == 0 && within < 2 * k ? within / 2 : k;
}

Color packed_corner_color(PackingPlace place, Color colors)
{
    if (colors % 2 == 0) return even_corner_color(place, colors);
    const Color period = colors * colors;
    return euler_color((place.y + shift_of_column(place.x, period)) % period, colors);
}

TileIndex packed_tile(TileKind kind, PackingPlace place, Color colors)
{
    const Color side = colors * colors;
    const Color east = (place.x + 1) % side, north = (place.y + 1) % side;
    if (kind == TileKind::wang)
        return wang_index({wei_color(north), wei_color(east), wei_color(place.y), wei_color(place.x)},
                          {colors, colors});
    return corner_index({packed_corner_color({east, north}, colors), packed_corner_color({east, place.y}, colors),
                         packed_corner_color(place, colors), packed_corner_color({place.x, north}, colors)},
                        colors);
}

PackingPlace place_of_tile(TileKind kind, TileIndex tile, Color colors)
{
    if (kind == TileKind::wang) {
        const WangTile t = wang_tile(tile, {colors, colors});
        return {wei_place(t.west, t.east), wei_place(t.south, t.north)};
    }
    const CornerTile t = corner_tile(tile, colors);
    return colors % 2 == 0 ? place_among_even(t, colors) : place_among_odd(t, colors);
}

TilePacking closed_packing(TileKind kind, Color colors)
{
    constexpr Color most = 32;
    if (colors < 2 || colors > most)
        throw InputError("colors = " + std::to_string(colors) + ": must be an integer from 2 to " +
                         std::to_string(most));
    TilePacking packing{kind, colors, {}};
    for (Color y = 0; y < packing.side(); ++y)
        for (Color x = 0; x < packing.side(); ++x) packing.tiles.push_back(packed_tile(kind, {x, y}, colors));
    return packing;
}

}
