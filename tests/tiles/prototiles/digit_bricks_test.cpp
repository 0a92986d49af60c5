// Bricks by the digits of pi, against published digits.
#include "tiles/prototiles/digit_bricks.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

namespace poissonlab {
namespace {

TEST(DigitBricks, HaveTheDigitsOfPi)
{
    // The first hexadecimal digits of pi: Bailey, Borwein, Plouffe, 1997.
    const std::string published =
        "3243F6A8885A308D313198A2E03707344A4093822299F31D0082EFA98EC4E6C89452821E638D01377BE5466CF34E90C6CC0AC2"
        "9B7C97C50DD3F84D5B5B54709179216D5D98979FB1BD1310BA698DFB5AC2FFD72DBD01ADFB7B8E1AFED6A267E96BA7C9045F12C7";
    const std::vector<bool> digits = binary_digits_of_pi(2 + 4 * (published.size() - 1));
    for (std::size_t i = 1; i < published.size(); ++i) {
        int digit = 0;
        for (std::size_t bit = 0; bit < 4; ++bit) digit = 2 * digit + (digits[2 + 4 * (i - 1) + bit] ? 1 : 0);
        ASSERT_EQ(digit, std::stoi(published.substr(i, 1), nullptr, 16)) << "digit " << i;
    }
    EXPECT_TRUE(digits[0] && digits[1]) << "3 before the point";
    const std::vector<bool> more = binary_digits_of_pi(10'000);
    EXPECT_TRUE(std::equal(digits.begin(), digits.end(), more.begin()));
}

TEST(DigitBricks, LieOnASpiralWithoutGaps)
{
    const auto squares = spiral_squares(121);
    const std::set<std::array<int, 2>> different(squares.begin(), squares.end());
    ASSERT_EQ(different.size(), 121U);
    EXPECT_EQ(squares[0], (std::array<int, 2>{0, 0}));
    EXPECT_EQ(squares[1], (std::array<int, 2>{1, 0}));
    EXPECT_EQ(squares[2], (std::array<int, 2>{1, 1}));
    for (std::size_t i = 0; i < squares.size(); ++i) {
        EXPECT_LE(std::max(std::abs(squares[i][0]), std::abs(squares[i][1])), 5) << "11 x 11 squares are full";
        if (i == 0) continue;
        EXPECT_EQ(std::abs(squares[i][0] - squares[i - 1][0]) + std::abs(squares[i][1] - squares[i - 1][1]), 1);
    }
}

}
}
