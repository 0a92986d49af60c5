#include "analysis/measures/packing_fraction.hpp"

#include "tests/support/point_patterns.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace poissonlab {
namespace {

using namespace test;
using std::numbers::pi;

TEST(PackingFraction, OfLatticesIsThatOfTheTextbooks)
{
    EXPECT_NEAR(packing_fraction(square_lattice(16, 2)), pi / 4, 1e-14);
    EXPECT_NEAR(packing_fraction(square_lattice(16, 3)), pi / 6, 1e-14);
    EXPECT_NEAR(packing_fraction(face_centred_cubic_lattice(8)), pi / std::sqrt(18), 1e-14);
    // 112/97 is 5.3e-5 below 2/sqrt 3: columns touch, rows are too far apart by as much.
    EXPECT_NEAR(packing_fraction(staggered_lattice(97, 112)), pi / std::sqrt(12), 1.1e-4);
}

TEST(PackingFraction, OfFewPoints)
{
    EXPECT_EQ(packing_fraction({2, {}}), 0);
    EXPECT_NEAR(packing_fraction({2, {0.3, 0.9}}), pi / 4, 1e-15);
    EXPECT_NEAR(packing_fraction({3, {0.3, 0.9, 0.1}}), pi / 6, 1e-15);
    EXPECT_NEAR(packing_fraction({2, {0.0, 0.0, 0.5, 0.5}}), pi / 4, 1e-15);       // diameter sqrt(1/2)
    EXPECT_NEAR(packing_fraction({2, {0.0, 0.0, 0.75, 0.0}}), 2 * pi / 64, 1e-15); // diameter 1/4
    EXPECT_EQ(packing_fraction({2, {0.3, 0.9, 0.3, 0.9}}), 0);
}

}
}
