// The number of periodograms of sets and tapers.
#include "results/periodograms.hpp"

#include <gtest/gtest.h>

namespace poissonlab {
namespace {

TEST(Periodograms, AreOfEachSetByEachTaper)
{
    Series series;
    series.realizations = 3;
    EXPECT_EQ(periodograms_of(series), 3) << "on the torus";
    series.region.emplace();
    EXPECT_EQ(periodograms_of(series), 3) << "in a region, without tapers";
    series.region->tapers = 8;
    EXPECT_EQ(periodograms_of(series), 24);
}

}
}
