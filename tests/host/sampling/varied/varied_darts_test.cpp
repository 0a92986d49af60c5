// Dart throwing with distances that vary: kernels against their twin, distances of all pairs, saturation by all places
// of a fine lattice, and constant distances as a case of those that vary.
#include "host/sampling/varied/varied_darts.hpp"

#include "base/errors/errors.hpp"
#include "base/regions/region_text.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace poissonlab {
namespace {

struct VariedCase
{
    std::string region;
    std::string formula;
    bool is_mean = false;
    std::size_t points = 0;     ///< 0: to saturation
    std::uint32_t attempts = 0; ///< of relaxation
};

void PrintTo(const VariedCase& c, std::ostream* out)
{
    *out << c.region << ", " << c.formula << (c.is_mean ? ", mean" : ", smaller") << ", "
         << (c.points == 0 ? "saturated" : std::to_string(c.points));
}

VariedDartRequest request_of(const VariedCase& c, std::uint32_t realization = 0)
{
    const PlaneRegion plane = read_region(c.region, {.is_planar = true});
    VariedDartRequest request;
    request.region = std::make_shared<const FixedRegion>(plane);
    const DistanceTable table =
        distance_table(*request.region, distance_of_text(c.formula, "light", {0, 1}, box_of(plane)), "a distance");
    request.field = std::make_shared<const DistanceField>(table, *request.region, 1.0);
    request.is_mean = c.is_mean;
    request.slope = table.slope_of_box;
    if (c.points > 0) request.points = c.points;
    request.expected = static_cast<std::size_t>(table.packing);
    request.attempts = c.attempts;
    request.factor = 0.95;
    request.stream = stream_key(5, Purpose::varied_darts, realization);
    return request;
}

class VariedDartSets : public testing::TestWithParam<VariedCase>
{
};

TEST_P(VariedDartSets, AreTheSameByKernels)
{
    const VariedDartRequest request = request_of(GetParam());
    const VariedDarts expected = reference::throw_varied_darts(request);
    VariedDartThrower thrower(Device::open());
    EXPECT_EQ(thrower.throw_darts(request), expected);
    EXPECT_EQ(VariedDartThrower(Device::open(), 16).throw_darts(request), expected);
    EXPECT_EQ(thrower.throw_darts(request_of(GetParam(), 1)), reference::throw_varied_darts(request_of(GetParam(), 1)));
    EXPECT_EQ(expected.is_full, GetParam().points == 0);
    if (GetParam().points > 0) {
        EXPECT_EQ(expected.points.size(), GetParam().points);
    }
}

/// Twice the distance that two points keep, in positions, by whole numbers of 128 bits.
bool are_apart(const VariedDartRequest& request, const TorusPoint<2>& p, const TorusPoint<2>& q, double scale)
{
    __extension__ using Wide = unsigned __int128;
    const auto scaled = [&](const TorusPoint<2>& at) {
        return static_cast<std::uint64_t>(std::floor(request.field->at(at) * scale));
    };
    const std::uint64_t a = scaled(p), b = scaled(q), twice = request.is_mean ? a + b : 2 * std::min(a, b);
    Wide squared = 0;
    for (std::size_t k = 0; k < 2; ++k) {
        const auto gap = static_cast<Wide>(std::abs(static_cast<std::int64_t>(p[k]) - static_cast<std::int64_t>(q[k])));
        squared += gap * gap;
    }
    return 4 * squared >= static_cast<Wide>(twice) * twice;
}

TEST_P(VariedDartSets, KeepTheDistanceOfEachPairInside)
{
    const VariedDartRequest request = request_of(GetParam());
    const VariedDarts darts = reference::throw_varied_darts(request);
    ASSERT_GT(darts.points.size(), 2U);
    for (std::size_t i = 0; i < darts.points.size(); ++i) {
        EXPECT_TRUE(request.region->contains_plainly(darts.points[i]));
        for (std::size_t j = 0; j < i; ++j)
            ASSERT_TRUE(are_apart(request, darts.points[i], darts.points[j], darts.scale)) << i << " and " << j;
    }
}

/// Every place of a lattice that is finer than holes could be is too near to a point; and just as many of a smaller
/// set, without its last point, are not.
TEST_P(VariedDartSets, LeaveNoRoomWhereTheyAreFull)
{
    const VariedDartRequest request = request_of(GetParam());
    VariedDarts darts = reference::throw_varied_darts(request);
    if (!darts.is_full) return;
    constexpr std::uint32_t step = 0x7fffffffu / 300;
    const auto has_room = [&] {
        std::size_t free = 0;
        for (std::uint32_t y = 0; y <= request.region->extent().high[1]; y += step)
            for (std::uint32_t x = 0; x <= request.region->extent().high[0]; x += step)
                free += request.region->contains({x, y}) && std::ranges::all_of(darts.points, [&](const auto& point) {
                            return are_apart(request, {x, y}, point, 1);
                        });
        return free;
    };
    EXPECT_EQ(has_room(), 0U);
    darts.points.erase(darts.points.begin()); // the first dart's disk was not covered by others
    EXPECT_GT(has_room(), 0U);
}

class LongVariedDarts : public testing::TestWithParam<VariedCase>
{
};

/// The distance along a strip changes many times over a 512th of its length.
TEST_P(LongVariedDarts, AreTheSameByKernelsAndKeepTheFormula)
{
    const VariedDartRequest request = request_of(GetParam());
    ASSERT_EQ(request.field->columns(), 0U);
    const VariedDarts darts = reference::throw_varied_darts(request);
    EXPECT_EQ(VariedDartThrower(Device::open()).throw_darts(request), darts);
    const auto formula = [&](const std::array<double, 2>& at) { return darts.scale * (0.35 + 0.2 * std::sin(at[0])); };
    const auto kept = [&](const std::array<double, 2>& p, const std::array<double, 2>& q) {
        return request.is_mean ? (formula(p) + formula(q)) / 2 : std::min(formula(p), formula(q));
    };
    const auto gap = [](const auto& p, const auto& q) { return std::hypot(p[0] - q[0], p[1] - q[1]); };
    std::vector<std::array<double, 2>> points;
    for (const auto& point : darts.points) points.push_back(request.region->own(point));
    std::ranges::sort(points);
    double least = HUGE_VAL;
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t j = i + 1; j < points.size() && points[j][0] < points[i][0] + 1; ++j)
            least = std::min(least, gap(points[i], points[j]) / kept(points[i], points[j]));
    EXPECT_GE(least, 1);
    EXPECT_LT(least, 1.01); // fails if the table of distances is wrong
    if (!darts.is_full) return;
    // Every place on the middle line has a point near it; the table's distances are at most 1e-3 above the formula.
    for (std::array<double, 2> on{-0.3, 0.4}; on[0] < 2399.7; on[0] += 0.04, on[1] += 0.03) {
        bool is_near = false;
        for (auto point = std::ranges::lower_bound(points, std::array{on[0] - 1, 0.0});
             point != points.end() && (*point)[0] < on[0] + 1; ++point)
            is_near = is_near || gap(on, *point) < kept(on, *point) + 1e-3;
        ASSERT_TRUE(is_near) << on[0];
    }
}

// Oclgrind interprets these as well: see tests/CMakeLists.txt.
INSTANTIATE_TEST_SUITE_P(Small, VariedDartSets,
                         testing::Values(VariedCase{"rectangle 0 0 1 1", "0.3+0.2*x", false, 4},
                                         VariedCase{"disk 0 0 1", "0.9+0.3*x", true}));
INSTANTIATE_TEST_SUITE_P(
    Sizes, VariedDartSets,
    testing::Values(VariedCase{"rectangle 0 0 1 1", "0.01+0.1*x"}, VariedCase{"rectangle 0 0 1 1", "0.01+0.1*x", true},
                    VariedCase{"rectangle 0 0 1 1", "0.02+0.3*abs(x-0.5)", false, 200},
                    VariedCase{"rectangle 0 0 1 1", "0.02+0.3*abs(x-0.5)", true, 300, 100},
                    VariedCase{"POLYGON ((500000 0, 500300 10, 500200 200, 500000 190, 500000 0), (500100 50, 500150 "
                               "50, 500150 100, 500100 100, 500100 50))",
                               "3+0.9*sqrt((x-500000)^2+y^2)/2"},
                    VariedCase{"disk 0 0 1", "0.02+0.9*sqrt(x*x+y*y)"},
                    VariedCase{"disk 0 0 1", "0.02+1.5*sqrt(x*x+y*y)", true}));
// Distances of these are in squares that cover the region.
const std::string far_islands = "MULTIPOLYGON (((0 0, 1 0, 1 1, 0 1, 0 0)), ((60 40, 61 40, 61 41, 60 41, 60 40)))";
INSTANTIATE_TEST_SUITE_P(Islands, VariedDartSets,
                         testing::Values(VariedCase{far_islands, "0.35+0.1*sin(3*x)"},
                                         VariedCase{far_islands, "0.35+0.1*sin(3*x)", true},
                                         VariedCase{far_islands, "0.1+0.02*x", true, 20, 100}));

const std::string long_strip = "POLYGON ((0 0, 2400 1800, 2399.4 1800.8, -0.6 0.8, 0 0))";

INSTANTIATE_TEST_SUITE_P(Strips, LongVariedDarts,
                         testing::Values(VariedCase{long_strip, "0.35+0.2*sin(x)"},
                                         VariedCase{long_strip, "0.35+0.2*sin(x)", true},
                                         VariedCase{long_strip, "0.35+0.2*sin(x)", false, 2000, 300}));

}
}
