// Pictures of densities: grey values and the place of the origin.
#include "reports/images/spectrum_image.hpp"

#include <gtest/gtest.h>

namespace poissonlab {
namespace {

TEST(DensityImage, IsMidGreyWhereTheDensityIsOneAndHasTheOriginAtTheLowerLeft)
{
    GreyImage image = draw_density({2, {0, 1, 2, 5}}, 3);
    ASSERT_EQ(image.width, 6);
    ASSERT_EQ(image.height, 6);
    EXPECT_EQ(image.at(0, 5), 0);
    EXPECT_EQ(image.at(2, 3), 0) << "the same pixel, magnified";
    EXPECT_EQ(image.at(3, 5), 128);
    EXPECT_EQ(image.at(0, 0), 255);
    EXPECT_EQ(image.at(5, 0), 255);
}

}
}
