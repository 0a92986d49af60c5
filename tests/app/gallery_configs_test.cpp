// The gallery's configs make what the gallery has, of every sampler that the program offers.
#include "experiment/config/plan.hpp"
#include "host/settings/sampler_registry.hpp"
#include "reports/gallery/gallery.hpp"
#include "reports/gallery/table_reader.hpp"
#include "reports/words/number_format.hpp"
#include "tests/support/places.hpp"
#include "tests/support/program.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <regex>
#include <set>

namespace poissonlab {
namespace {

using testing::IsEmpty;

/// Samplers without a curve, and why.
const std::map<std::string, std::string> samplers_without_curve = {
    {"file", "its sets are made elsewhere"},
    {"command", "its sets are those of another program"},
};

/// The series of the gallery's configs by their names in the gallery.
std::map<std::string, SeriesPlan> gallery_plans()
{
    std::map<std::string, SeriesPlan> plans;
    for (const auto& entry : std::filesystem::directory_iterator(source_folder() + "/configs")) {
        if (!entry.path().filename().string().starts_with("gallery-")) continue;
        for (const SeriesPlan& plan : make_plan(read_config(entry.path()))) {
            const std::string name = plan.request.dimension == 3 ? plan.name + "-3d" : plan.name;
            EXPECT_TRUE(plans.emplace(name, plan).second) << name << " is in two configs";
        }
    }
    return plans;
}

TEST(GalleryConfigs, HaveEverySampler)
{
    std::set<std::pair<std::string, int>> planned;
    for (const auto& [name, plan] : gallery_plans()) planned.emplace(plan.sampler->name, plan.request.dimension);
    for (const SamplerSpec& sampler : sampler_registry())
        for (const int dimension : sampler.dimensions)
            EXPECT_NE(planned.contains({sampler.name, dimension}), samplers_without_curve.contains(sampler.name))
                << sampler.name << " in " << dimension << "D";
}

/// Configs and tables have the same series, one for one.
TEST(GalleryConfigs, MakeTheGallery)
{
    auto plans = gallery_plans();
    for (const GalleryMethod& method : reference_gallery()) {
        SCOPED_TRACE(method.name);
        const auto found = plans.find(method.name);
        ASSERT_NE(found, plans.end());
        const SeriesPlan& plan = found->second;
        EXPECT_EQ(with_formatted_points(method.label), with_formatted_points(plan.label));
        EXPECT_EQ(method.sampler, plan.sampler->name);
        EXPECT_EQ(method.seed, fmt::format("{}", plan.request.seed));
        EXPECT_EQ(method.curve.dimension, plan.request.dimension);
        EXPECT_EQ(method.curve.periodograms, static_cast<int>(plan.realizations));
        // Lattices and tilings have as many points as they can; windows of tiles of 8 kinds differ the most.
        EXPECT_NEAR(static_cast<double>(method.curve.points) / static_cast<double>(plan.request.points), 1, 0.05);
        std::set<std::string> given, stored;
        for (const auto& [key, entry] : plan.parameters.given()) given.insert(key);
        const auto parameters = nlohmann::json::parse(method.parameters);
        for (const auto& [key, value] : parameters.items()) stored.insert(key);
        EXPECT_EQ(stored, given);
        plans.erase(found);
    }
    std::vector<std::string> left;
    for (const auto& [name, plan] : plans) left.push_back(name);
    EXPECT_THAT(left, IsEmpty()) << "of the configs, but not in the gallery";
}

/// The number of tile sets that published values are means over, at least: the error of a mean over n sets is itself
/// known to one part in the root of 2 (n - 1), a third for 6.
constexpr std::int64_t fewest_sets = 6;

/// Samplers whose tiles are built by chance, so that another seed has other tiles and other values.
bool builds_tiles_by_chance(const SamplerSpec& sampler)
{
    return std::ranges::count(sampler.parameters, "sets", &ParameterSpec::key) > 0;
}

/// The sampler that a series is named after; null for none.
const SamplerSpec* sampler_of_name(const std::string& series)
{
    for (const SamplerSpec& sampler : sampler_registry())
        if (series.starts_with(sampler.name)) return &sampler;
    return nullptr;
}

/// The tile sets that the name of a series has: one where it has none.
std::int64_t sets_in_name(const std::string& series)
{
    std::smatch found;
    return std::regex_search(series, found, std::regex("-sets-([0-9]+)")) ? std::stol(found[1]) : 1;
}

/// Tilings of one set share its distances, so that their spread is rounding, some 10^-16 of the value, and share the
/// power on their lattice, so that errors are a part of those between sets: 3.8e-16 was published so of a relative
/// radius that twelve seeds have from 0.575 to 0.686. Each tiling has a set of its own: no error has to know of any two
/// of one.
TEST(PublishedTiles, AreOfSeveralSetsWithErrorsBetweenThem)
{
    for (const GalleryMethod& method : reference_gallery()) {
        SCOPED_TRACE(method.name);
        for (const auto& [key, estimate] : method.measures)
            if (const double error = estimate.standard_error.value_or(0); error > 0 && estimate.value != 0) {
                EXPECT_GE(error, 1e-12 * std::abs(estimate.value)) << key << " has rounding for an error";
            }
        if (method.curve.dimension == 3 || !builds_tiles_by_chance(*find_sampler(method.sampler))) continue;
        const auto sets = nlohmann::json::parse(method.parameters).value("sets", 1);
        EXPECT_GE(sets, fewest_sets);
        EXPECT_EQ(sets, method.curve.periodograms);
        for (const char* key : {"relative_radius", "min_distance", "mean_nearest_distance"})
            EXPECT_GT(method.measures.at(key).standard_error.value_or(0), 0) << key;
    }
    for (const char* file : {"seams.csv", "even.csv"})
        for (TableReader line(gallery_file(file), file, "name,measure,value,standard_error"); line.next();) {
            const SamplerSpec* const sampler = sampler_of_name(line.text(0));
            ASSERT_TRUE(sampler) << line.text(0);
            EXPECT_TRUE(line.estimate(2, 3).standard_error) << line.text(0) << ", " << line.text(1);
            if (builds_tiles_by_chance(*sampler)) {
                EXPECT_GE(sets_in_name(line.text(0)), fewest_sets) << line.text(0);
            }
        }
    std::map<double, std::set<double>> realizations;
    for (TableReader line(gallery_file("averaged.csv"), "averaged.csv", "realization,iteration,relative_radius");
         line.next();)
        realizations[line.number(1)].insert(line.number(0));
    EXPECT_GE(realizations.size(), 4U);
    for (const auto& [moves, of_moves] : realizations) EXPECT_GE(of_moves.size(), 12U) << moves;
}

/// Whoever runs the configs that the page of results names gets what it says.
TEST(PublishedTiles, AreMadeByTheConfigsThatThePageNames)
{
    const std::string page = content_of(source_folder() + "/docs/results.md");
    const std::regex command("lab run (configs/[a-z0-9/-]+[.]toml)");
    int tiles = 0;
    for (std::sregex_iterator found(page.begin(), page.end(), command), end; found != end; ++found)
        for (const SeriesPlan& plan : make_plan(read_config(source_folder() + "/" + (*found)[1].str()))) {
            if (!builds_tiles_by_chance(*plan.sampler)) continue;
            SCOPED_TRACE((*found)[1].str() + ": " + plan.name);
            ++tiles;
            const std::int64_t sets = plan.parameters.integer("sets");
            EXPECT_GE(sets, fewest_sets);
            EXPECT_GE(plan.realizations, sets);
        }
    EXPECT_GT(tiles, 10);
}

}
}
