// Pictures and formulas as plain numbers.
#include "base/densities/density_values.hpp"

#include "tests/support/errors.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace poissonlab {
namespace {

using testing::HasSubstr;

LinearPicture two_rows()
{
    LinearPicture picture;
    picture.width = 2;
    picture.height = 2;
    picture.channels = {"Y", "Z"};
    picture.values = {0.25f, -1, 0.5f, -2, 0.75f, -3, 1, -4};
    return picture;
}

TEST(PixelValues, OfPicturesAreRowsFromTheBottom)
{
    EXPECT_THAT(picture_values(two_rows(), "light", "p").values, testing::ElementsAre(0.75, 1, 0.25, 0.5));
    EXPECT_THAT(picture_values(two_rows(), "ink", "p").values, testing::ElementsAre(0.25, 0, 0.75, 0.5));
    EXPECT_THAT(picture_values(two_rows(), "Z", "p").values, testing::ElementsAre(-3, -4, -1, -2));
    EXPECT_THAT(message_of([] { picture_values(two_rows(), "X", "p"); }), HasSubstr("must be light, ink or a channel"));
    LinearPicture hole = two_rows();
    hole.values[0] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_TRUE(std::isnan(picture_values(hole, "ink", "p").at(0, 1)));
}

/// Negative numbers and those that are none are for others to refuse.
TEST(PixelValues, OfFormulasAreThoseInTheMiddlesOfPixels)
{
    const PixelValues values = formula_values("x < 0 ? sqrt(-1) : -y", 2, 1);
    EXPECT_EQ(values.width, 1024);
    EXPECT_EQ(values.height, 512);
    EXPECT_TRUE(std::isnan(values.at(0, 0)));
    EXPECT_DOUBLE_EQ(values.at(1023, 511), -511.0 / 1024);
    EXPECT_THAT(message_of([] { values_of_text("none.png", "ink", 1, 1); }), HasSubstr("none.png: no such file; as a"));
    EXPECT_THAT(message_of([] { values_of_text("/dev/null", "ink", 1, 1); }),
                HasSubstr("/dev/null: is a device, no file; as a"));
}

TEST(PixelValues, HaveAMiddle)
{
    const PixelValues values{4, 3, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}};
    EXPECT_THAT(middle_of(values, 1).values, testing::SizeIs(12));
    const PixelValues half = middle_of(values, 2);
    EXPECT_EQ(half.width, 2);
    EXPECT_EQ(half.height, 2);
    EXPECT_THAT(half.values, testing::ElementsAre(1, 2, 5, 6));
    EXPECT_THAT(middle_of(values, 1000).values, testing::SizeIs(1));
}

}
}
