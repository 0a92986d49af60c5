// Cosines, sines and angles of kernels/common/sectors/directions.h against the library's of long double, whose errors
// are a thousandth of the bounds.
#include "kernels/common/sectors/directions.h"

#include "host/device/device.hpp"
#include "host/device/kernel_source.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace poissonlab {
namespace {

using contract::directions::direction_of;
using contract::directions::unit_vector;
using contract::directions::UnitVector;

static_assert(std::numeric_limits<long double>::digits >= 64);

double error_of_unit_vector(double angle)
{
    const UnitVector vector = unit_vector(angle);
    const long double wide = angle;
    return static_cast<double>(std::max(std::abs(vector.x - std::cos(wide)), std::abs(vector.y - std::sin(wide))));
}

double error_of_direction(double x, double y)
{
    const long double wide_x = x, wide_y = y;
    return static_cast<double>(std::abs(direction_of(x, y) - std::atan2(wide_y, wide_x)));
}

TEST(Directions, CosinesAndSinesAreAsExactAsPromised)
{
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> angle(-64, 64);
    double error = 0;
    for (int i = 0; i < 1'000'000; ++i) error = std::max(error, error_of_unit_vector(angle(random)));
    // Angles are taken around multiples of an eighth of a turn, where quarters change and values are nearly 0.
    for (int eighth = -80; eighth <= 80; ++eighth)
        for (int step = -50; step <= 50; ++step)
            error = std::max(error, error_of_unit_vector(eighth * 0.78539816339744831 + step * 0x1p-40));
    EXPECT_LE(error, 0x1p-52);
    EXPECT_GT(error, 0x1p-55); // else nothing was compared
}

TEST(Directions, AnglesAreAsExactAsPromised)
{
    std::mt19937_64 random(2);
    std::uniform_real_distribution<double> coordinate(-1, 1);
    double error = 0;
    for (int i = 0; i < 1'000'000; ++i) {
        const double x = coordinate(random), y = coordinate(random);
        error = std::max({error, error_of_direction(x, y), error_of_direction(x * 0x1p30, y), // nearly along an axis
                          error_of_direction(x, x * (1 + y * 0x1p-30))});                     // and along a diagonal
    }
    // Another polynomial begins at this quotient.
    for (int step = -1000; step <= 1000; ++step)
        error = std::max(error, error_of_direction(-1, 0.26794919243112270 + step * 0x1p-53));
    EXPECT_LE(error, 0x1p-50);
    EXPECT_GT(error, 0x1p-53);
}

TEST(Directions, OfAxesAndOfNothing)
{
    constexpr double pi = 3.14159265358979312;
    EXPECT_EQ(direction_of(0, 0), 0);
    EXPECT_EQ(direction_of(3, 0), 0);
    EXPECT_EQ(direction_of(0, 5), pi / 2);
    EXPECT_EQ(direction_of(0, -5), -pi / 2);
    EXPECT_EQ(direction_of(-2, 0), pi);
    EXPECT_EQ(unit_vector(0).x, 1);
    EXPECT_EQ(unit_vector(0).y, 0);
}

TEST(Directions, AreTheSameOnADevice)
{
    constexpr std::size_t count = 4096;
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> angle(-64, 64);
    std::vector<double> given(count), expected;
    for (double& value : given) value = angle(random);
    for (std::size_t i = 0; i < count; ++i) {
        const UnitVector vector = unit_vector(given[i]);
        for (const double value : {vector.x, vector.y, direction_of(given[i], given[count - 1 - i])})
            expected.push_back(value);
    }
    Device device = Device::open();
    auto values = device.buffer<double>(count), found = device.buffer<double>(3 * count);
    values.write(given);
    const std::string text = "#pragma OPENCL FP_CONTRACT OFF\n" + kernel_source("kernels/common/sectors/directions.h") +
                             "kernel void find(uint count, global const double* values, global double* found) {"
                             "  const uint i = get_global_id(0);"
                             "  const struct UnitVector vector = unit_vector(values[i]);"
                             "  found[3 * i] = vector.x;"
                             "  found[3 * i + 1] = vector.y;"
                             "  found[3 * i + 2] = direction_of(values[i], values[count - 1 - i]);"
                             "}";
    device.kernel_from_text(text, "directions", "find").run(count, 64, std::uint32_t{count}, values, found);
    EXPECT_EQ(found.read(0, 3 * count), expected);
}

}
}
