// Relaxation dart throwing in regions: kernel against reference, and what is inside and how far apart.
#include "host/sampling/relaxation_dart_throwing.hpp"
#include "tests/support/named_region.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace poissonlab {
namespace {

struct RelaxationRegionCase
{
    std::string region; ///< or "star" and a number of corners
    std::size_t points;
    std::uint64_t attempts;
    double margin = 0;
};

void PrintTo(const RelaxationRegionCase& c, std::ostream* out) { *out << c.points << " in " << c.region; }

class RelaxationDartsInRegions : public testing::TestWithParam<RelaxationRegionCase>
{
};

TEST_P(RelaxationDartsInRegions, AreThoseOfTheReferenceInsideAndFarEnoughApart)
{
    const auto& [name, points, attempts, margin] = GetParam();
    const PlaneRegion plane = test::named_region(name);
    RelaxationDartThrowingRequest request;
    request.points = points;
    request.initial_radius = 0.2;
    request.factor = 0.95;
    request.attempts = attempts;
    request.stream = stream_key(7, Purpose::relaxation_dart_throwing, 0);
    request.region = std::make_shared<const FixedRegion>(plane, margin);
    const RelaxationDarts expected = reference::throw_relaxation_darts(request);
    for (const std::size_t group : {std::size_t{1}, std::size_t{0}})
        EXPECT_TRUE(RelaxationDartThrower(Device::open(), group).throw_darts(request) == expected);
    ASSERT_EQ(expected.points.size(), points);
    for (std::size_t i = 0; i < points; ++i) {
        const auto p = expected.points[i];
        EXPECT_TRUE(request.region->contains_plainly(
            {static_cast<std::uint32_t>(p[0] * 0x1p32), static_cast<std::uint32_t>(p[1] * 0x1p32)}));
        for (std::size_t j = 0; j < i && i < 500; ++j)
            ASSERT_GE(std::hypot(p[0] - expected.points[j][0], p[1] - expected.points[j][1]), 2 * expected.radius);
    }
}

// Oclgrind interprets these as well: see tests/CMakeLists.txt.
INSTANTIATE_TEST_SUITE_P(Small, RelaxationDartsInRegions,
                         testing::Values(RelaxationRegionCase{"rectangle 0 0 3 2", 5, 20},
                                         RelaxationRegionCase{"star24", 8, 30, 0.01}));

INSTANTIATE_TEST_SUITE_P(Shapes, RelaxationDartsInRegions,
                         testing::Values(RelaxationRegionCase{"rectangle 0 0 3 2", 1000, 500},
                                         RelaxationRegionCase{"rectangle 0 0 300 1", 60, 2000},
                                         RelaxationRegionCase{"star60", 400, 3000},
                                         RelaxationRegionCase{"star4000", 3000, 1000, 0.002},
                                         RelaxationRegionCase{"disk 5 5 2", 1, 1}));

}
}
