// Any method's sets in an order whose first parts are good sets.
#include "host/sampling/optimized/ordered_sampler.hpp"

#include "base/geometry/relative_radius.hpp"
#include "base/random/random.hpp"
#include "experiment/config/plan.hpp"
#include "host/device/device.hpp"
#include "tests/support/brute_force.hpp"
#include "tests/support/errors.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numeric>

namespace poissonlab {
namespace {

std::vector<SeriesPlan> ordered_plan(const std::string& method, int dimension = 2)
{
    const std::string head =
        "seed = 4\n[analysis]\npoints = 1024\ndimension = " + std::to_string(dimension) + "\n[[method]]\n";
    return make_plan(parse_config(head + method, "c.toml"));
}

std::unique_ptr<Sampler> plain_sampler(const SeriesPlan& series)
{
    return series.sampler->create(series.parameters, series.request, Engine::reference, {});
}

/// The points of a set, sorted.
std::vector<std::array<double, 3>> places(const PointSet& points)
{
    std::vector<std::array<double, 3>> result;
    for (std::size_t i = 0; i < points.size(); ++i) {
        std::array<double, 3> place{};
        std::ranges::copy(points[i], place.begin());
        result.push_back(place);
    }
    std::ranges::sort(result);
    return result;
}

double prefix_radius(PointSet points, std::size_t count)
{
    points.coordinates.resize(count * static_cast<std::size_t>(points.dimension));
    return relative_radius(test::brute_force_min_distance(points), count, points.dimension);
}

/// Chooses `count` points of a set by chance, in the order of random words.
PointSet random_part(const PointSet& points, std::size_t count, std::uint32_t realization)
{
    std::vector<std::pair<std::uint32_t, std::size_t>> order;
    for (std::size_t i = 0; i < points.size(); ++i)
        order.emplace_back(philox({static_cast<std::uint32_t>(i), realization, 0, 0}, {7, 7})[0], i);
    std::ranges::sort(order);
    PointSet part{points.dimension, {}};
    for (std::size_t i = 0; i < count; ++i)
        part.coordinates.insert(part.coordinates.end(), points[order[i].second].begin(), points[order[i].second].end());
    return part;
}

/// The power at the frequencies up to a quarter of the root of the number of points, one of each f and -f.
std::vector<double> low_powers(const PointSet& points)
{
    std::vector<double> powers;
    const auto most = static_cast<int>(std::sqrt(static_cast<double>(points.size())) / 4);
    for (int y = 0; y <= most; ++y)
        for (int x = -most; x <= most; ++x)
            if ((y > 0 || x > 0) && 16 * (x * x + y * y) <= static_cast<int>(points.size()))
                powers.push_back(test::brute_force_power(points, {x, y, 0}));
    return powers;
}

double mean_of(const std::vector<double>& values)
{
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// A part p of the points of an even set, by chance, has the power of noise, 1 - p, at low frequencies, up to p times
/// that of the set; those that come first in the order have less than half of that.
TEST(OrderedSampler, FirstPartsHaveLessPowerAtLowFrequenciesThanRandomOnes)
{
    const auto plan = ordered_plan("sampler = \"lloyd\"\niterations = 20\norder = \"sample-elimination\"\n");
    const auto sampler = plain_sampler(plan[0]);
    std::vector<PointSet> sets;
    for (std::uint32_t realization = 0; realization < 6; ++realization) sets.push_back(sampler->sample(realization));
    for (const std::size_t count : {512U, 256U, 128U}) {
        std::vector<double> first, random;
        for (std::uint32_t k = 0; k < sets.size(); ++k) {
            PointSet prefix = sets[k];
            prefix.coordinates.resize(2 * count);
            std::ranges::copy(low_powers(prefix), std::back_inserter(first));
            std::ranges::copy(low_powers(random_part(sets[k], count, k)), std::back_inserter(random));
        }
        const double noise = 1 - static_cast<double>(count) / 1024;
        // Powers of noise are exponentially distributed: their deviation is their mean.
        const double error = noise / std::sqrt(static_cast<double>(random.size()));
        EXPECT_NEAR(mean_of(random), noise, 4 * error + 0.02) << count << ", and a fiftieth of the set itself";
        EXPECT_LT(mean_of(first), noise / 2) << count;
        EXPECT_GT(mean_of(first), 0) << count;
    }
}

TEST(OrderedSampler, MovesNoPointAndMakesEveryFirstPartGood)
{
    const auto plan = ordered_plan("sampler = \"lloyd\"\niterations = 20\norder = [\"own\", \"sample-elimination\"]\n");
    ASSERT_EQ(plan.size(), 2u);
    EXPECT_EQ(plan[0].name, "lloyd-i-20-order-own");
    EXPECT_EQ(plan[1].name, "lloyd-i-20-order-sample-elimination");
    const auto own = plain_sampler(plan[0]), ordered = plain_sampler(plan[1]);
    EXPECT_FALSE(own->traits().is_progressive);
    EXPECT_TRUE(ordered->traits().is_progressive);
    const PointSet made = own->sample(1), sorted = ordered->sample(1);
    EXPECT_NE(made, sorted);
    EXPECT_EQ(places(made), places(sorted));
    EXPECT_EQ(own->traits().iterations.size(), ordered->traits().iterations.size());
    // Lloyd relaxation keeps the numbers of its random points, of which a half is a random choice: its nearest two are
    // neighbours of the whole set. In a good order they are not: 0.55 to 0.6 at powers of two, for points that cannot
    // move (sample elimination of five times as many random ones has 0.62 and more).
    for (const std::size_t count : {512u, 256u, 128u}) {
        EXPECT_GT(prefix_radius(sorted, count), 0.5) << count;
        EXPECT_GT(prefix_radius(sorted, count), 1.3 * prefix_radius(made, count)) << count;
    }
}

TEST(OrderedSampler, EnginesGiveTheSameBytes)
{
    Device device = Device::open();
    for (const int dimension : {2, 3}) {
        const auto plan = ordered_plan("sampler = \"random\"\norder = \"sample-elimination\"\n", dimension);
        const auto kernel = plan[0].sampler->create(plan[0].parameters, plan[0].request, Engine::opencl,
                                                    [&]() -> Device& { return device; });
        EXPECT_EQ(kernel->sample(0), plain_sampler(plan[0])->sample(0));
    }
}

TEST(OrderedSampler, TakesSetsOfAFewPoints)
{
    for (const char* points : {"1", "2", "3"}) {
        const auto plan = ordered_plan(
            "sampler = \"random\"\norder = \"sample-elimination\"\npoints = " + std::string(points) + "\n");
        EXPECT_EQ(plain_sampler(plan[0])->sample(0).size(), plan[0].request.points);
    }
}

class WindowSampler final : public Sampler
{
public:
    PointSet sample(std::uint32_t) override { return {2, {0.5, 0.5}}; }
    SetTraits traits() const override { return {.is_window = true}; }
};

/// A method that has something of its own to say of everything.
class TalkativeSampler final : public Sampler
{
public:
    PointSet sample(std::uint32_t) override { return {2, {0.5, 0.5}}; }
    SetTraits traits() const override
    {
        return {.sizes_vary = true,
                .tiles_along_axis = 5,
                .tile_sets = 3,
                .tile_set = TileSetRecord{},
                .tile_set_file = [] { return "PTILES"; },
                .iterations = {{0.5, 2}},
                .proven_relative_radius = 0.25,
                .preparation_seconds = 7};
    }
};

TEST(OrderedSampler, SaysWhatTheMethodSays)
{
    SamplerSpec talkative;
    talkative.create = [](const Parameters&, const SampleRequest&, Engine, const DeviceProvider&) {
        return std::make_unique<TalkativeSampler>();
    };
    const auto ordered = in_progressive_order(talkative).create({}, {1, 2, 1}, Engine::reference, {});
    const SetTraits traits = ordered->traits();
    EXPECT_TRUE(traits.sizes_vary);
    EXPECT_TRUE(traits.is_progressive);
    EXPECT_EQ(traits.tiles_along_axis, 5u);
    EXPECT_EQ(traits.tile_sets, 3u);
    EXPECT_TRUE(traits.tile_set.has_value());
    EXPECT_EQ(traits.tile_set_file(), "PTILES");
    EXPECT_EQ(traits.iterations.size(), 1u);
    EXPECT_EQ(traits.proven_relative_radius, 0.25);
    EXPECT_EQ(traits.preparation_seconds, 7);
    EXPECT_FALSE(traits.shared_seconds);
}

TEST(OrderedSampler, MistakesAreSaidWithTheirPlace)
{
    EXPECT_EQ(message_of([] { ordered_plan("sampler = \"random\"\norder = \"best\"\n"); }),
              "c.toml:7: order = \"best\": must be one of \"own\", \"sample-elimination\"");
    SamplerSpec window;
    window.create = [](const Parameters&, const SampleRequest&, Engine, const DeviceProvider&) {
        return std::make_unique<WindowSampler>();
    };
    Parameters parameters;
    parameters.set("order", std::string("sample-elimination"), {"c.toml", 7});
    const auto ordered = in_progressive_order(window).create(parameters, {16, 2, 1}, Engine::reference, {});
    EXPECT_THAT(message_of([&] { ordered->sample(0); }),
                testing::HasSubstr("c.toml:7: order = \"sample-elimination\": cannot be combined with this method"));
}

/// A method that makes sets side by side where it is told how many are expected.
class SideBySide final : public Sampler
{
public:
    explicit SideBySide(std::vector<std::uint32_t>& expected) : expected_(expected) {}

    PointSet sample(std::uint32_t) override { return {2, {0.1, 0.1, 0.6, 0.1, 0.1, 0.6, 0.6, 0.6}}; }
    void expect(std::uint32_t first, std::uint32_t count) override { expected_ = {first, count}; }
    SetTraits traits() const override { return {.shared_seconds = 1000}; }

private:
    std::vector<std::uint32_t>& expected_;
};

TEST(OrderedSampler, HandsOnWhatIsExpectedAndTheShareOfTheTime)
{
    std::vector<std::uint32_t> expected;
    SamplerSpec method;
    method.create = [&](const Parameters&, const SampleRequest&, Engine, const DeviceProvider&) {
        return std::make_unique<SideBySide>(expected);
    };
    const auto sampler = in_progressive_order(method).create({}, {}, Engine::reference, {});
    sampler->expect(3, 8);
    EXPECT_EQ(expected, (std::vector<std::uint32_t>{3, 8}));
    sampler->sample(3);
    ASSERT_TRUE(sampler->traits().shared_seconds);
    EXPECT_GE(*sampler->traits().shared_seconds, 1000) << "and the time of ordering";
    EXPECT_LT(*sampler->traits().shared_seconds, 1060);
}

}
}
