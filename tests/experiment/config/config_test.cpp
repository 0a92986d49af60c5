#include "experiment/config/config.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <locale>

namespace poissonlab {
namespace {

TEST(Config, HasDefaultsForAllButTheSampler)
{
    const Config config = parse_config("[[method]]\nsampler = \"random\"\n", "folder/my-name.toml");
    EXPECT_EQ(config.title, "my-name");
    EXPECT_EQ(config.seed, 1U);
    EXPECT_EQ(config.engine, Engine::opencl);
    EXPECT_EQ(config.device, "");
    EXPECT_EQ(config.points, 16384U);
    EXPECT_EQ(config.realizations, 10);
    EXPECT_EQ(config.dimension, 2);
    EXPECT_EQ(config.analysis.spectrum, PeriodogramMethod::fast);
    EXPECT_FALSE(config.analysis.zone_plate);
    ASSERT_EQ(config.methods.size(), 1U);
    EXPECT_EQ(config.methods[0].sampler->name, "random");
    EXPECT_TRUE(config.methods[0].settings.empty());
}

TEST(Config, TakesEveryKey)
{
    const Config config = parse_config(R"(title = "T"
seed = 9223372036854775807
engine = "reference"
device = "pthread"
[analysis]
points = 134217728
realizations = 10000
spectrum = "exact"
dimension = 2
zone_plate = true
[[method]]
sampler = "dart-throwing"
label = "L"
relative_radius = 1 # an integer where a number is asked for
[[method]]
sampler = "dart-throwing"
stop = "saturation"
min_distance = [0.10, 0.2]
)",
                                       "c.toml");
    EXPECT_EQ(config.title, "T");
    EXPECT_EQ(config.seed, static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max()));
    EXPECT_EQ(config.engine, Engine::reference);
    EXPECT_EQ(config.device, "pthread");
    EXPECT_EQ(config.points, std::size_t{1} << 27);
    EXPECT_EQ(config.realizations, 10000);
    EXPECT_EQ(config.analysis.spectrum, PeriodogramMethod::exact);
    EXPECT_TRUE(config.analysis.zone_plate);
    ASSERT_EQ(config.methods.size(), 2U);
    EXPECT_EQ(config.methods[0].label, "L");
    EXPECT_EQ(std::get<double>(config.methods[0].settings[0].choices[0].value), 1.0);
    const auto& choices = config.methods[1].settings[1].choices;
    ASSERT_EQ(choices.size(), 2U);
    EXPECT_EQ(choices[0].shown, "0.10");
    EXPECT_EQ(to_string(choices[0].location), "c.toml:18");
}

TEST(Config, TakesThreeDimensions)
{
    const Config config = parse_config("[analysis]\ndimension = 3\n[[method]]\nsampler = \"random\"\n", "c.toml");
    EXPECT_EQ(config.dimension, 3);
}

TEST(Config, IgnoresTheLocale)
{
    struct Comma : std::numpunct<char>
    {
        char do_decimal_point() const override { return ','; }
        char do_thousands_sep() const override { return '.'; }
        std::string do_grouping() const override { return "\3"; }
    };
    const std::locale previous = std::locale::global(std::locale(std::locale::classic(), new Comma));
    const Config config =
        parse_config("[analysis]\npoints = 16384\n[[method]]\nsampler = \"dart-throwing\"\nrelative_radius = 0.7\n",
                     "c.toml", {"method.relative_radius=0.75"});
    std::locale::global(previous);
    EXPECT_EQ(config.points, 16384U);
    EXPECT_EQ(std::get<double>(config.methods[0].settings[0].choices[0].value), 0.75);
    EXPECT_EQ(config.methods[0].settings[0].choices[0].shown, "0.75");
}

}
}
