// The sampler "penrose": what it says of itself, its numbers of points, and densities that it refuses.
#include "host/tile_sampling/penrose/penrose_sampler.hpp"

#include "host/device/device.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>

#include <cstdlib>

namespace poissonlab {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

class PenroseSamplerTest : public testing::Test
{
protected:
    PenroseSamplerTest() : given_(spec_.parameters)
    {
        // Any table does, and none is built.
        PenroseTable table;
        table.rows[2][3] = {900, -900};
        write_penrose_table(cache_.path() / penrose_table_name(), table);
        ::setenv("POISSONLAB_CACHE", cache_.path().c_str(), 1);
    }
    ~PenroseSamplerTest() override { ::unsetenv("POISSONLAB_CACHE"); }

    void give(const std::string& key, const ParameterValue& value)
    {
        given_.set(key, value, {(cache_.path() / "test.toml").string(), 7});
    }

    PointSet sample(std::size_t points, Engine engine = Engine::reference, std::uint32_t realization = 0)
    {
        Device device = Device::open();
        const auto sampler = spec_.create(given_, {points, 2, 1}, engine, [&]() -> Device& { return device; });
        EXPECT_TRUE(sampler->traits().is_window);
        return sampler->sample(realization);
    }

    std::string refusal(std::size_t points = 1000)
    {
        return refusal_of([&] {
            spec_.check(given_, {points, 2, 1}, {});
            sample(points);
        });
    }

    const TemporaryFolder cache_;
    SamplerSpec spec_ = penrose_sampler();
    Parameters given_;
};

TEST_F(PenroseSamplerTest, GivesTheSameSetsByBothEngines)
{
    EXPECT_EQ(sample(3000).size(), 3000U);
    EXPECT_EQ(sample(3000, Engine::opencl), sample(3000));
    give("density", std::string("exp(-4*(x^2+y^2))"));
    EXPECT_NEAR(static_cast<double>(sample(3000).size()), 3000, 15);
    EXPECT_EQ(sample(3000, Engine::opencl), sample(3000));
}

TEST_F(PenroseSamplerTest, TakesWindowsAtRandomPlaces)
{
    give("random_window", true);
    EXPECT_FALSE(spec_.is_deterministic(given_));
    const PointSet first = sample(3000), second = sample(3000, Engine::reference, 1);
    EXPECT_EQ(sample(3000, Engine::opencl, 1), second);
    EXPECT_NE(first, second);
    for (const PointSet* set : {&first, &second}) {
        // The tiling's density is even: what its border lets in and out is a small part of 4 sqrt(3000) = 220 points.
        EXPECT_NEAR(static_cast<double>(set->size()), 3000, 110);
        for (const double x : set->coordinates) EXPECT_TRUE(x >= 0 && x < 1) << x;
    }
    give("density", std::string("1"));
    EXPECT_THAT(refusal(), HasSubstr("random_window = true: is for points that are the same everywhere"));
}

TEST_F(PenroseSamplerTest, RefusesDensitiesInOneLine)
{
    const std::string place = (cache_.path() / "test.toml").string() + ":7: ";
    give("density", std::string("0"));
    EXPECT_THAT(refusal(), AllOf(StartsWith(place + "density = \"0\": "), HasSubstr("is 0 everywhere")));
    give("density", std::string("x"));
    EXPECT_THAT(refusal(), AllOf(StartsWith(place), HasSubstr("not negative")));
    give("density", std::string("missing.png"));
    EXPECT_THAT(refusal(), AllOf(StartsWith(place), HasSubstr("no such file")));
    cache_.write("empty.png", "");
    give("density", std::string("empty.png"));
    EXPECT_THAT(refusal(), StartsWith(place));
    give("density", std::string("1"));
    give("density_from", std::string("ink"));
    EXPECT_THAT(refusal(), AllOf(StartsWith(place), HasSubstr("is for pictures")));
}

TEST_F(PenroseSamplerTest, RefusesPeaksThatNeedTooFineTiles)
{
    give("density", std::string("abs(x) < 0.001 && abs(y) < 0.001 ? 1 : 0"));
    EXPECT_EQ(refusal(1000), "accepted");
    EXPECT_THAT(refusal(2'000'000'000), HasSubstr("finer than level 30"));
}

}
}
