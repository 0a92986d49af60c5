#include "host/settings/nearest_key.hpp"

#include <gtest/gtest.h>

namespace poissonlab {
namespace {

TEST(EditDistance, CountsEachKindOfMistakeOnce)
{
    EXPECT_EQ(edit_distance("points", "points"), 0U);
    EXPECT_EQ(edit_distance("point", "points"), 1U);   // missing
    EXPECT_EQ(edit_distance("poiints", "points"), 1U); // too many
    EXPECT_EQ(edit_distance("paints", "points"), 1U);  // replaced
    EXPECT_EQ(edit_distance("ponits", "points"), 1U);  // swapped
    EXPECT_EQ(edit_distance("", "points"), 6U);
    EXPECT_EQ(edit_distance("points", ""), 6U);
    EXPECT_EQ(edit_distance("ca", "abc"), 3U); // optimal string alignment: no edit inside a swap
    EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);
}

TEST(NearestKey, IsTheNearestOrNone)
{
    const std::vector<std::string> keys = {"title", "seed", "engine", "device", "analysis", "method"};
    EXPECT_EQ(nearest_key("sede", keys), "seed");
    EXPECT_EQ(nearest_key("analisys", keys), "analysis");
    EXPECT_EQ(nearest_key("methods", keys), "method");
    EXPECT_EQ(nearest_key("wavelength", keys), "");
    EXPECT_EQ(nearest_key("", keys), "");
    EXPECT_EQ(nearest_key("anything", {}), "");
    EXPECT_EQ(nearest_key("x", {"d", "y"}), "") << "no letter is right";
}

TEST(NearestKey, OfEquallyNearOnesIsTheFirst) { EXPECT_EQ(nearest_key("lest", {"last", "list"}), "last"); }

}
}
