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
#include <memory>
#include <random>

namespace poissonlab {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

/// The differences of bytes: the largest one, and how many of all are above 1.
struct Differences
{
    int largest = 0;
    std::size_t beyond_rounding = 0, all = 0;
};

class TexturePlanePage : public test::CommandTest
{
protected:
    static void SetUpTestSuite() { browser_ = std::make_unique<test::Browser>(); }
    static void TearDownTestSuite() { browser_.reset(); }

    TexturePlanePage() : CommandTest("texture")
    {
        PngPixels noise{120, 110, 3, {}};
        std::mt19937 random(3);
        for (int i = 0; i < 120 * 110 * 3; ++i) noise.values.push_back(static_cast<std::uint8_t>(random()));
        write_png(folder_.path() / "noise.png", {120, 110, 3},
                  [&](int row, int) { return &noise.values[noise.at(0, row, 0)]; });
    }

    /// The picture that `texture map` draws.
    PngPixels mapped(const std::string& set, const std::string& options) const
    {
        printed(fmt::format("map {} {} --seed 9 --size 48 32 --engine reference --quiet --out map.png", set, options));
        return read_png(folder_.path() / "map.png");
    }

    /// Counts how the page differs from a picture of texture map, with the same camera and filter.
    static Differences differences(const PngPixels& map, const std::string& view)
    {
        return differences_of_view(map, "{seed: 9, width: 48, height: 32, " + view + "}");
    }

    static Differences differences_of_view(const PngPixels& map, const std::string& view)
    {
        const std::string script = "Array.from(pixelsOf(" + view + ")).filter((b, i) => i % 4 < 3)";
        const auto shown = browser_->evaluate(script).get<std::vector<int>>();
        Differences found{0, 0, map.values.size()};
        EXPECT_EQ(shown.size(), map.values.size());
        for (std::size_t i = 0; i < std::min(shown.size(), map.values.size()); ++i) {
            const int apart = std::abs(shown[i] - map.values[i]);
            found.largest = std::max(found.largest, apart);
            found.beyond_rounding += apart > 1;
        }
        return found;
    }

    inline static std::unique_ptr<test::Browser> browser_;
};

TEST_F(TexturePlanePage, ShowsWhatMapsShow)
{
    for (const std::string& set : {std::string("corner"), std::string("wang")}) {
        SCOPED_TRACE(set);
        printed("build " + set + " --colors 3 --exemplar noise.png --size 16 --attempts 3 --quiet --out " + set);
        printed("export " + set + " --formats page --quiet --out " + set + "-engine");
        browser_->open(folder_.path() / (set + "-engine/plane.html"));
        if (!browser_->evaluate("document.createElement('canvas').getContext('webgl2') !== null").get<bool>())
            GTEST_SKIP() << "no WebGL2";
        EXPECT_THAT(browser_->messages(), IsEmpty());
        EXPECT_THAT(browser_->requests(), IsEmpty());
        // Floats of 24 bits place a sample to 2^-20 of a tile, a hundred-thousandth of noise's steps between texels;
        // then bytes are rounded. Of the second view, a pixel covers up to 16 texels, a tile: levels 0 to 4 are seen.
        const PngPixels near_by = mapped(set, "--filter bilinear --tile -7 4000000000 --above 1.5 --pitch 90 --yaw 20"),
                        levels = mapped(set, "--filter mipmap --tile 5 6 --above 4 --pitch 50 --yaw -70");
        const std::string above = "above: 1.5, pitch: 90, yaw: 20, hasLevels: false";
        for (const std::string look : {"exact", "layered"}) {
            const std::string with_look = ", look: '" + look + "'";
            EXPECT_LE(differences(near_by, "tile: [-7, 4000000000], " + above + with_look).largest, 1) << look;
            EXPECT_LE(differences(levels, "tile: [5, 6], above: 4, pitch: 50, yaw: -70" + with_look).largest, 1)
                << look;
        }
        EXPECT_GT(differences(near_by, "tile: [77, 40], " + above + ", look: 'exact'").beyond_rounding, 1000)
            << "other tiles are other pixels";
    }
}

/// The command that the page prints draws what it shows, wherever users went: also where pixels cover several tiles.
TEST_F(TexturePlanePage, PrintsTheCommandOfWhatItShows)
{
    printed("build corner --colors 2 --exemplar noise.png --size 16 --attempts 3 --quiet --out set");
    printed("export set --formats page --quiet --out engine");
    browser_->open(folder_.path() / "engine/plane.html");
    if (!browser_->evaluate("document.createElement('canvas').getContext('webgl2') !== null").get<bool>())
        GTEST_SKIP() << "no WebGL2";
    browser_->evaluate("canvas.style.width = '96px'; canvas.style.height = '64px'");
    for (const std::string moves : {"", "move(0.30001, 1.7); turn(31.234567, 33.333333); lift(1.1234567)"}) {
        browser_->evaluate(moves + "; drawNow()");
        const auto command = browser_->evaluate("byId('command').textContent").get<std::string>();
        const std::string begin = "poissonlab texture ";
        ASSERT_EQ(command.substr(0, begin.size()), begin);
        printed(command.substr(begin.size()) + " --engine reference --quiet");
        const PngPixels map = read_png(folder_.path() / "plane.png");
        ASSERT_EQ(map.width, 96);
        ASSERT_EQ(map.height, 64);
        EXPECT_LE(differences_of_view(map, "shown()").largest, 1) << command;
    }
}

/// Hardware weighs texels with 8 bits along each axis: light is off by 2 / 256 of the largest step at most, which are
/// 26 bytes where sRGB is steepest, and fewer than 3 where light is above a tenth.
TEST_F(TexturePlanePage, ShowsThePackedAtlasAsHardwareReadsIt)
{
    printed("build corner --colors 2 --exemplar noise.png --size 32 --ring 2 --attempts 3 --quiet --out set");
    printed("export set --formats page --quiet --out engine");
    browser_->open(folder_.path() / "engine/plane.html");
    if (!browser_->evaluate("document.createElement('canvas').getContext('webgl2') !== null").get<bool>())
        GTEST_SKIP() << "no WebGL2";
    const Differences magnified = differences(mapped("set", "--filter bilinear --tile 3 -2 --above 0.4 --pitch 90"),
                                              "tile: [3, -2], above: 0.4, pitch: 90, look: 'packed'");
    EXPECT_LE(magnified.largest, 26);
    EXPECT_LE(magnified.beyond_rounding, magnified.all / 4);
    browser_->click("#fly");
    EXPECT_THAT(browser_->evaluate("byId('command').textContent").get<std::string>(),
                HasSubstr("--tile 0 0 --start 0.5 0.5 --above 2 --pitch 15 --yaw 0 --field 60 --seed 1"));
    browser_->evaluate("new Promise(done => setTimeout(done, 300))");
    EXPECT_NE(browser_->evaluate("state.start[1]"), 0.5) << "it flies north";
}

}
}
