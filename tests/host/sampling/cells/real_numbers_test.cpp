// Numbers of devices without double precision, which are made of integers, have the bits of the processor's doubles,
// and so have relaxed points. Each of these tests runs on such devices as well, see tests/kernels/on_other_device.sh.
#include "base/geometry/relative_radius.hpp"
#include "host/device/kernel_source.hpp"
#include "host/sampling/lloyd_relaxation.hpp"
#include "host/sampling/repulsion.hpp"
#include "tests/support/point_patterns.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

namespace poissonlab {
namespace {

/// This kernel makes results of all operations on two numbers.
constexpr const char* all_operations = R"(
#pragma OPENCL FP_CONTRACT OFF
#define DOUBLES 0
#include "kernels/common/reals.clh"
kernel void calculate(global const ulong* as, global const ulong* bs, uint count, global ulong* results)
{
    const uint i = get_global_id(0);
    if (i >= count) return;
    const real a = as[i];
    const real b = bs[i];
    global ulong* result = results + 10 * i;
    result[0] = plus(a, b);
    result[1] = minus(a, b);
    result[2] = times(a, b);
    result[3] = over(a, b);
    result[4] = root_of(a & ~SIGN_BIT);
    result[5] = floor_of(a);
    result[6] = is_less(a, b) + 2 * is_equal(a, b);
    result[7] = as_uint(float_of(a));
    result[8] = uint_of(a);
    result[9] = real_of_int((int)a) ^ real_of_uint((uint)b);
}
)";

using Bits = std::uint64_t;

Bits bits_of(double value) { return std::bit_cast<Bits>(value); }
double double_of(Bits bits) { return std::bit_cast<double>(bits); }

/// Makes numbers of every kind: any bits, small integers, subnormal ones, neighbours of the last number, and all
/// borders.
std::vector<Bits> numbers(std::size_t count, std::uint64_t seed)
{
    static const double borders[] = {0.0,
                                     -0.0,
                                     1,
                                     0.5,
                                     1 + 0x1p-52,
                                     1 - 0x1p-53,
                                     4294967295.5,
                                     std::numeric_limits<double>::infinity(),
                                     -std::numeric_limits<double>::infinity(),
                                     std::numeric_limits<double>::quiet_NaN(),
                                     std::numeric_limits<double>::denorm_min(),
                                     std::numeric_limits<double>::min(),
                                     std::numeric_limits<double>::max(),
                                     std::numeric_limits<float>::min(),
                                     std::numeric_limits<float>::max()};
    std::mt19937_64 random(seed);
    std::vector<Bits> result;
    while (result.size() < count) {
        const Bits any = random();
        const Bits sign = any & (Bits{1} << 63);
        switch (random() % 7) {
        case 0:
            result.push_back(any);
            break;
        case 1:
            result.push_back(bits_of(static_cast<double>(any % 7)) | sign);
            break;
        case 2:
            result.push_back(any & 0x801fffffffffffff);
            break;
        case 3:
            result.push_back(bits_of(borders[random() % std::size(borders)]));
            break;
        case 4:
            result.push_back(bits_of(std::ldexp(static_cast<double>(any >> 11), -static_cast<int>(any % 120))) | sign);
            break;
        case 5:
            result.push_back((any & 0x8000000ff0000000) | (1000 + random() % 40) << 52);
            break;
        default:
            result.push_back(result.empty() ? any : (result.back() + random() % 5 - 2) ^ sign);
        }
    }
    return result;
}

/// Expects the bits of a number, and any NaN for NaN.
void expect_bits(Bits bits, double expected, const char* what, double a, double b)
{
    EXPECT_TRUE(std::isnan(expected) ? std::isnan(double_of(bits)) : bits == bits_of(expected))
        << what << " of " << a << " and " << b << ": " << double_of(bits) << ", not " << expected;
}

TEST(RealNumbers, HaveTheBitsOfTheProcessor)
{
    Device device = Device::open();
    std::string text = all_operations;
    const std::string include = "#include \"kernels/common/reals.clh\"";
    text.replace(text.find(include), include.size(), kernel_source("kernels/common/reals.clh"));
    Kernel calculate = device.kernel_from_text(text, "real numbers", "calculate");

    const std::size_t count = 200'000;
    const std::vector<Bits> as = numbers(count, 1);
    std::vector<Bits> bs = numbers(count, 2);
    for (std::size_t i = 0; i < count; i += 5) bs[i] = as[i] + i % 7 - 3; // next to each other
    Buffer<Bits> first = device.buffer<Bits>(count);
    Buffer<Bits> second = device.buffer<Bits>(count);
    Buffer<Bits> results = device.buffer<Bits>(10 * count);
    first.write(as);
    second.write(bs);
    calculate.run(count, 64, first, second, static_cast<std::uint32_t>(count), results);
    const std::vector<Bits> made = results.read(0, 10 * count);
    for (std::size_t i = 0; i < count && !HasFailure(); ++i) {
        const double a = double_of(as[i]);
        const double b = double_of(bs[i]);
        const Bits* is = &made[10 * i];
        expect_bits(is[0], a + b, "sum", a, b);
        expect_bits(is[1], a - b, "difference", a, b);
        expect_bits(is[2], a * b, "product", a, b);
        expect_bits(is[3], a / b, "quotient", a, b);
        expect_bits(is[4], std::sqrt(std::fabs(a)), "root", a, b);
        if (!std::isnan(a)) expect_bits(is[5], std::floor(a), "whole part", a, b);
        EXPECT_EQ(is[6], Bits{a < b} + 2 * Bits{a == b}) << a << " and " << b;
        const auto single = static_cast<float>(a);
        if (single == 0 || std::isnormal(single) || std::isinf(single)) {
            const bool vanishes = std::fabs(a) < 0x1p-126; // rounded up to a normal number, perhaps
            EXPECT_TRUE(vanishes || is[7] == std::bit_cast<std::uint32_t>(single)) << a;
        }
        const bool is_range = a >= 0 && a < 0x1p32;
        EXPECT_TRUE(!is_range || is[8] == static_cast<std::uint32_t>(is_range ? a : 0)) << a;
        const auto whole = static_cast<std::int32_t>(static_cast<std::uint32_t>(as[i]));
        EXPECT_EQ(is[9], bits_of(whole) ^ bits_of(static_cast<std::uint32_t>(bs[i])));
    }
}

/// Hashes bytes (FNV-1a).
class Hash
{
public:
    template <typename T>
    void add(const T& value)
    {
        const auto bytes = std::bit_cast<std::array<std::uint8_t, sizeof(T)>>(value);
        for (const std::uint8_t byte : bytes) value_ = (value_ ^ byte) * 0x100000001b3;
    }

    std::uint64_t value() const { return value_; }

private:
    std::uint64_t value_ = 0xcbf29ce484222325;
};

/// Makes sets of so many points: random, at the borders of the torus, in clusters, coinciding, and lattices.
std::vector<PointSet> all_kinds(std::size_t n, std::uint64_t seed)
{
    std::mt19937_64 random(seed + n);
    std::vector<PointSet> sets{test::random_points(n, 2, random), test::random_points_with_borders(n, 2, random),
                               test::clustered_points(n, 2, 3, 1e-3, random),
                               test::clustered_points(n, 2, 1, 0.2, random)};
    PointSet twins = test::random_points(n, 2, random);
    for (std::size_t i = 0; 3 * i + 1 < n; ++i)
        for (std::size_t k = 0; k < 2; ++k) twins.coordinates[2 * (3 * i + 1) + k] = twins.coordinates[6 * i + k];
    sets.push_back(twins);
    const auto side = static_cast<int>(std::sqrt(static_cast<double>(n)));
    sets.push_back(test::square_lattice(side, 2));
    sets.push_back(test::staggered_lattice(side, side));
    return sets;
}

struct BitsOfSets
{
    std::vector<std::size_t> sizes;
    std::uint64_t seeds;
    std::uint64_t expected; ///< what PoCL's doubles gave
};

void PrintTo(const BitsOfSets& c, std::ostream* out) { *out << "up to " << c.sizes.back() << " points"; }

class RelaxedBits : public testing::TestWithParam<BitsOfSets>
{
};

TEST_P(RelaxedBits, AreThoseOfEveryDevice)
{
    Hash hash;
    for (const std::size_t n : GetParam().sizes) {
        for (std::uint64_t seed = 0; seed < GetParam().seeds; ++seed) {
            for (const PointSet& start : all_kinds(n, seed)) {
                const LloydResult relaxed = LloydRelaxation(Device::open()).relax(start, {}, {3});
                for (const IterationRecord& record : relaxed.iterations) {
                    hash.add(record.energy);
                    hash.add(record.relative_radius);
                }
                const RepulsionRequest request{min_distance_for(0.6, start.size(), 2)};
                const RepulsionResult repelled = Repulsion(Device::open()).repel(relaxed.points, {}, request);
                for (const double x : relaxed.points.coordinates) hash.add(x);
                for (const double x : repelled.points.coordinates) hash.add(x);
            }
        }
    }
    EXPECT_EQ(hash.value(), GetParam().expected);
}

INSTANTIATE_TEST_SUITE_P(Sets, RelaxedBits,
                         testing::Values(BitsOfSets{{1, 2, 3, 7, 64, 256, 1000}, 4, 6404989170885478850u},
                                         BitsOfSets{{4096}, 1, 17790718892600449743u}));
INSTANTIATE_TEST_SUITE_P(Small, RelaxedBits, testing::Values(BitsOfSets{{1, 2, 3, 7, 50}, 1, 2406132074087448368u}));

}
}
