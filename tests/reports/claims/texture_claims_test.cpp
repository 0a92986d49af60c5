// Claims about texture tiles: each agrees with results as the papers have them, and not with others.
#include "reports/claims/paper_claims.hpp"
#include "results/texture_measures.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <deque>

namespace poissonlab {
namespace {

using testing::HasSubstr;

/// Textures of one exemplar whose numbers are made up.
class MadeUpTextures
{
public:
    DistributionResult& add(const std::string& kind, const std::string& stages, const std::string& colors,
                            const std::map<std::string, double>& numbers, const std::string& tiles = "complete")
    {
        DistributionResult& texture = textures_.emplace_back();
        texture.kind = "texture";
        texture.parameters = {{"exemplar", "brick"}, {"kind", kind},   {"colors", colors}, {"size", "64"},
                              {"smooth", "false"},   {"tiles", tiles}, {"stages", stages}};
        texture.numbers.push_back(texture_number("tiles", 16, {}));
        for (const auto& [key, value] : numbers) texture.numbers.push_back(texture_number(key, value, 0.01));
        return texture;
    }

    /// The outcome of a claim; empty: it is left out.
    std::optional<ClaimOutcome> outcome(const std::string& id) const
    {
        std::vector<const DistributionResult*> all;
        for (const DistributionResult& texture : textures_) all.push_back(&texture);
        for (const JudgedClaim& judged : judge_claims({}, all))
            if (judged.claim->id == id) return judged.outcome;
        return std::nullopt;
    }

private:
    std::deque<DistributionResult> textures_;
};

TEST(TextureClaims, AreAboutEqualMemoryOnOneExemplar)
{
    MadeUpTextures textures;
    textures.add("omega", "1", "4", {{"color_distance", 1}});
    DistributionResult& wang = textures.add("wang", "3", "2", {{"color_distance", 2}});
    EXPECT_TRUE(textures.outcome("5.3-similar"));
    wang.numbers[0].value = 81;
    EXPECT_FALSE(textures.outcome("5.3-similar"));
    wang.numbers[0].value = 16;
    wang.parameters[0].value = "gravel";
    EXPECT_FALSE(textures.outcome("5.3-similar"));
}

TEST(TextureClaims, CountBordersThatDoNotFit)
{
    MadeUpTextures textures;
    textures.add("corner", "3", "2", {{"border_exceptions", 0}});
    DistributionResult& wang = textures.add("wang", "3", "2", {{"border_exceptions", 0}});
    EXPECT_EQ(textures.outcome("cohen-2003-fit")->agreement, Agreement::agrees);
    EXPECT_EQ(textures.outcome("5.3-corners")->agreement, Agreement::agrees);
    wang.numbers[1].value = 0.9;
    EXPECT_EQ(textures.outcome("cohen-2003-fit")->agreement, Agreement::disagrees);
    EXPECT_THAT(textures.outcome("cohen-2003-fit")->measured, HasSubstr("0.90 pairs of pixels a border"));
    EXPECT_EQ(textures.outcome("5.3-corners")->agreement, Agreement::agrees);
}

/// A number that is not there is none, not 0.
TEST(TextureClaims, AreNotJudgedWithoutTheirNumbers)
{
    MadeUpTextures textures;
    textures.add("omega", "1", "4", {});
    textures.add("corner", "0", "2", {});
    textures.add("wang", "3", "2", {});
    textures.add("wang", "3", "2", {}, "compact");
    textures.add("wang", "3", "3", {}, "compact");
    for (const char* id : {"cohen-2003-fit", "5.3-corners", "cohen-2003-more-tiles", "5.3-new-patch", "5.3-similar",
                           "ng-2005-large", "ng-2005-junctions", "ng-2005-straight"})
        EXPECT_FALSE(textures.outcome(id)) << id;
}

TEST(TextureClaims, CountMarkedTiles)
{
    MadeUpTextures textures;
    EXPECT_FALSE(textures.outcome("cohen-2003-marked"));
    for (const std::string tiles : {"compact", "random-marks"}) {
        DistributionResult& marked = textures.add("wang", "3", "2", {{"border_exceptions", 1}}, tiles);
        marked.parameters.push_back({"marked_exemplar", "snow"});
        marked.numbers[0].value = tiles == "compact" ? 128 : 64;
        EXPECT_EQ(textures.outcome("cohen-2003-marked")->agreement, Agreement::agrees);
    }
    EXPECT_THAT(textures.outcome("cohen-2003-marked")->measured,
                testing::AllOf(HasSubstr("128 tiles with all marks"), HasSubstr("64 for marks at random")));
    // They are no placement that others are compared with.
    EXPECT_FALSE(textures.outcome("cohen-2003-fit"));
    textures.add("wang", "3", "2", {}, "compact").parameters.push_back({"marked_exemplar", "snow"});
    EXPECT_NE(textures.outcome("cohen-2003-marked")->agreement, Agreement::agrees);
}

}
}
