// The page of an endless tiling in a real browser, from disk: its points are those of runtime/poisson_tiles.h, which
// are those of `poissonlab tiles points`. Needs Chromium.
#include "reports/pages/page_endless.hpp"

#include "base/files/whole_file.hpp"
#include "runtime/poisson_tiles.h"
#include "tests/support/browser.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/picture.hpp"
#include "tests/support/places.hpp"
#include "tests/support/random_tile_set.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tiles/poisson/tile_set_file.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstring>

namespace poissonlab {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

/// A tile set that ships, ranked, its page, and one browser for all tests.
class EndlessPage : public testing::Test
{
protected:
    static void SetUpTestSuite()
    {
        bytes_ = read_whole_file(source_folder() + "/runtime/tile_sets/corner-c3-n64-r075.ptiles");
        aligned_.resize(bytes_.size() / 2);
        std::memcpy(aligned_.data(), bytes_.data(), bytes_.size());
        ASSERT_EQ(ptiles_open(&set_, aligned_.data(), bytes_.size()), nullptr);
        folder_ = std::make_unique<TemporaryFolder>();
        write_whole_file(page(), render_endless_page(bytes_, "corner-c3-n64-r075.ptiles"));
        browser_ = std::make_unique<test::Browser>();
    }
    static void TearDownTestSuite()
    {
        browser_.reset();
        folder_.reset();
    }

    static std::filesystem::path page() { return folder_->path() / "endless page.html"; }

    static void open(const std::string& fragment = {})
    {
        browser_->resize(1000, 800);
        browser_->open(page(), fragment);
        EXPECT_THAT(browser_->messages(), IsEmpty());
        EXPECT_THAT(browser_->requests(), IsEmpty());
    }

    static nlohmann::json evaluate(const std::string& script) { return browser_->evaluate(script); }

    /// The points of whole tiles by the header, as the page gives them.
    static nlohmann::json expected(std::uint32_t seed, std::array<double, 2> low, double width, double height,
                                   double density = 1)
    {
        const ptiles_tiling tiling{set_, seed, 0};
        const std::array<double, 2> high{low[0] + width, low[1] + height};
        std::vector<ptiles_point> points(100'000);
        points.resize(ptiles_in_window(&tiling, low.data(), high.data(), points.data(), points.size(), density));
        nlohmann::json all = nlohmann::json::array();
        for (const ptiles_point& p : points) all.push_back({p.position[0], p.position[1], p.id, p.level});
        return all;
    }

    static nlohmann::json shown(const std::string& window)
    {
        return evaluate("windowPoints([" + window + "]).map(p => [p.position[0], p.position[1], p.id, p.level])");
    }

    static inline std::string bytes_;
    static inline std::vector<std::uint16_t> aligned_;
    static inline ptiles_set set_;
    static inline std::unique_ptr<TemporaryFolder> folder_;
    static inline std::unique_ptr<test::Browser> browser_;
};

TEST_F(EndlessPage, HasThePointsOfTheHeader)
{
    open();
    EXPECT_EQ(shown("-3, 2, 7, 5"), expected(1, {-3, 2}, 7, 5));
    open("seed=4000000000");
    EXPECT_EQ(shown("-3, 2, 7, 5"), expected(4'000'000'000, {-3, 2}, 7, 5));
    EXPECT_NE(shown("-3, 2, 7, 5"), expected(1, {-3, 2}, 7, 5));
}

/// Coordinates that are so large are exact: 2^30 tiles and 2^16 parts are 46 bits.
TEST_F(EndlessPage, HasThemABillionTilesAway)
{
    open("seed=5");
    browser_->click("#jump");
    browser_->click("#jump");
    EXPECT_EQ(evaluate("drawNow(), state.tile"), (nlohmann::json{2'000'000'000, 0}));
    EXPECT_EQ(shown("2000000000, 0, 4, 3"), expected(5, {2e9, 0}, 4, 3));
    EXPECT_THAT(evaluate("document.getElementById('status').textContent").get<std::string>(),
                HasSubstr("around tile (2000000000, 0); the nearest two are 0.1"));
    EXPECT_THAT(evaluate("document.getElementById('command').textContent").get<std::string>(),
                HasSubstr("poissonlab tiles points corner-c3-n64-r075.ptiles --window 19999999"));
    browser_->click("#jump"); // round the end of what 32 bits name
    EXPECT_EQ(evaluate("state.tile[0]"), 0);
}

/// More density adds points and moves none, by the slider and by the brush.
TEST_F(EndlessPage, ThinsByRanks)
{
    open("density=0.3");
    EXPECT_EQ(shown("0, 0, 6, 6"), expected(1, {0, 0}, 6, 6, 0.3));
    open();
    const nlohmann::json all = shown("-4, -4, 8, 8");
    evaluate("document.getElementById('painting').checked = true, document.getElementById('brush').value = 0");
    browser_->click("#view");
    const nlohmann::json painted = shown("-4, -4, 8, 8");
    EXPECT_LT(painted.size(), all.size() - 5);
    EXPECT_GT(painted.size(), all.size() - 100);
    for (const auto& point : painted) EXPECT_NE(std::ranges::find(all, point), all.end());
    browser_->click("#clear");
    EXPECT_EQ(shown("-4, -4, 8, 8"), all);
}

/// Pixels at points are ink, those at empty places are not: by the canvas itself.
TEST_F(EndlessPage, DrawsThePoints)
{
    open("tile=7,-3&zoom=200");
    const nlohmann::json dark = evaluate(R"js((() => {
        state.borders = false;
        drawNow();
        const context = canvas.getContext("2d");
        const [width, height] = [canvas.width, canvas.height];
        const ratio = devicePixelRatio;
        const inkAt = (x, y) => context.getImageData(Math.round(width / 2 + x * state.zoom * ratio),
                                                     Math.round(height / 2 - y * state.zoom * ratio), 1, 1).data[3];
        const points = seenPoints(0.4 * width / ratio / state.zoom, 0.4 * height / ratio / state.zoom);
        return [points.length, points.filter((p) => inkAt(p.x, p.y) > 200).length,
                points.filter((p) => inkAt(p.x + minDistance / 2, p.y) > 0).length];
    })())js");
    EXPECT_GT(dark[0].get<int>(), 200);
    EXPECT_EQ(dark[1], dark[0]);
    EXPECT_LT(dark[2].get<int>(), dark[0].get<int>() / 10);
    for (const char* look : {"distances", "instances"}) {
        open(std::string("look=") + look);
        EXPECT_GT(test::decode_png(browser_->screenshot()).variance(), 100) << look;
    }
}

TEST_F(EndlessPage, GoesByKeysAndByTheMouse)
{
    open("zoom=100");
    browser_->click("#view");
    for (const char* key : {"ArrowRight", "ArrowRight", "ArrowUp"}) browser_->press(key);
    EXPECT_NEAR(evaluate("state.at[0]").get<double>(), 0.3, 1e-9); // 0.5 + 2 * 40 / 100 is in the next tile
    EXPECT_EQ(evaluate("state.tile"), (nlohmann::json{1, 0}));
    EXPECT_NEAR(evaluate("state.at[1]").get<double>(), 0.9, 1e-9);
    browser_->press("+");
    EXPECT_NEAR(evaluate("state.zoom").get<double>(), 125, 1e-9);
    browser_->press("Home");
    EXPECT_EQ(evaluate("[state.tile, state.at]"), (nlohmann::json{{0, 0}, {0.5, 0.5}}));
    // What is under the mouse stays there.
    EXPECT_NEAR(evaluate("zoomBy(2, 100, 50), state.at[0] + 100 / state.zoom").get<double>(), 0.5 + 100.0 / 125, 1e-9);
    EXPECT_NEAR(evaluate("state.at[1] - 50 / state.zoom").get<double>(), 0.5 - 50.0 / 125, 1e-9);
}

/// The seams of chunks show; the tiling has none. The spectrum is dark in the middle.
TEST_F(EndlessPage, StandsBesideChunksAndItsSpectrum)
{
    open();
    browser_->click("#beside");
    browser_->click("#show-spectrum");
    evaluate("drawNow()");
    const std::string said = evaluate("document.getElementById('chunks-status').textContent");
    EXPECT_THAT(said, HasSubstr("too near to one across a border"));
    EXPECT_GT(evaluate("parseInt(document.getElementById('chunks-status').textContent.split(', ').pop())").get<int>(),
              20);
    EXPECT_EQ(evaluate("nearPairs(windowPoints([0, 0, 9, 9]).map(p => p.position), minDistance).near.size"), 0);
    const nlohmann::json power = evaluate(R"js((() => {
        const points = windowPoints([0, 0, 8, 8]).map((p) => [p.position[0] / 8, p.position[1] / 8]);
        const power = powerOf(points, 256);
        const mean = (from, to) => {
            let [sum, count] = [0, 0];
            power.forEach((p, i) => {
                const away = Math.hypot((i % 256) - 128, Math.floor(i / 256) - 128);
                if (away >= from && away < to) [sum, count] = [sum + p, count + 1];
            });
            return sum / count;
        };
        return [mean(8, 32), mean(60, 80), mean(100, 120)];
    })())js");
    EXPECT_LT(power[0].get<double>(), 0.2);
    EXPECT_GT(power[1].get<double>(), 1.2);
    EXPECT_NEAR(power[2].get<double>(), 1, 0.25);
}

/// The transform against its definition.
TEST_F(EndlessPage, ComputesSpectraByTheirDefinition)
{
    open();
    EXPECT_LT(evaluate(R"js((() => {
        const points = [[0, 0], [0.125, 0.5], [0.375, 0.875], [0.9375, 0.0625]];
        const power = powerOf(points, 16);
        let worst = 0;
        for (let y = -8; y < 8; ++y)
            for (let x = -8; x < 8; ++x) {
                if (x === 0 && y === 0) continue;
                let [real, imaginary] = [0, 0];
                for (const [px, py] of points) {
                    real += Math.cos(2 * Math.PI * (x * px + y * py));
                    imaginary -= Math.sin(2 * Math.PI * (x * px + y * py));
                }
                worst = Math.max(worst, Math.abs((real ** 2 + imaginary ** 2) / 4 - power[(y + 8) * 16 + x + 8]));
            }
        return worst;
    })())js")
                  .get<double>(),
              1e-12);
}

TEST_F(EndlessPage, WritesFiles)
{
    open();
    const std::string csv = evaluate("fileOf('csv', windowPoints([0, 0, 2, 1]), 'x')");
    EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(csv, '\n')), expected(1, {0, 0}, 2, 1).size() + 1);
    EXPECT_THAT(csv, testing::StartsWith("x,y,level,id\n"));
    const std::string ply = evaluate("fileOf('ply', windowPoints([0, 0, 2, 1]), 'x')");
    EXPECT_THAT(ply, HasSubstr(fmt::format("element vertex {}\n", expected(1, {0, 0}, 2, 1).size())));
    EXPECT_THAT(evaluate("fileOf('usda', windowPoints([0, 0, 1, 1]), 'x')").get<std::string>(),
                HasSubstr("def PointInstancer \"points\""));
}

TEST(EndlessPages, OfTilesInSpaceAreRefused)
{
    const std::string space = encode_tile_set(random_tile_set(PoissonTileKind::corner, 3, 2, 9));
    EXPECT_THAT(message_of([&] { render_endless_page(space, "space.ptiles"); }),
                HasSubstr("space.ptiles: tiles in space: must be in the plane"));
    EXPECT_THAT(message_of([] { render_endless_page("no tiles", "a.ptiles"); }), HasSubstr("a.ptiles"));
}

}
}
