// Values that the sampler "voronoi-darts" accepts and refuses; dart_throwing_sampler_test.cpp has what both have in
// common.
#include "base/geometry/relative_radius.hpp"
#include "host/settings/sampler_registry.hpp"
#include "tests/support/errors.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>
#include <random>

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

PointSet open_set(std::size_t points, double relative_radius, std::uint32_t realization)
{
    const Parameters p = voronoi_parameters({{"relative_radius", relative_radius}, {"border", std::string("open")}});
    const auto sampler = voronoi_spec().create(p, {points, 2, 1}, Engine::reference, {});
    EXPECT_TRUE(sampler->traits().is_window);
    return sampler->sample(realization);
}

/// Darts of a textbook in the open square: doubles, and every pair.
PointSet textbook_open_set(std::size_t points, double distance, std::mt19937& random)
{
    std::uniform_real_distribution<double> uniform(0, 1);
    PointSet set;
    while (set.size() < points) {
        const double x = uniform(random), y = uniform(random);
        bool is_near = false;
        for (std::size_t i = 0; i < set.size() && !is_near; ++i)
            is_near = std::hypot(set[i][0] - x, set[i][1] - y) < distance;
        if (!is_near) set.coordinates.insert(set.coordinates.end(), {x, y});
    }
    return set;
}

double share_near_border(const PointSet& set, double distance)
{
    double near = 0;
    for (std::size_t i = 0; i < set.size(); ++i)
        near += std::min({set[i][0], 1 - set[i][0], set[i][1], 1 - set[i][1]}) < distance / 2;
    return near / static_cast<double>(set.size());
}

/// The mean power along the axes, and along lines beside them, at 1 to 8 periods: |sum exp(2 pi i k x)|^2 / N.
std::array<double, 2> power_on_and_off_axes(const PointSet& set)
{
    const auto power = [&](int k, int l) {
        double re = 0, im = 0;
        for (std::size_t i = 0; i < set.size(); ++i) {
            const double turn = 2 * std::numbers::pi * (k * set[i][0] + l * set[i][1]);
            re += std::cos(turn), im += std::sin(turn);
        }
        return (re * re + im * im) / static_cast<double>(set.size());
    };
    std::array<double, 2> means{};
    for (int k = 1; k <= 8; ++k) {
        means[0] += (power(k, 0) + power(0, k)) / 16;
        means[1] += (power(k, 3) + power(3, -k)) / 16;
    }
    return means;
}

/// D 6.12: Jones' sets are not toroidal. They keep their distance in the square, not around it; as many points lie near
/// the border as a textbook's darts have there, more than on a torus; and their spectrum has lines on the axes.
TEST(VoronoiDartsSampler, HasAnOpenBorder)
{
    constexpr std::size_t points = 150;
    constexpr int sets = 150;
    const double distance = min_distance_for(0.72, points, 2);
    std::mt19937 random(3);
    std::array<double, 2> near{}, squares{}, powers{};
    int around = 0;
    for (int k = 0; k < sets; ++k) {
        const PointSet set = open_set(points, 0.72, static_cast<std::uint32_t>(k));
        ASSERT_EQ(set.size(), points);
        bool meets_around = false;
        for (std::size_t i = 0; i < points; ++i)
            for (std::size_t j = 0; j < i; ++j) {
                const double dx = std::abs(set[i][0] - set[j][0]), dy = std::abs(set[i][1] - set[j][1]);
                ASSERT_GE(std::hypot(dx, dy), distance);
                meets_around |= std::hypot(std::min(dx, 1 - dx), std::min(dy, 1 - dy)) < distance;
            }
        around += meets_around;
        const double both[2] = {share_near_border(set, distance),
                                share_near_border(textbook_open_set(points, distance, random), distance)};
        for (std::size_t m = 0; m < 2; ++m) near[m] += both[m] / sets, squares[m] += both[m] * both[m] / sets;
        const auto power = power_on_and_off_axes(set);
        for (std::size_t m = 0; m < 2; ++m) powers[m] += power[m] / sets;
    }
    EXPECT_EQ(around, sets);
    const double error = std::sqrt((squares[0] - near[0] * near[0] + squares[1] - near[1] * near[1]) / sets);
    EXPECT_LT(error, 0.005);
    EXPECT_NEAR(near[0], near[1], 5 * error);
    EXPECT_GT(near[0], 1 - (1 - distance) * (1 - distance) + 5 * error); // the strip's area
    EXPECT_GT(powers[0], 1.5 * powers[1]);

    for (const std::size_t few : {1, 2, 3}) EXPECT_EQ(open_set(few, 0.7, 0).size(), few);
    EXPECT_THAT(
        voronoi_refusal(voronoi_parameters({{"stop", std::string("saturation")}, {"border", std::string("open")}})),
        HasSubstr("border = \"open\": cannot be combined"));
    const Parameters p = voronoi_parameters({{"relative_radius", 0.999}, {"border", std::string("open")}});
    const auto sampler = voronoi_spec().create(p, {400, 2, 1}, Engine::reference, {});
    EXPECT_THAT(message_of([&] { sampler->sample(0); }), HasSubstr("darts find no room for more"));
}

}
}
