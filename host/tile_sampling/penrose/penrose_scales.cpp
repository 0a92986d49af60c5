#include "host/tile_sampling/penrose/penrose_scales.hpp"

#include "tiles/penrose/penrose_tiles.hpp"

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

using namespace contract::penrose;

constexpr double root_scale = 2; ///< of level 0, in sides of the unit square
constexpr double golden_inverse = 0.6180339887498949;
constexpr double row_ratio = 1.0468929862265312; ///< phi^(2/21): as many of it lead from one level to the next

/// Cosines of multiples of 18 degrees.
constexpr std::array<double, 6> cosines{
    1, 0.95105651629515357, 0.80901699437494742, 0.58778525229247313, 0.30901699437494742, 0};

double cosine(std::size_t turn)
{
    turn %= 20;
    if (turn > 10) turn = 20 - turn;
    return turn <= 5 ? cosines[turn] : -cosines[10 - turn];
}

std::int64_t fixed(double value, int bits) { return std::llround(std::ldexp(value, bits)); }

double longest(const PenroseTable& table)
{
    double squared = 0;
    for (const auto& row : table.rows)
        for (const PenroseVector& v : row)
            squared = std::max(squared, static_cast<double>(v.along) * v.along + static_cast<double>(v.left) * v.left);
    return std::ldexp(std::sqrt(squared), -vector_bits);
}

void set_directions(PenroseScale& scale, double length)
{
    for (std::size_t k = 0; k < 4; ++k) {
        scale.axis_x[k] = fixed(length * cosine(2 * k), FRACTION_BITS);
        scale.axis_y[k] = fixed(length * cosine(2 * k + 15), FRACTION_BITS); // a sine: 270 degrees on
    }
    for (std::size_t turn = 0; turn < TURNS; ++turn) {
        scale.turn_x[turn] = fixed(length * cosine(turn), FRACTION_BITS - vector_bits);
        scale.turn_y[turn] = fixed(length * cosine(turn + 15), FRACTION_BITS - vector_bits);
    }
}

/// Rows begin at equal ratios behind the last importance of the level before.
void set_rows(PenroseScale& scale)
{
    auto begin = static_cast<double>(scale.ones[0]);
    for (ulong& row : scale.rows) {
        row = static_cast<std::uint64_t>(begin) + 1;
        begin *= row_ratio;
    }
}

}

std::uint64_t most_penrose_importance() { return fibonacci(2 * DEEPEST + 2); }

PenroseScales penrose_scales(const PenroseTable& table)
{
    PenroseScales scales{};
    double length = root_scale;
    const double reach = longest(table);
    for (std::size_t level = 0; level < scales.size(); ++level) {
        PenroseScale& scale = scales[level];
        const int even = 2 * static_cast<int>(level);
        scale.ones[0] = fibonacci(even);
        scale.ones[1] = fibonacci(even + 1);
        set_directions(scale, length);
        set_rows(scale);
        length *= golden_inverse;
        // Its points are one level deeper at least. A little more is for rounding.
        scale.reach = fixed(reach * length, FRACTION_BITS) + (1 << 26);
    }
    return scales;
}

PenroseRow row_of_importance(const PenroseScales& scales, std::uint64_t importance)
{
    PenroseRow found{0, 0};
    while (scales[found.level + 1].ones[0] < importance) ++found.level;
    while (found.row + 1 < ROWS && scales[found.level].rows[found.row + 1] <= importance) ++found.row;
    return found;
}

ImportanceRange importances_of(const PenroseScales& scales, const PenroseRow& row)
{
    const bool is_last = row.row + 1 == ROWS;
    return {scales[row.level].rows[row.row],
            is_last ? scales[row.level + 1].rows[0] : scales[row.level].rows[row.row + 1]};
}

}
