// Values that the sampler "voronoi-darts" accepts and refuses; dart_throwing_sampler_test.cpp has what both have in
// common.
#include "host/settings/sampler_registry.hpp"
#include "tests/support/errors.hpp"

#include <gmock/gmock.h>

namespace poissonlab {
namespace {

using ::testing::HasSubstr;

const SamplerSpec& voronoi_spec() { return *find_sampler("voronoi-darts"); }

Parameters voronoi_parameters(std::initializer_list<std::pair<std::string, ParameterValue>> values)
{
    Parameters result(voronoi_spec().parameters);
    int line = 10;
    for (const auto& [key, value] : values) result.set(key, value, {"test.toml", line++});
    return result;
}

std::string voronoi_refusal(const Parameters& p)
{
    return refusal_of([&] { voronoi_spec().check(p, {16384, 2, 1}, {"test.toml", 9}); });
}

TEST(VoronoiDartsSampler, TakesWhatDartThrowingTakes)
{
    EXPECT_EQ(voronoi_refusal(voronoi_parameters({{"relative_radius", 0.75}})), "accepted");
    EXPECT_EQ(voronoi_refusal(voronoi_parameters({{"stop", std::string("saturation")}, {"min_distance", 0.01}})),
              "accepted");
    EXPECT_THAT(voronoi_refusal(voronoi_parameters({})),
                HasSubstr("sampler = \"voronoi-darts\": needs relative_radius"));
    EXPECT_THAT(voronoi_refusal(voronoi_parameters({{"relative_radius", 0.8}})),
                HasSubstr("test.toml:10: relative_radius = 0.8: "));
}

TEST(VoronoiDartsSampler, SaysWhatWasReachedWhenASetSaturatesEarly)
{
    const SampleRequest request{4096, 2, 1};
    const Parameters p = voronoi_parameters({{"relative_radius", 0.783}});
    const auto sampler = voronoi_spec().create(p, request, Engine::reference, {});
    EXPECT_THAT(message_of([&] { sampler->sample(0); }),
                HasSubstr("test.toml:10: relative_radius = 0.783: realization 0 is saturated with"));
}

}
}
