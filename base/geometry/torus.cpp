#include "base/geometry/torus.hpp"

#include <cmath>

namespace poissonlab {

std::uint64_t squared_threshold(double min_distance)
{
    // min_distance = mantissa * 2^exponent with an integer mantissa below 2^53, so the square is exact in 128
    // bits.
    __extension__ using Wide = unsigned __int128;
    if (!(min_distance > 0)) return 0;
    int exponent = 0;
    const auto mantissa = static_cast<std::uint64_t>(std::ldexp(std::frexp(min_distance, &exponent), 53));
    const Wide square = static_cast<Wide>(mantissa) * mantissa;
    const int shift = 2 * (53 - exponent) - 64; // square / 2^shift is in units of 2^-64
    if (shift < 42) return UINT64_MAX;          // the square has up to 106 bits: the result would not fit 64
    if (shift >= 106) return 1;
    const Wide rounded_up = (square + ((Wide{1} << shift) - 1)) >> shift;
    return rounded_up > UINT64_MAX ? UINT64_MAX : static_cast<std::uint64_t>(rounded_up);
}

}
