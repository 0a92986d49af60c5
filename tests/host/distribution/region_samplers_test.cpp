// Samplers of sets in regions: realizations, what they promise, and where their points lie.

#include "analysis/regions/framed_region.hpp"
#include "base/files/whole_file.hpp"
#include "base/regions/region_text.hpp"
#include "host/distribution/regions/region_points.hpp"
#include "host/settings/sampler_registry.hpp"
#include "host/settings/sampler_texts.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/places.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>

namespace poissonlab {
namespace {

using testing::HasSubstr;

constexpr auto yard = "POLYGON ((500000 5400000, 500300 5400010, 500200 5400200, 500000 5400190, 500000 5400000), "
                      "(500100 5400050, 500150 5400050, 500150 5400100, 500100 5400100, 500100 5400050))";

SampleRequest request_in(const std::string& region, std::size_t points, std::uint64_t seed = 3)
{
    SampleRequest request{points, 2, seed};
    request.region = std::make_shared<const FramedRegion>(read_region(region, {.is_planar = true}), "yard");
    return request;
}

DeviceProvider region_test_device()
{
    return []() -> Device& {
        static Device opened = Device::open();
        return opened;
    };
}

const SamplerSpec& sampler_in_regions(const std::string& name)
{
    return *find_sampler(name, region_sampler_registry());
}

/// The parameters that a config would give, after the sampler's own checks.
Parameters checked_parameters(const std::string& name, const std::map<std::string, ParameterValue>& given,
                              const SampleRequest& request)
{
    const SamplerSpec& spec = sampler_in_regions(name);
    Parameters parameters(spec.parameters);
    for (const auto& [key, value] : given) parameters.set(key, value, {"test.toml", 4});
    spec.check(parameters, request, {"test.toml", 3});
    return parameters;
}

std::unique_ptr<Sampler> region_sampler(const std::string& name, const std::map<std::string, ParameterValue>& given,
                                        const SampleRequest& request, Engine engine)
{
    return sampler_in_regions(name).create(checked_parameters(name, given, request), request, engine,
                                           region_test_device());
}

double least_by_brute_force(const PointSet& points)
{
    double least = HUGE_VAL;
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            least = std::min(least, std::hypot(points[i][0] - points[j][0], points[i][1] - points[j][1]));
    return least;
}

/// By the rule of Jordan: a ray meets the boundary an odd number of times.
bool lies_in_yard(double x, double y)
{
    bool is_inside = false;
    for (const RegionPolygon& polygon : read_region(yard, {.is_planar = true}).polygons) {
        std::vector<RegionRing> rings = polygon.holes;
        rings.push_back(polygon.outline);
        for (const RegionRing& ring : rings)
            for (std::size_t i = 0; i < ring.size(); ++i) {
                const auto &a = ring[i], &b = ring[(i + 1) % ring.size()];
                if ((a[1] > y) == (b[1] > y)) continue;
                if (x < a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0])) is_inside = !is_inside;
            }
    }
    return is_inside;
}

struct RegionSamplerCase
{
    std::string name;
    std::map<std::string, ParameterValue> given;
    RegionMethod method = RegionMethod::darts; ///< of the same set by make_region_points()
    double min_distance = 0;                   ///< that is asked for, in the region's units
};

void PrintTo(const RegionSamplerCase& at, std::ostream* out) { *out << at.name; }

class SamplersInRegions : public testing::TestWithParam<RegionSamplerCase>
{
};

/// Realization 0 is the set of `distribute points`; others are others, the same by kernels and the plain algorithms.
TEST_P(SamplersInRegions, MakeRealizationsOfTheSameMethod)
{
    const RegionSamplerCase& at = GetParam();
    const SampleRequest request = request_in(yard, 200);
    const auto plain = region_sampler(at.name, at.given, request, Engine::reference);
    const auto kernel = region_sampler(at.name, at.given, request, Engine::opencl);
    const PointSet first = plain->sample(0), second = plain->sample(1);
    EXPECT_EQ(kernel->sample(1), second);
    EXPECT_EQ(kernel->sample(0), first);
    EXPECT_NE(first, second);
    RegionPointSettings settings;
    settings.method = at.method;
    settings.place.region = yard;
    settings.place.reading.is_planar = true;
    if (at.min_distance > 0)
        settings.place.min_distance = at.min_distance;
    else
        settings.place.points = 200;
    EXPECT_EQ(make_region_points(settings, 3, {.engine = Engine::reference, .device = {}}).points, first);
    for (const PointSet& set : {first, second}) {
        EXPECT_TRUE(at.min_distance > 0 || set.size() == 200) << set.size();
        EXPECT_GE(least_by_brute_force(set), at.min_distance);
        for (std::size_t i = 0; i < set.size(); ++i)
            ASSERT_TRUE(lies_in_yard(set[i][0], set[i][1])) << set[i][0] << ", " << set[i][1];
    }
    EXPECT_EQ(plain->traits().sizes_vary, at.min_distance > 0);
    if (const auto proven = plain->traits().proven_relative_radius) {
        const double unit = request.region->unit_length() * request.region->side();
        const double densest = std::sqrt(2 / (std::sqrt(3.0) * static_cast<double>(second.size()))) * unit;
        EXPECT_LE(*proven * densest, least_by_brute_force(second) * (1 + 1e-12));
        EXPECT_GE(*proven * densest, at.min_distance * (1 - 1e-12));
    }
}

INSTANTIATE_TEST_SUITE_P(
    All, SamplersInRegions,
    testing::Values(RegionSamplerCase{"dart-throwing", {{"relative_radius", 0.7}}},
                    RegionSamplerCase{"dart-throwing", {{"min_distance", 12.0}}, RegionMethod::darts, 12},
                    RegionSamplerCase{"relaxation-dart-throwing", {}, RegionMethod::relaxation},
                    RegionSamplerCase{"bridson", {{"min_distance", 12.0}}, RegionMethod::bridson, 12},
                    RegionSamplerCase{"lloyd", {}, RegionMethod::lloyd},
                    RegionSamplerCase{"sample-elimination", {}, RegionMethod::elimination},
                    RegionSamplerCase{"gaussian-blue-noise", {}, RegionMethod::gaussian}));

TEST(RandomPointsInRegions, FillPartsByTheirArea)
{
    const auto sampler = region_sampler("random", {}, request_in(yard, 20'000), Engine::reference);
    const PointSet points = sampler->sample(1);
    ASSERT_EQ(points.size(), 20'000U);
    EXPECT_NE(sampler->sample(0), points);
    // The areas west of x = 500100, by hand: a trapezium.
    double west = 0;
    for (std::size_t i = 0; i < points.size(); ++i) west += points[i][0] < 500'100;
    const double whole = area_of(read_region(yard, {.is_planar = true}));
    const double north = (190 + 195) / 2.0 * 100, south = (0 + 10 / 3.0) / 2 * 100, part = (north - south) / whole;
    EXPECT_NEAR(west / 20'000, part, 5 * std::sqrt(part * (1 - part) / 20'000));
    for (std::size_t i = 0; i < points.size(); ++i) ASSERT_TRUE(lies_in_yard(points[i][0], points[i][1]));
}

TEST(DartsInRegions, SaturateAtADistanceThatGivesAboutAsManyPoints)
{
    const SampleRequest request = request_in("rectangle 0 0 200 200", 2000);
    const auto sampler =
        region_sampler("dart-throwing", {{"stop", std::string("saturation")}}, request, Engine::opencl);
    const PointSet points = sampler->sample(0);
    EXPECT_TRUE(sampler->traits().sizes_vary);
    // Points on the boundary take half of their disk outside: about half a distance of room along the perimeter.
    EXPECT_GT(points.size(), 2000U);
    EXPECT_LT(points.size(), 2200U);
}

std::map<std::string, ParameterValue> small_tiles(const std::map<std::string, ParameterValue>& more)
{
    std::map<std::string, ParameterValue> given{{"colors", std::int64_t{2}},
                                                {"points_per_tile", std::int64_t{16}},
                                                {"lloyd_iterations", std::int64_t{2}},
                                                {"relative_radius", 0.5}};
    given.insert(more.begin(), more.end());
    return given;
}

TEST(TilesInRegions, KeepTheirDistanceAndHaveTheNumberThatIsAskedFor)
{
    const SampleRequest request = request_in(yard, 500);
    const auto plain = region_sampler("corner-tiles", small_tiles({}), request, Engine::reference);
    const auto kernel = region_sampler("corner-tiles", small_tiles({}), request, Engine::opencl);
    const double unit = request.region->unit_length() * request.region->side();
    std::set<std::vector<double>> sets;
    for (std::uint32_t k = 0; k < 4; ++k) {
        const PointSet set = plain->sample(k);
        EXPECT_EQ(kernel->sample(k), set);
        EXPECT_EQ(set.size(), 500U);
        EXPECT_TRUE(sets.insert(set.coordinates).second);
        const double densest = std::sqrt(2 / (std::sqrt(3.0) * 500)) * unit;
        EXPECT_GE(least_by_brute_force(set), plain->traits().proven_relative_radius.value() * densest);
        EXPECT_GT(plain->traits().proven_relative_radius.value(), 0.45);
        for (std::size_t i = 0; i < set.size(); ++i) EXPECT_TRUE(lies_in_yard(set[i][0], set[i][1]));
    }
    const auto by_distance =
        region_sampler("corner-tiles", small_tiles({{"min_distance", 7.0}}), request, Engine::opencl);
    EXPECT_GE(least_by_brute_force(by_distance->sample(2)), 7);
}

/// Whole tilings lie in the plane: what is in a region is in its halves.
TEST(TilesInRegions, OfHalvesAreThoseOfTheWhole)
{
    const auto set_in = [&](const std::string& region, double density) {
        const auto sampler = region_sampler("corner-tiles", small_tiles({{"min_distance", 0.02}, {"density", density}}),
                                            request_in(region, 500), Engine::opencl);
        const PointSet points = sampler->sample(1);
        std::set<std::pair<long, long>> places; // of regions elsewhere, distances are enlarged by other roundings
        for (std::size_t i = 0; i < points.size(); ++i)
            places.emplace(std::lround(points[i][0] * 1e9), std::lround(points[i][1] * 1e9));
        return places;
    };
    const auto whole = set_in("rectangle 0 0 2 1", 1), half = set_in("rectangle 0 0 2 1", 0.5);
    std::set<std::pair<long, long>> parts = set_in("rectangle 0 0 1.000001 1", 1);
    parts.merge(set_in("rectangle 1.000001 0 2 1", 1));
    EXPECT_EQ(parts, whole);
    EXPECT_TRUE(std::ranges::includes(whole, half));
    const auto n = static_cast<double>(whole.size());
    EXPECT_NEAR(static_cast<double>(half.size()), n / 2, 5 * std::sqrt(n / 4));
}

TEST(SamplersInRegionsMemory, IsForetold)
{
    Device device = Device::open();
    const std::vector<std::pair<std::string, std::map<std::string, ParameterValue>>> cases{
        {"dart-throwing", {{"relative_radius", 0.7}}},
        {"dart-throwing", {{"min_distance", 1.5}}},
        {"relaxation-dart-throwing", {}},
        {"lloyd", {{"iterations", std::int64_t{1}}}},
        {"sample-elimination", {}},
        {"gaussian-blue-noise", {{"iterations", std::int64_t{1}}}},
        {"bridson", {}},
        {"random", {}},
        {"corner-tiles", small_tiles({})},
        {"corner-tiles", small_tiles({{"min_distance", 1.5}})}};
    for (const auto& [name, given] : cases)
        for (const std::size_t points : {200, 10'000}) {
            SCOPED_TRACE(name + ", " + std::to_string(points));
            const SampleRequest request = request_in(yard, points);
            const SamplerSpec& spec = sampler_in_regions(name);
            const Parameters parameters = checked_parameters(name, given, request);
            const TemporaryFolder cache; // without tile sets, so that these are built
            setenv("POISSONLAB_CACHE", cache.path().c_str(), 1);
            const std::uint64_t before = device.memory().total;
            device.watch_memory();
            spec.create(parameters, request, Engine::opencl, [&]() -> Device& { return device; })->sample(0);
            const std::uint64_t taken = device.peak_memory().total - before;
            const DeviceMemory foretold =
                spec.device_memory ? spec.device_memory(parameters, request, device.info()) : DeviceMemory{};
            EXPECT_GE(foretold.total, taken);
            EXPECT_LE(static_cast<double>(foretold.total), 1.3 * static_cast<double>(taken));
            EXPECT_EQ(foretold.total > 0, spec.memory_growth != MemoryGrowth::none);
        }
    unsetenv("POISSONLAB_CACHE");
}

/// It is sequential by definition.
TEST(BridsonInRegions, NeedsNoDevice)
{
    const SampleRequest request = request_in(yard, 500);
    const DeviceProvider none = []() -> Device& { throw DeviceError("there is no device"); };
    const auto sampler =
        sampler_in_regions("bridson").create(checked_parameters("bridson", {}, request), request, Engine::opencl, none);
    EXPECT_GT(sampler->sample(0).size(), 400U);
}

TEST(SamplersInRegionsErrors, NameWhatDecides)
{
    const SampleRequest request = request_in(yard, 500);
    const auto told = [&](const std::string& name, const std::map<std::string, ParameterValue>& given) {
        return message_of([&] { region_sampler(name, given, request, Engine::reference)->sample(0); });
    };
    EXPECT_THAT(told("dart-throwing", {}),
                HasSubstr("test.toml:3: sampler = \"dart-throwing\": needs relative_radius"));
    EXPECT_THAT(told("dart-throwing", {{"relative_radius", 0.7}, {"min_distance", 1.0}}),
                HasSubstr("test.toml:4: relative_radius = 0.7: cannot be combined with min_distance"));
    EXPECT_THAT(told("dart-throwing", {{"relative_radius", 0.95}}),
                HasSubstr("test.toml:4: relative_radius = 0.95: realization 0: the region is saturated with"));
    EXPECT_THAT(told("bridson", {{"min_distance", 400.0}}),
                HasSubstr("test.toml:4: min_distance = 400: 400 is more than the region's longest side, 300"));
    EXPECT_THAT(
        told("dart-throwing", {{"min_distance", 1e-6}}),
        HasSubstr(
            "test.toml:4: min_distance = 1e-06: a minimum distance of 1e-06 is too short for a region of this extent"));
    const SampleRequest few = request_in(yard, 20);
    EXPECT_THAT(message_of([&] { region_sampler("gaussian-blue-noise", {}, few, Engine::reference); }),
                HasSubstr("20 points are too few: in a region at least"));
    const SampleRequest slit = request_in("rectangle 0 0 300 0.01", 200);
    EXPECT_THAT(message_of([&] {
                    region_sampler("bridson", {{"boundary", std::string("disks")}}, slit, Engine::reference)->sample(2);
                }),
                HasSubstr("yard: sampler = \"bridson\": realization 2: the region has no room for a disk of diameter"));
    EXPECT_THAT(message_of([&] {
                    region_sampler("gaussian-blue-noise", {{"boundary", std::string("disks")}}, slit, Engine::reference)
                        ->sample(0);
                }),
                HasSubstr("sampler = \"gaussian-blue-noise\": realization 0: "));
    EXPECT_THAT(told("corner-tiles", small_tiles({{"min_distance", 1e-6}})),
                HasSubstr("test.toml:4: min_distance = 1e-06: with tiles of"));
}

TEST(SamplersInRegionsHelp, IsTheTableOfTheDocumentation)
{
    const std::string page = read_whole_file(source_folder() + "/docs/samplers.md");
    const std::string begin = "<!-- samplers in regions, printed by `poissonlab samplers --markdown` -->\n";
    const std::size_t from = page.find(begin), to = page.find("<!-- end of samplers in regions -->");
    ASSERT_NE(from, std::string::npos);
    EXPECT_EQ(page.substr(from + begin.size(), to - from - begin.size()), samplers_markdown(region_sampler_registry()));
    for (const SamplerSpec& spec : region_sampler_registry()) EXPECT_TRUE(find_sampler(spec.name)) << spec.name;
}

}
}
