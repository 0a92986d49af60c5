// The page of `texture export` in a real browser, from disk: its WebGL2, with runtime/texture_look_up.glsl, shows what
// `texture map` draws. Needs Chromium.
#include "base/images/png_file.hpp"
#include "tests/support/browser.hpp"
#include "tests/support/command_test.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <random>

namespace poissonlab {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

/// How bytes differ: the largest difference, and how many of all differ by more than 1.
struct Differences
{
    int largest = 0;
    std::size_t beyond_rounding = 0, all = 0;
};

class TexturePlanePage : public test::CommandTest
{
protected:
    TexturePlanePage() : CommandTest("texture")
    {
        PngPixels noise{120, 110, 3, {}};
        std::mt19937 random(3);
        for (int i = 0; i < 120 * 110 * 3; ++i) noise.values.push_back(static_cast<std::uint8_t>(random()));
        write_png(folder_.path() / "noise.png", {120, 110, 3},
                  [&](int row, int) { return &noise.values[noise.at(0, row, 0)]; });
    }

    /// `texture map` and the page: the same camera, seed and filter.
    Differences differences(test::Browser& browser, const std::string& set, const std::string& options,
                            const std::string& view)
    {
        printed(fmt::format("map {} {} --seed 9 --size 48 32 --engine reference --quiet --out map.png", set, options));
        const PngPixels map = read_png(folder_.path() / "map.png");
        const std::string script =
            "Array.from(pixelsOf({seed: 9, width: 48, height: 32, " + view + "})).filter((b, i) => i % 4 < 3)";
        const auto shown = browser.evaluate(script).get<std::vector<int>>();
        Differences found{0, 0, map.values.size()};
        EXPECT_EQ(shown.size(), map.values.size());
        for (std::size_t i = 0; i < std::min(shown.size(), map.values.size()); ++i) {
            const int apart = std::abs(shown[i] - map.values[i]);
            found.largest = std::max(found.largest, apart);
            found.beyond_rounding += apart > 1;
        }
        return found;
    }
};

TEST_F(TexturePlanePage, ShowsWhatMapsShow)
{
    test::Browser browser;
    for (const std::string& set : {std::string("corner"), std::string("wang")}) {
        SCOPED_TRACE(set);
        printed("build " + set + " --colors 3 --exemplar noise.png --size 16 --attempts 3 --quiet --out " + set);
        printed("export " + set + " --formats page --quiet --out " + set + "-engine");
        browser.open(folder_.path() / (set + "-engine/plane.html"));
        if (!browser.evaluate("document.createElement('canvas').getContext('webgl2') !== null").get<bool>())
            GTEST_SKIP() << "no WebGL2";
        EXPECT_THAT(browser.messages(), IsEmpty());
        EXPECT_THAT(browser.requests(), IsEmpty());
        // Floats of 24 bits place a sample to 2^-20 of a tile, a hundred-thousandth of noise's steps between texels;
        // then bytes are rounded.
        for (const std::string& look : {std::string("exact"), std::string("layered")}) {
            const Differences near_by = differences(
                browser, set, "--filter bilinear --tile -7 4000000000 --above 1.5 --pitch 90 --yaw 20",
                "tile: [-7, 4000000000], above: 1.5, pitch: 90, yaw: 20, hasLevels: false, look: '" + look + "'");
            EXPECT_LE(near_by.largest, 1) << look;
            // A pixel covers up to 16 texels, a tile: levels 0 to 4 are seen.
            const Differences levels =
                differences(browser, set, "--filter mipmap --tile 5 6 --above 4 --pitch 50 --yaw -70",
                            "tile: [5, 6], above: 4, pitch: 50, yaw: -70, look: '" + look + "'");
            EXPECT_LE(levels.largest, 1) << look;
        }
        EXPECT_GT(differences(browser, set, "--filter bilinear --tile 0 0 --pitch 90",
                              "tile: [0, 1], pitch: 90, hasLevels: false, look: 'exact'")
                      .beyond_rounding,
                  3000)
            << "other tiles are other pixels";
    }
}

/// Hardware weighs texels with 8 bits: a byte may differ by 1/256 of the largest step between texels, and one of
/// rounding.
TEST_F(TexturePlanePage, ShowsThePackedAtlasAsHardwareReadsIt)
{
    printed("build corner --colors 2 --exemplar noise.png --size 32 --ring 2 --attempts 3 --quiet --out set");
    printed("export set --formats page --quiet --out engine");
    test::Browser browser;
    browser.open(folder_.path() / "engine/plane.html");
    if (!browser.evaluate("document.createElement('canvas').getContext('webgl2') !== null").get<bool>())
        GTEST_SKIP() << "no WebGL2";
    const Differences magnified = differences(browser, "set", "--filter bilinear --tile 3 -2 --above 1 --pitch 90",
                                              "tile: [3, -2], above: 1, pitch: 90, look: 'packed'");
    EXPECT_LE(magnified.largest, 8);
    EXPECT_LE(magnified.beyond_rounding, magnified.all / 10);
    browser.click("#fly");
    EXPECT_THAT(browser.evaluate("byId('command').textContent").get<std::string>(),
                HasSubstr("poissonlab texture map set --tile 0 0 --above 2 --pitch 15 --yaw 0 --field 60 --seed 1"));
    browser.evaluate("new Promise(done => setTimeout(done, 300))");
    EXPECT_NE(browser.evaluate("state.start[1]"), 0.5) << "it flies north";
}

}
}
