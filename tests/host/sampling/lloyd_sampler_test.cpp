// Values that the sampler "lloyd" accepts and refuses, and the sets that it makes.
#include "host/settings/sampler_registry.hpp"

#include "base/geometry/relative_radius.hpp"
#include "host/sampling/lloyd_relaxation.hpp"
#include "tests/support/brute_force.hpp"
#include "tests/support/errors.hpp"

#include <gmock/gmock.h>

namespace poissonlab {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

const SamplerSpec& lloyd_spec() { return *find_sampler("lloyd"); }

using LloydValues = std::initializer_list<std::pair<std::string, ParameterValue>>;

Parameters lloyd_parameters(LloydValues values, const std::string& sampler = "lloyd")
{
    Parameters result(find_sampler(sampler)->parameters);
    int line = 10;
    for (const auto& [key, value] : values) result.set(key, value, {"test.toml", line++});
    return result;
}

ParameterValue start_from(const std::string& name, LloydValues values = {})
{
    return std::make_shared<const SamplerChoice>(SamplerChoice{find_sampler(name), lloyd_parameters(values, name)});
}

std::string lloyd_refusal(const Parameters& p)
{
    return refusal_of([&] { lloyd_spec().check(p, {1024, 2, 1}, {"test.toml", 9}); });
}

std::unique_ptr<Sampler> create(LloydValues values, int dimension = 2, Engine engine = Engine::opencl)
{
    static Device device = Device::open();
    return lloyd_spec().create(lloyd_parameters(values), {512, dimension, 7}, engine,
                               []() -> Device& { return device; });
}

const ParameterValue none = std::int64_t{0};
const ParameterValue eight = std::int64_t{8};

TEST(LloydSampler, RefusesWhatHasNoMeaning)
{
    EXPECT_EQ(lloyd_refusal(lloyd_parameters({{"iterations", eight}})), "accepted");
    EXPECT_EQ(
        lloyd_refusal(lloyd_parameters({{"iterations", none}, {"repulsion", true}, {"until_relative_radius", 0.8}})),
        "accepted");
    EXPECT_EQ(lloyd_refusal(lloyd_parameters({{"iterations", none}, {"repulsion", false}})), "accepted");
    EXPECT_THAT(lloyd_refusal(lloyd_parameters({})), AllOf(HasSubstr("test.toml:9"), HasSubstr("needs iterations")));
    EXPECT_THAT(lloyd_refusal(lloyd_parameters({{"iterations", eight}, {"repulsion", true}})),
                AllOf(HasSubstr("test.toml:11: repulsion = true"), HasSubstr("needs until_relative_radius")));
}

TEST(LloydSampler, WithoutIterationsGivesItsStart)
{
    for (const int dimension : {2, 3}) {
        const ParameterValue start = start_from("dart-throwing", {{"relative_radius", 0.7}});
        const auto sampler = create({{"iterations", none}, {"start", start}}, dimension);
        const auto from = find_sampler("dart-throwing");
        const auto plain = from->create(lloyd_parameters({{"relative_radius", 0.7}}, from->name), {512, dimension, 7},
                                        Engine::reference, nullptr);
        EXPECT_EQ(sampler->sample(3), plain->sample(3));
        EXPECT_EQ(sampler->traits().iterations.size(), 1u);
    }
}

TEST(LloydSampler, StartsFromRandomPointsWhenNothingIsSaid)
{
    const auto plain = create({{"iterations", eight}});
    const auto random = create({{"iterations", eight}, {"start", start_from("random")}});
    EXPECT_EQ(plain->sample(1), random->sample(1));
    EXPECT_NE(plain->sample(1), plain->sample(2));
}

TEST(LloydSampler, EnginesAgree)
{
    for (const int dimension : {2, 3}) {
        const LloydValues values = {{"iterations", eight}};
        const PointSet kernels = create(values, dimension)->sample(0);
        const PointSet expected = create(values, dimension, Engine::reference)->sample(0);
        ASSERT_EQ(kernels.coordinates.size(), expected.coordinates.size());
        for (std::size_t i = 0; i < kernels.coordinates.size(); ++i) {
            const double difference = kernels.coordinates[i] - expected.coordinates[i];
            EXPECT_NEAR(difference - std::rint(difference), 0, 1e-11);
        }
    }
}

TEST(LloydSampler, RepulsionReachesTheRadiusThatIsAskedFor)
{
    for (const int dimension : {2, 3}) {
        const double radius = 0.85;
        const auto sampler = create({{"iterations", std::int64_t{30}},
                                     {"until_relative_radius", radius},
                                     {"keep", std::string("best")},
                                     {"repulsion", true},
                                     {"start", start_from("dart-throwing", {{"relative_radius", 0.7}})}},
                                    dimension);
        for (std::uint32_t realization = 0; realization < 3; ++realization) {
            const PointSet points = sampler->sample(realization);
            EXPECT_GE(relative_radius(test::brute_force_min_distance(points), points.size(), dimension),
                      radius * (1 - 1e-12));
        }
    }
}

}
}
