// The picture of the zone plate: where pixels lie, and what becomes of values outside of [0, 1].
#include "reports/images/zone_plate_image.hpp"

#include <gtest/gtest.h>

namespace poissonlab {
namespace {

TEST(ZonePlateImage, HasTheOriginAtTheLowerLeft)
{
    auto image = draw_zone_plate({2, {0, 0.2, 0.4, 1}});
    EXPECT_EQ(image.at(0, 1), 0);
    EXPECT_EQ(image.at(1, 1), 51);
    EXPECT_EQ(image.at(0, 0), 102);
    EXPECT_EQ(image.at(1, 0), 255);
}

TEST(ZonePlateImage, ClipsWhatLobesPushOut)
{
    auto image = draw_zone_plate({2, {-0.1, 1.1, -1e9, 1e9}});
    EXPECT_EQ(image.at(0, 1), 0);
    EXPECT_EQ(image.at(1, 1), 255);
    EXPECT_EQ(image.at(0, 0), 0);
    EXPECT_EQ(image.at(1, 0), 255);
}

}
}
