// Points in longitude and latitude, in the frame of a region that was mapped from there.
#include "analysis/regions/framed_region.hpp"
#include "base/regions/region_source.hpp"
#include "base/regions/region_text.hpp"
#include "tests/support/errors.hpp"

#include <gmock/gmock.h>

namespace poissonlab {
namespace {

using testing::HasSubstr;

TEST(GlobeFramedRegions, TakePointsAsFilesHaveThem)
{
    const std::string box = R"({"type": "Polygon", "coordinates": [[[4, 50], [6, 50], [6, 51], [4, 51], [4, 50]]]})";
    const PlaneRegion plane = read_region(box);
    const FramedRegion region(plane, "box");
    const PointSet framed = region.framed({2, {4, 50, 5, 50.5, 6, 51}}, "points");
    const std::array<double, 2> middle = region.own({framed[1][0], framed[1][1]});
    const PointSet expected = as_in_plane(plane, {2, {5, 50.5}});
    EXPECT_NEAR(middle[0], expected[0][0], 1e-6);
    EXPECT_NEAR(middle[1], expected[0][1], 1e-6);
    EXPECT_THAT(message_of([&] {
                    region.framed({2, {5, 50.5, 5, 52}}, "points");
                }),
                HasSubstr("points: 1 of 2 points lies outside the region box: the first is point 2, (5, 52)"));
    EXPECT_THAT(message_of([&] {
                    region.framed({2, {173000, 172000}}, "points");
                }),
                HasSubstr("lies outside the region"));
    // Regions of one shape in two places have sets of their own.
    const std::string other =
        R"({"type": "Polygon", "coordinates": [[[14, 50], [16, 50], [16, 51], [14, 51], [14, 50]]]})";
    EXPECT_NE(region.hash(), FramedRegion(read_region(other), "box").hash());
}

}
}
