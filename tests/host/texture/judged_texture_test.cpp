// Sets that are made in two ways, of which the better one is kept.
#include "host/texture/judged_texture.hpp"

#include "host/texture/texture_build.hpp"
#include "tests/host/texture/random_picture.hpp"
#include "tests/tiles/texture/dead_leaves.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace poissonlab {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

TilingJudgement judgement(double novelty, int feature, double slow)
{
    TilingJudgement made;
    made.novelty[1] = novelty;
    made.feature = feature;
    made.slow = SlowPower{0.1, slow};
    return made;
}

TEST(JudgedTexture, KeepsWhatIsBetter)
{
    const auto choice = [](const TilingJudgement& together, const TilingJudgement& apart) {
        return better_texture(together, apart, 8, 64);
    };
    EXPECT_EQ(choice(judgement(0.024, 8, 0.1), judgement(0.007, 8, 0.1)).words,
              "Chosen together, with 2.4 % of new patches against 0.7 %");
    const TextureChoice broken = choice(judgement(0.024, 9, 0.1), judgement(0.007, 9, 0.1));
    EXPECT_FALSE(broken.is_together);
    EXPECT_EQ(broken.words,
              "Fitted one after another, with 0.7 % of new patches against 2.4 %: in the set that is chosen together, "
              "features of 9 pixels break at edges of 8 pixels");
    EXPECT_TRUE(choice(judgement(0.007, 9, 0.1), judgement(0.024, 9, 0.1)).is_together) << "it has fewer new patches";
    EXPECT_FALSE(choice(judgement(0.024, 32, 0.1), judgement(0.007, 32, 0.1)).is_together);
    EXPECT_TRUE(choice(judgement(0.024, 33, 0.1), judgement(0.007, 33, 0.1)).is_together) << "half of a tile";
    const TextureChoice uneven = choice(judgement(0.01, 8, 0.101), judgement(0.02, 8, 0.067));
    EXPECT_FALSE(uneven.is_together);
    EXPECT_THAT(uneven.words, HasSubstr("has 10.1 % of the power; in the picture it has 10.0 %"));
    EXPECT_TRUE(choice(judgement(0.01, 8, 0.099), judgement(0.02, 8, 0.01)).is_together) << "the exemplar has more";
    EXPECT_TRUE(choice(judgement(0.01, 8, 0.101), judgement(0.02, 8, 0.068)).is_together) << "the other one is as bad";
    TilingJudgement small = judgement(0, 9, 0.1);
    small.novelty[1].reset();
    EXPECT_EQ(choice(small, small).words,
              "Chosen together, without a count of new patches, as the picture is too small");
}

/// The set that is kept has the bytes that its construction alone makes: the joint one for noise, and the one that fits
/// one piece after another for leaves that are larger than edges.
TEST(JudgedTexture, IsASetOfOneConstruction)
{
    TextureRequest request;
    request.colors = {2, 2};
    request.size = 32;
    request.candidates = 2;
    request.rounds = 4;
    request.joint = request.is_judged = true;
    const auto go_on = [](const std::string&, std::size_t, std::size_t) {};
    for (const bool is_noise : {true, false}) {
        const PngPixels exemplar =
            is_noise ? test::random_picture(120, 110, 1, 7) : test::dead_leaves(160, 150, 3, 2, 900, 8);
        const BuiltTexture kept = build_texture(request, exemplar, go_on);
        EXPECT_EQ(kept.is_joint, is_noise);
        EXPECT_THAT(kept.choice, StartsWith(is_noise ? "Chosen together" : "Fitted one after another"));
        EXPECT_EQ(kept.set.parameters.contains("joint"), is_noise);
        TextureRequest plain = request;
        plain.is_judged = false;
        plain.joint = is_noise;
        const BuiltTexture expected = build_texture(plain, exemplar, go_on);
        EXPECT_EQ(kept.set.sources, expected.set.sources);
        EXPECT_EQ(kept.set.parameters, expected.set.parameters);
        EXPECT_EQ(expected.choice, "");
    }
}

}
}
