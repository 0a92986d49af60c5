// The gallery's configs make what the gallery has, of every sampler that the program offers.
#include "experiment/config/plan.hpp"
#include "host/settings/sampler_registry.hpp"
#include "reports/gallery/gallery.hpp"
#include "tests/support/places.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <map>
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
        EXPECT_EQ(method.label, plan.label);
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

}
}
