// Hats and spectres in regions: the samplers of series against windows of the runtime header, and against all
// distances.
#include "analysis/regions/framed_region.hpp"
#include "base/random/random.hpp"
#include "base/regions/region_text.hpp"
#include "host/tile_sampling/monotiles/monotile_sampler.hpp"
#include "host/tile_sampling/monotiles/region_monotile_sampler.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/places.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tiles/poisson/monotile_points_file.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <set>

namespace poissonlab {
namespace {

struct RegionSeries
{
    RegionSeries(const std::string& word, const std::string& region, std::size_t points,
                 const std::map<std::string, ParameterValue>& given, std::uint64_t seed = 3)
        : spec(region_monotile_sampler(word, word == "hat" ? hat_sampler() : spectre_sampler())),
          parameters(spec.parameters), request{points, 2, seed}
    {
        request.region = std::make_shared<const FramedRegion>(read_region(region, {.is_planar = true}), "yard");
        for (const auto& [key, value] : given) parameters.set(key, value, {"test.toml", 4});
        spec.check(parameters, request, {"test.toml", 3});
        sampler = spec.create(parameters, request, Engine::opencl, {});
    }

    SamplerSpec spec;
    Parameters parameters;
    SampleRequest request;
    std::unique_ptr<Sampler> sampler;
};

std::vector<std::string> shipped(const std::string& word)
{
    return {fmt::format("{}/runtime/tile_sets/{}-n4.ptiles", source_folder(), word)};
}

double least_in_set(const PointSet& points)
{
    double least = HUGE_VAL;
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            least = std::min(least, std::hypot(points[i][0] - points[j][0], points[i][1] - points[j][1]));
    return least;
}

using RoundedPlaces = std::set<std::pair<long, long>>;

RoundedPlaces rounded_places(const PointSet& points)
{
    RoundedPlaces places;
    for (std::size_t i = 0; i < points.size(); ++i)
        places.emplace(std::lround(points[i][0] * 1e7), std::lround(points[i][1] * 1e7));
    return places;
}

/// A rectangle, in edges, is a window of the file at the place of the tiling that the realization has.
TEST(RegionMonotiles, HaveThePointsOfWindows)
{
    for (const char* word : {"hat", "spectre"}) {
        const MonotilePointsFile file = read_monotile_points(shipped(word).front());
        const double edge = pmono_min_distance(&file.set());
        RegionSeries series(word, "rectangle 0 0 60 40", 1, {{"tiles", shipped(word)}, {"min_distance", edge}});
        for (const std::uint32_t realization : {0U, 1U, 7U}) {
            const auto words =
                philox({0, 0, 0, 0}, stream_key(3, Purpose::isohedral_points, realization, 4)); // as in the sampler
            const std::array<std::int64_t, 2> origin{static_cast<std::int32_t>(words[0]),
                                                     static_cast<std::int32_t>(words[1])};
            const std::vector<pmono_point> expected = file.in_window(1, origin, {0, 0}, {60, 40});
            const PointSet found = series.sampler->sample(realization);
            // An edge is some 1e-9 longer than 1, so that a point near the border may be beyond it.
            EXPECT_NEAR(static_cast<double>(found.size()), static_cast<double>(expected.size()), 1);
            ASSERT_GT(found.size(), 500U);
            std::size_t same = 0;
            for (std::size_t i = 0; i < found.size(); ++i)
                same += std::ranges::any_of(expected, [&](const pmono_point& point) {
                    return std::hypot(point.position[0] - found[i][0], point.position[1] - found[i][1]) < 1e-6;
                });
            EXPECT_GE(same + 1, found.size());
        }
    }
}

/// Tables that are built and files keep the distance that is asked for, or have the number of points.
TEST(RegionMonotiles, KeepTheirDistanceAndHaveTheNumberThatIsAskedFor)
{
    const TemporaryFolder cache;
    setenv("POISSONLAB_CACHE", cache.path().c_str(), 1);
    const std::string yard =
        "POLYGON ((500 100, 530 101, 520 120, 500 119, 500 100), (505 105, 510 105, 510 110, 505 105))";
    for (const char* word : {"hat", "spectre"}) {
        SCOPED_TRACE(word);
        RegionSeries numbered(word, yard, 400, {{"points_per_tile", std::int64_t{2}}, {"levels", std::int64_t{0}}});
        RegionSeries at_distance(word, yard, 400, {{"tiles", shipped(word)}, {"min_distance", 0.7}});
        RegionSeries whole(word, yard, 400, {{"tiles", shipped(word)}});
        RegionSeries thinned(word, yard, 400, {{"tiles", shipped(word)}, {"density", 0.25}});
        std::set<RoundedPlaces> sets;
        for (std::uint32_t k = 0; k < 3; ++k) {
            const PointSet set = numbered.sampler->sample(k);
            EXPECT_NEAR(static_cast<double>(set.size()), 400, 2);
            EXPECT_EQ(numbered.sampler->sample(k), set);
            EXPECT_TRUE(sets.insert(rounded_places(set)).second);
            const double unit = numbered.request.region->unit_length() * numbered.request.region->side();
            const double densest = std::sqrt(2 / (std::sqrt(3.0) * static_cast<double>(set.size()))) * unit;
            const double proven = numbered.sampler->traits().proven_relative_radius.value();
            EXPECT_GT(proven, 0.7);
            EXPECT_GE(least_in_set(set), proven * densest);
            EXPECT_GE(least_in_set(at_distance.sampler->sample(k)), 0.7);
            EXPECT_NEAR(static_cast<double>(thinned.sampler->sample(k).size()), 400, 2);
        }
        ASSERT_GT(whole.sampler->sample(0).size(), 0U);
        // A quarter of the points of each tile is kept: as many points need tiles of half the width.
        EXPECT_NEAR(*thinned.sampler->traits().proven_relative_radius / *whole.sampler->traits().proven_relative_radius,
                    0.5, 0.02);
    }
}

/// One tiling lies under all regions of a seed: the points of a region are those of its halves.
TEST(RegionMonotiles, OfHalvesAreThoseOfTheWhole)
{
    const auto places_in = [&](const std::string& region) {
        return rounded_places(RegionSeries("spectre", region, 1, {{"tiles", shipped("spectre")}, {"min_distance", 0.5}})
                                  .sampler->sample(1));
    };
    RoundedPlaces parts = places_in("rectangle 0 0 11.000001 10");
    parts.merge(places_in("rectangle 11.000001 0 20 10"));
    EXPECT_EQ(parts, places_in("rectangle 0 0 20 10"));
}

TEST(RegionMonotiles, RefuseDistancesThatLeaveTooManyPoints)
{
    const auto refused = [](double distance) {
        return refusal_of([&] { RegionSeries("hat", "rectangle 0 0 1 1", 1, {{"min_distance", distance}}); });
    };
    EXPECT_THAT(refused(1e-9), testing::HasSubstr("test.toml:4: min_distance = 1e-09: must be larger"));
    EXPECT_EQ(refused(0.1), "accepted");
}

}
}
