// Masked sums of squares: by transforms and one by one they are the same integers.
#include "host/texture/masked_squares.hpp"

#include "tests/host/texture/plain_masked_squares.hpp"
#include "tests/host/texture/random_picture.hpp"

#include <gtest/gtest.h>

#include <malloc.h>

namespace poissonlab {
namespace {

PieceMask random_mask(int width, int height, unsigned seed)
{
    PieceMask mask{width, height, {}};
    std::mt19937 random(seed);
    for (int i = 0; i < width * height; ++i) mask.counts.push_back(random() % 3 != 0);
    return mask;
}

class MaskedSquaresCase : public testing::TestWithParam<std::tuple<int, int, int, int>>
{
};

TEST_P(MaskedSquaresCase, AreTheSumsOfAllProducts)
{
    const auto [width, height, side, channels] = GetParam();
    const PngPixels exemplar = test::random_picture(width, height, channels, 1);
    const PieceMask mask = random_mask(side, side + 1, 2);
    const PngPixels piece = test::random_picture(side, side + 1, channels, 3);
    const SquareSums expected = test::plain_masked_squares(exemplar, mask, piece);
    EXPECT_EQ(expected.columns, width - side + 1);
    EXPECT_EQ(expected.rows, height - side);
    EXPECT_EQ(MaskedSquares(exemplar, mask).sums(piece).sums, expected.sums);
}

INSTANTIATE_TEST_SUITE_P(Small, MaskedSquaresCase, testing::Values(std::tuple(9, 11, 4, 1), std::tuple(7, 9, 5, 3)));
INSTANTIATE_TEST_SUITE_P(Sizes, MaskedSquaresCase,
                         testing::Values(std::tuple(31, 37, 8, 1), std::tuple(40, 24, 9, 3), std::tuple(16, 17, 16, 3),
                                         std::tuple(97, 50, 24, 1)));

TEST(MaskedSquares, AreZeroWhereThePieceWasTakenFrom)
{
    const PngPixels exemplar = test::random_picture(60, 50, 3, 4);
    PngPixels piece{10, 10, 3, {}};
    for (int y = 0; y < 10; ++y)
        for (int x = 0; x < 10; ++x)
            for (int c = 0; c < 3; ++c) piece.values.push_back(exemplar.values[exemplar.at(33 + x, 21 + y, c)]);
    const SquareSums sums = MaskedSquares(exemplar, random_mask(10, 10, 5)).sums(piece);
    EXPECT_EQ(sums.at(33, 21), 0u);
    EXPECT_EQ(std::ranges::count(sums.sums, 0u), 1);
}

/// The largest values: black beside white, nowhere masked.
TEST(MaskedSquares, AreExactAtTheEndsOfTheRange)
{
    const PngPixels white{200, 150, 3, std::vector<std::uint8_t>(90'000, 255)};
    const PngPixels black{64, 64, 3, std::vector<std::uint8_t>(64 * 64 * 3, 0)};
    const SquareSums sums = MaskedSquares(white, {64, 64, std::vector<std::uint8_t>(64 * 64, 1)}).sums(black);
    for (const std::uint64_t sum : sums.sums) ASSERT_EQ(sum, 255u * 255 * 3 * 64 * 64);
}

/// The two spectra and the numbers of one call for this exemplar take 6 MB, which a thread that lives on must not keep.
TEST(MaskedSquares, LeaveNoMemoryWithTheirThread)
{
    const PngPixels exemplar = test::random_picture(512, 512, 1, 1), piece = test::random_picture(8, 8, 1, 2);
    const auto used = [] {
        const struct mallinfo2 now = mallinfo2();
        return now.uordblks + now.hblkhd;
    };
    const auto before = used();
    MaskedSquares(exemplar, random_mask(8, 8, 3)).sums(piece);
    EXPECT_LT(used(), before + 1'000'000);
}

}
}
