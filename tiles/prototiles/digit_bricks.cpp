#include "tiles/prototiles/digit_bricks.hpp"

#include <algorithm>

namespace poissonlab {
namespace {

/// A binary fraction: limbs of 32 bits, the first one before the point.
using BinaryFraction = std::vector<std::uint32_t>;

void divide(BinaryFraction& number, std::uint32_t divisor)
{
    std::uint64_t rest = 0;
    for (std::uint32_t& limb : number) {
        rest = rest << 32 | limb;
        limb = static_cast<std::uint32_t>(rest / divisor);
        rest %= divisor;
    }
}

/// Adds a multiple of another number, or takes it away.
void add_multiple(BinaryFraction& number, const BinaryFraction& other, std::int64_t factor)
{
    std::int64_t carry = 0;
    for (std::size_t i = number.size(); i-- > 0;) {
        carry += number[i] + factor * static_cast<std::int64_t>(other[i]);
        number[i] = static_cast<std::uint32_t>(carry & 0xFFFFFFFF);
        carry >>= 32;
    }
}

/// Adds factor arctan(1/n), by its series, as far as the limbs go.
void add_arctangent(BinaryFraction& sum, std::uint32_t n, std::int64_t factor)
{
    BinaryFraction power(sum.size());
    power[0] = 1;
    divide(power, n);
    for (std::uint32_t odd = 1; std::ranges::any_of(power, [](std::uint32_t limb) { return limb != 0; }); odd += 2) {
        BinaryFraction term = power;
        divide(term, odd);
        add_multiple(sum, term, odd % 4 == 1 ? factor : -factor);
        divide(power, n * n);
    }
}

}

std::vector<bool> binary_digits_of_pi(std::size_t count)
{
    BinaryFraction pi(count / 32 + 4); // Machin's formula; the last limbs take up what is rounded
    add_arctangent(pi, 5, 16);
    add_arctangent(pi, 239, -4);
    std::vector<bool> digits;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t bit = 30 + i; // 3 is 11 in the last two bits of the first limb
        digits.push_back((pi[bit / 32] >> (31 - bit % 32) & 1U) != 0);
    }
    return digits;
}

std::vector<std::array<int, 2>> spiral_squares(std::size_t count)
{
    std::vector<std::array<int, 2>> squares;
    std::array<int, 2> place{};
    std::array<int, 2> step{1, 0};
    for (std::size_t side = 0; squares.size() < count; ++side) {
        for (std::size_t i = 0; i <= side / 2 && squares.size() < count; ++i) {
            squares.push_back(place);
            place = {place[0] + step[0], place[1] + step[1]};
        }
        step = {-step[1], step[0]};
    }
    return squares;
}

}
