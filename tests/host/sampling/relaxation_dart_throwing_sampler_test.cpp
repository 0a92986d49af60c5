// Values that the sampler "relaxation-dart-throwing" accepts and refuses, and the sets that it makes by default.
#include "host/settings/sampler_registry.hpp"

#include "host/device/device.hpp"
#include "host/sampling/relaxation_dart_throwing.hpp"
#include "tests/support/errors.hpp"

#include <gmock/gmock.h>

namespace poissonlab {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

const SamplerSpec& relaxation_spec() { return *find_sampler("relaxation-dart-throwing"); }

Parameters relaxation_parameters(std::initializer_list<std::pair<std::string, ParameterValue>> values)
{
    Parameters result(relaxation_spec().parameters);
    int line = 10;
    for (const auto& [key, value] : values) result.set(key, value, {"test.toml", line++});
    return result;
}

std::string relaxation_refusal(const Parameters& p, std::size_t points = 16384)
{
    return refusal_of([&] { relaxation_spec().check(p, {points, 2, 1}, {"test.toml", 9}); });
}

DeviceProvider relaxation_device()
{
    return [device = std::make_shared<Device>(Device::open())]() -> Device& { return *device; };
}

TEST(RelaxationDartThrowingSampler, AcceptsWhatIsPossible)
{
    EXPECT_EQ(relaxation_refusal(relaxation_parameters({})), "accepted");
    EXPECT_EQ(relaxation_refusal(relaxation_parameters({{"factor", 0.999}, {"attempts", std::int64_t{10000}}})),
              "accepted");
    // No reduction is needed at all.
    EXPECT_EQ(relaxation_refusal(relaxation_parameters(
                  {{"initial_radius", 1e-6}, {"factor", 1 - 1e-9}, {"attempts", std::int64_t{1'000'000'000}}})),
              "accepted");
}

TEST(RelaxationDartThrowingSampler, RefusesWhatWouldNotEnd)
{
    EXPECT_THAT(
        relaxation_refusal(relaxation_parameters({{"factor", 1 - 1e-9}, {"attempts", std::int64_t{1'000'000}}})),
        AllOf(HasSubstr("test.toml:10: factor = 0.999999999: "), HasSubstr("4e+15 darts")));
    EXPECT_THAT(relaxation_refusal(relaxation_parameters({{"attempts", std::int64_t{1} << 40}}), 1000),
                "accepted"); // weeks, but they end
    EXPECT_THAT(
        relaxation_refusal(relaxation_parameters({{"initial_radius", 0.5}, {"attempts", std::int64_t{1} << 40}}),
                           1 << 30),
        AllOf(HasSubstr("test.toml:11: attempts = 1099511627776: 1073741824 points"), HasSubstr("fewer attempts")));
}

TEST(RelaxationDartThrowingSampler, EnginesGiveTheSameBytes)
{
    for (const int dimension : {2, 3}) {
        const SampleRequest request{500, dimension, 5};
        const Parameters p =
            relaxation_parameters({{"initial_radius", 0.2}, {"factor", 0.97}, {"attempts", std::int64_t{200}}});
        const auto kernel = relaxation_spec().create(p, request, Engine::opencl, relaxation_device());
        const auto plain = relaxation_spec().create(p, request, Engine::reference, {});
        for (std::uint32_t k = 0; k < 3; ++k) EXPECT_EQ(kernel->sample(k), plain->sample(k));
        EXPECT_NE(kernel->sample(0), kernel->sample(1));
        EXPECT_FALSE(kernel->traits().sizes_vary);
    }
}

TEST(RelaxationDartThrowingSampler, ParametersAreWhatTheAlgorithmIsTold)
{
    RelaxationDartThrowingRequest request{2, 300, 0.3, 0.9, 77, stream_key(5, Purpose::relaxation_dart_throwing, 2)};
    const Parameters p =
        relaxation_parameters({{"initial_radius", 0.3}, {"factor", 0.9}, {"attempts", std::int64_t{77}}});
    EXPECT_EQ(relaxation_spec().create(p, {300, 2, 5}, Engine::reference, {})->sample(2),
              reference::throw_relaxation_darts(request).points);

    request.initial_radius = 0.15;
    request.factor = 0.99;
    request.attempts = 1000;
    EXPECT_EQ(relaxation_spec().create(relaxation_parameters({}), {300, 2, 5}, Engine::reference, {})->sample(2),
              reference::throw_relaxation_darts(request).points);
}

}
}
