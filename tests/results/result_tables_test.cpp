#include "results/curve_tables.hpp"

#include <gtest/gtest.h>

namespace poissonlab {
namespace {

TEST(RadialCsv, HasShortExactNumbers)
{
    EXPECT_EQ(radial_csv({{1, 0.1, -10.5, 8, 0.01}, {2, 1e-30, -300.25, 16, 0}}),
              "frequency,power,anisotropy_db,samples,power_error\n1,0.1,-10.5,8,0.01\n2,1e-30,-300.25,16,0\n");
}

TEST(PairCorrelationCsv, HasShortExactNumbers)
{
    EXPECT_EQ(pair_correlation_csv({{0.1, 0, 0, 0}, {0.3, 1.25, 0.5, 2.5}}),
              "distance,pair_correlation,standard_error,pairs\n0.1,0,0,0\n0.3,1.25,0.5,2.5\n");
}

}
}
