// Values that the sampler "dart-throwing" accepts and refuses, and its words.
#include "host/settings/sampler_registry.hpp"

#include "base/geometry/relative_radius.hpp"
#include "host/device/device.hpp"
#include "tests/support/brute_force.hpp"
#include "tests/support/errors.hpp"

#include <gmock/gmock.h>

namespace poissonlab {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

const SamplerSpec& spec() { return *find_sampler("dart-throwing"); }

Parameters parameters(std::initializer_list<std::pair<std::string, ParameterValue>> values)
{
    Parameters result(spec().parameters);
    int line = 10;
    for (const auto& [key, value] : values) result.set(key, value, {"test.toml", line++});
    return result;
}

std::string refusal(const Parameters& p, std::size_t points = 16384)
{
    return refusal_of([&] { spec().check(p, {points, 2, 1}, {"test.toml", 9}); });
}

DeviceProvider device()
{
    return [device = std::make_shared<Device>(Device::open())]() -> Device& { return *device; };
}

TEST(DartThrowingSampler, AcceptsWhatIsPossible)
{
    EXPECT_EQ(refusal(parameters({{"relative_radius", 0.75}})), "accepted");
    EXPECT_EQ(refusal(parameters({{"relative_radius", 0.75}, {"stop", std::string("points")}})), "accepted");
    EXPECT_EQ(refusal(parameters({{"stop", std::string("saturation")}})), "accepted");
    EXPECT_EQ(refusal(parameters({{"stop", std::string("saturation")}, {"min_distance", 0.01}})), "accepted");
}

TEST(DartThrowingSampler, RefusesARadiusAboveSaturationWithTheReachableOne)
{
    EXPECT_THAT(refusal(parameters({{"relative_radius", 0.80}})),
                AllOf(HasSubstr("test.toml:10: relative_radius = 0.8: "), HasSubstr("0.7767")));
    // Few points scatter: two points can well be farther apart than many can.
    EXPECT_EQ(refusal(parameters({{"relative_radius", 0.80}}), 2), "accepted");
}

TEST(DartThrowingSampler, RefusesCombinationsThatMakeNoSense)
{
    EXPECT_THAT(refusal(parameters({})), AllOf(HasSubstr("test.toml:9"), HasSubstr("needs relative_radius")));
    EXPECT_THAT(refusal(parameters({{"relative_radius", 0.7}, {"min_distance", 0.01}})),
                HasSubstr("test.toml:11: min_distance = 0.01: "));
    EXPECT_THAT(refusal(parameters({{"stop", std::string("saturation")}, {"relative_radius", 0.7}})),
                HasSubstr("test.toml:11: relative_radius = 0.7: "));
    EXPECT_THAT(
        refusal(parameters({{"stop", std::string("saturation")}, {"min_distance", 1e-5}})),
        AllOf(HasSubstr("test.toml:11: min_distance = 1e-05: needs a finer grid"), HasSubstr("at least 8.64e-05")));
    EXPECT_THAT(
        refusal(parameters({{"relative_radius", 0.005}})),
        AllOf(HasSubstr("test.toml:10: relative_radius = 0.005: needs a finer grid"), HasSubstr("at least 0.0103")));
}

TEST(DartThrowingSampler, SaysWhatWasReachedWhenASetSaturatesEarly)
{
    // Within six standard deviations of what is possible, so it is tried; and it does not spin.
    const SampleRequest request{4096, 2, 1};
    const Parameters p = parameters({{"relative_radius", 0.783}});
    ASSERT_EQ(refusal(p, request.points), "accepted");
    for (const Engine engine : {Engine::opencl, Engine::reference}) {
        const auto sampler = spec().create(p, request, engine, device());
        EXPECT_THAT(message_of([&] { sampler->sample(0); }),
                    AllOf(HasSubstr("test.toml:10: relative_radius = 0.783: realization 0 is saturated with"),
                          HasSubstr("of 4096 points"), HasSubstr("about 0.77")));
    }
}

TEST(DartThrowingSampler, EnginesGiveTheSameBytes)
{
    const SampleRequest request{500, 2, 5};
    const Parameters p = parameters({{"relative_radius", 0.7}});
    const auto kernel = spec().create(p, request, Engine::opencl, device());
    const auto plain = spec().create(p, request, Engine::reference, {});
    for (std::uint32_t k = 0; k < 3; ++k) EXPECT_EQ(kernel->sample(k), plain->sample(k));
    EXPECT_NE(kernel->sample(0), kernel->sample(1));
    EXPECT_FALSE(kernel->traits().sizes_vary);
}

TEST(DartThrowingSampler, SaturatesAtTheAskedDistanceOrNearTheAskedSize)
{
    const auto by_distance = spec().create(parameters({{"stop", std::string("saturation")}, {"min_distance", 0.02}}),
                                           {9, 2, 1}, Engine::opencl, device());
    EXPECT_TRUE(by_distance->traits().sizes_vary);
    EXPECT_GE(test::brute_force_min_distance(by_distance->sample(0)), 0.02);

    const auto by_size =
        spec().create(parameters({{"stop", std::string("saturation")}}), {2000, 2, 1}, Engine::opencl, device());
    // Six standard deviations of the number of points, sqrt(0.059 N).
    EXPECT_NEAR(static_cast<double>(by_size->sample(0).size()), 2000, 6 * std::sqrt(0.059 * 2000));
}

}
}
