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

/// The sentence on the view is longer far away; at any width the button stays where it is pressed.
TEST_F(EndlessPage, KeepsItsControlsInPlace)
{
    for (const int width : {1400, 800, 390}) {
        open("seed=5");
        browser_->resize(width, 800);
        const std::string top = "document.getElementById('jump').getBoundingClientRect().top + scrollY";
        const auto before = evaluate("drawNow(), " + top);
        browser_->click("#jump");
        EXPECT_EQ(evaluate("drawNow(), " + top), before) << width;
    }
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
    EXPECT_THAT(evaluate("byId('status').textContent").get<std::string>(),
                HasSubstr("coordinates of 32-bit floats would leave "));
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
    evaluate("byId('painting').checked = true, byId('brush').value = 0");
    browser_->click("#view");
    const nlohmann::json painted = shown("-4, -4, 8, 8");
    EXPECT_LT(painted.size(), all.size() - 5);
    EXPECT_GT(painted.size(), all.size() - 100);
    for (const auto& point : painted) EXPECT_NE(std::ranges::find(all, point), all.end());
    browser_->click("#clear");
    EXPECT_EQ(shown("-4, -4, 8, 8"), all);
}

/// Pixels at points are ink, those at empty places are not: of the plain canvas.
TEST_F(EndlessPage, DrawsThePointsOnAPlainCanvas)
{
    open("tile=7,-3&zoom=200&show=&draw=canvas");
    const nlohmann::json dark = evaluate(R"js((() => {
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
        open(std::string("draw=canvas&look=") + look);
        EXPECT_GT(test::decode_png(browser_->screenshot()).variance(), 100) << look;
    }
}

/// The middles of the spots that WebGL2 draws, in tiles from the middle of the view, and of points whose disks are
/// whole the number that has not exactly one of these within half a pixel. `points` are from the same middle.
constexpr auto spots_script = R"js(((points) => {
    drawNow();
    const { gl } = glPoints;
    const [width, height] = [gl.drawingBufferWidth, gl.drawingBufferHeight];
    const pixels = new Uint8Array(4 * width * height);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    const ink = Uint8Array.from({ length: width * height }, (_, n) => pixels[4 * n + 3]);
    const spots = [];
    for (let start = 0; start < ink.length; ++start) {
        if (ink[start] === 0) continue;
        const waiting = [start];
        const spot = { x: 0, y: 0, sum: 0, whole: true };
        while (waiting.length > 0) {
            const n = waiting.pop();
            if (!ink[n]) continue; // also outside
            const [x, y] = [n % width, Math.floor(n / width)];
            spot.x += ink[n] * (x + 0.5);
            spot.y += ink[n] * (y + 0.5);
            spot.sum += ink[n];
            if (x === 0 || y === 0 || x === width - 1 || y === height - 1) spot.whole = false;
            if (x > 0) waiting.push(n - 1);
            if (x < width - 1) waiting.push(n + 1);
            waiting.push(n - width, n + width);
            ink[n] = 0;
        }
        spots.push({ x: spot.x / spot.sum - width / 2, y: spot.y / spot.sum - height / 2, whole: spot.whole });
    }
    const scale = state.zoom * devicePixelRatio;
    const margin = pointRadius(minDistance, scale) + 2;
    const whole = points.map(([x, y]) => [x * scale, y * scale])
        .filter(([x, y]) => Math.abs(x) < width / 2 - margin && Math.abs(y) < height / 2 - margin);
    const near = ([x, y]) => spots.filter((s) => Math.hypot(s.x - x, s.y - y) < 0.5).length;
    const stray = spots.filter((s) => s.whole && !points.some(([x, y]) => Math.hypot(s.x - x * scale, s.y - y * scale) < 0.5));
    return [whole.length, whole.filter((p) => near(p) !== 1).length, stray.length];
}))js";

/// Points of the header around a place, from that place.
nlohmann::json from_place(const nlohmann::json& points, double x, double y)
{
    nlohmann::json places = nlohmann::json::array();
    for (const auto& point : points) places.push_back({point[0].get<double>() - x, point[1].get<double>() - y});
    return places;
}

/// Every point of the header is drawn where it is and nothing else, at home and a billion tiles away, all of them and
/// those of a density.
TEST_F(EndlessPage, DrawsThePointsByWebGl)
{
    for (const double x : {7.0, 1e9, -2e9})
        for (const double density : {1.0, 0.37}) {
            open(fmt::format("tile={:.0f},-3&at=0.3,0.6&zoom=200&show=&density={}", x, density));
            if (evaluate("glPoints === null").get<bool>()) GTEST_SKIP() << "no WebGL2";
            const nlohmann::json points = expected(1, {x - 4, -7}, 9, 9, density);
            const nlohmann::json spots =
                evaluate(std::string(spots_script) + "(" + from_place(points, x + 0.3, -2.4).dump() + ")");
            EXPECT_GT(spots[0].get<int>(), density < 1 ? 250 : 700);
            EXPECT_EQ(spots[1], 0) << x << " " << density;
            EXPECT_EQ(spots[2], 0) << x << " " << density;
        }
}

TEST_F(EndlessPage, PaintsForWebGlWhatItPaintsForTheFiles)
{
    open("zoom=200&show=&at=0.3,0.6&tile=-5,4");
    if (evaluate("glPoints === null").get<bool>()) GTEST_SKIP() << "no WebGL2";
    evaluate("painted.paint([-5, 4], [0.2, 0.4], 1.5, 0.3), painted.paint([-6, 4], [0.9, 0.1], 0.4, 0)");
    const nlohmann::json points = evaluate("windowPoints([-9, 1, 9, 8]).map(p => p.position)");
    ASSERT_LT(points.size(), 9 * 8 * 64 - 200u);
    const nlohmann::json spots = evaluate(std::string(spots_script) + "(" + from_place(points, -4.7, 4.6).dump() + ")");
    EXPECT_GT(spots[0].get<int>(), 400);
    EXPECT_EQ(spots[1], 0);
    EXPECT_EQ(spots[2], 0);
}

/// Both ways of drawing show the same; a browser that takes WebGL2 away is left with the plain canvas.
TEST_F(EndlessPage, LooksTheSameByWebGlAndOnAPlainCanvas)
{
    for (const std::string look : {"disks", "distances", "instances"}) {
        open("show=&zoom=90&look=" + look);
        if (evaluate("glPoints === null").get<bool>()) GTEST_SKIP() << "no WebGL2";
        const std::string grey = R"js(((picture) => {
            const small = document.createElement("canvas");
            [small.width, small.height] = [40, 30];
            const context = small.getContext("2d");
            context.fillStyle = "#fff";
            context.fillRect(0, 0, 40, 30);
            context.imageSmoothingQuality = "high";
            context.drawImage(picture, 0, 0, 40, 30);
            return Array.from(context.getImageData(0, 0, 40, 30).data);
        }))js";
        const auto by_gl = evaluate("(drawNow(), " + grey + "(byId('points')))").get<std::vector<int>>();
        evaluate("new Promise((done) => { byId('points').addEventListener('webglcontextlost', () => setTimeout(done));"
                 "glPoints.gl.getExtension('WEBGL_lose_context').loseContext(); })");
        const auto on_canvas = evaluate("(drawNow(), " + grey + "(canvas))").get<std::vector<int>>();
        EXPECT_TRUE(evaluate("glPoints === null && byId('points').hidden").get<bool>());
        double sum = 0, worst = 0;
        for (std::size_t i = 0; i < by_gl.size(); ++i) {
            const double apart = std::abs(by_gl[i] - on_canvas[i]);
            sum += apart;
            worst = std::max(worst, apart);
        }
        // A plain canvas has distances at every second pixel, and both smooth the edges of shapes in their own way.
        EXPECT_LT(sum / static_cast<double>(by_gl.size()), 4) << look;
        EXPECT_LT(worst, 64) << look;
    }
}

/// Far out each tile has some points left, those of low ranks; close up, parts of 1/65,536 are apart.
TEST_F(EndlessPage, ZoomsWithoutEnd)
{
    open("zoom=4");
    EXPECT_LT(evaluate("drawnTiles().shown").get<int>(), 64);
    EXPECT_THAT(evaluate("(drawNow(), byId('status').textContent)").get<std::string>(),
                HasSubstr("; of each tile the first"));
    const nlohmann::json near = evaluate(R"js((() => {
        const point = windowPoints([5, 5, 1, 1])[0];
        Object.assign(state, { tile: [5, 5], at: point.position.map((v) => v - 5), zoom: 5e6 });
        drawNow();
        const seen = seenPoints(...halves());
        return [seen.length, seen[0].x, seen[0].y];
    })())js");
    EXPECT_EQ(near, (nlohmann::json{1, 0, 0}));
    EXPECT_EQ(evaluate("(zoomBy(1000), state.zoom)"), 1e7);
    EXPECT_THAT(browser_->messages(), IsEmpty());
}

/// Work that would take minutes, or more memory than a browser gives, is not begun.
TEST_F(EndlessPage, RefusesFarTooManyTiles)
{
    open("zoom=4&show=beside");
    EXPECT_EQ(evaluate("(drawNow(), byId('chunks-status').textContent)"), "Too many tiles are in view: zoom in");
    EXPECT_EQ(evaluate("chunks.size"), 0);
    evaluate("save = () => (window.isSaved = true)");
    browser_->click("[data-save=csv]");
    EXPECT_EQ(evaluate("[byId('status').textContent, window.isSaved === true]"),
              (nlohmann::json{"Too many tiles are in view: zoom in", false}));
    evaluate("state.zoom = 100");
    browser_->click("[data-save=csv]");
    EXPECT_EQ(evaluate("window.isSaved"), true);
    EXPECT_THAT(browser_->messages(), IsEmpty());
}

/// The command takes pictures in parts of their densest place: where that has fewer points on the page, it says so.
TEST_F(EndlessPage, SaysWhatTheCommandMakesOfADensity)
{
    const auto command = [] { return evaluate("(drawNow(), byId('command').textContent)").get<std::string>(); };
    open("density=0"); // not below the slider's least
    EXPECT_THAT(command(), HasSubstr(" --density 0.02 --out points.txt"));
    open("zoom=400");
    evaluate("painted.paint([0, 0], [0.5, 0.5], 0.2, 0.2)");
    EXPECT_THAT(command(), testing::EndsWith(" --density density.png --out points.txt"));
    evaluate("painted.paint([0, 0], [0.5, 0.5], 9, 0.2)");
    EXPECT_THAT(command(), testing::EndsWith("# with all points at the densest place, which has 0.202 of them here"));
    evaluate("state.density = 0.5");
    EXPECT_THAT(command(), HasSubstr("which has 0.101 of them here"));
}

/// A link holds the view; Tab goes to everything that can be pressed, in the page's order.
TEST_F(EndlessPage, IsReachedByKeysAndByLinks)
{
    open("seed=9&tile=3,-4&at=0.25,0.75&zoom=80&look=instances&density=0.5&show=corners,beside");
    const std::string link = evaluate("(drawNow(), byId('link').href)");
    const std::string state = evaluate("JSON.stringify([state, boxes.filter(isShown)])");
    open();
    EXPECT_NE(evaluate("JSON.stringify([state, boxes.filter(isShown)])"), state);
    open(link.substr(link.find('#') + 1));
    EXPECT_EQ(evaluate("JSON.stringify([state, boxes.filter(isShown)])"), state);

    const std::string names = "(e) => e.id || e.dataset.save || e.dataset.copy";
    const nlohmann::json all = evaluate("Array.from(document.querySelectorAll('input, select, button, a[href], "
                                        "[tabindex]'), " +
                                        names + ")");
    evaluate("document.activeElement.blur()");
    nlohmann::json reached = nlohmann::json::array();
    for (std::size_t i = 0; i < all.size(); ++i) {
        browser_->press("Tab");
        reached.push_back(evaluate("(" + names + ")(document.activeElement)"));
    }
    EXPECT_EQ(reached, all);
    EXPECT_GT(all.size(), 20u);

    // The space bar paints in the middle.
    open("zoom=100");
    evaluate("byId('painting').checked = true, byId('brush').value = 0, canvas.focus()");
    const std::size_t before = evaluate("seenPoints(0.3, 0.3).length");
    browser_->press("Space");
    EXPECT_LT(evaluate("seenPoints(0.3, 0.3).length").get<std::size_t>(), before / 2);
}

/// The number of frames a second is said, on the page and here; a promise of a number would be one of machines.
TEST_F(EndlessPage, FliesAndCountsFrames)
{
    for (const std::string draw : {"", "draw=canvas"}) {
        open(draw);
        browser_->resize(1920, 1080);
        browser_->click("#fly");
        const std::string frames =
            evaluate("new Promise((done) => setTimeout(() => done(byId('frames').textContent), 2500))");
        EXPECT_THAT(frames, HasSubstr(" frames a second by ")) << draw;
        EXPECT_GT(evaluate("state.tile[0] + state.at[0]").get<double>(), 0.5);
        RecordProperty(draw.empty() ? "webgl" : "canvas", frames);
        browser_->click("#fly");
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
    // The place under the mouse stays there.
    EXPECT_NEAR(evaluate("zoomBy(2, 100, 50), state.at[0] + 100 / state.zoom").get<double>(), 0.5 + 100.0 / 125, 1e-9);
    EXPECT_NEAR(evaluate("state.at[1] + 50 / state.zoom").get<double>(), 0.5 + 50.0 / 125, 1e-9);
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

TEST_F(EndlessPage, GoesToAPlace)
{
    open();
    const auto go_to = [](const char* place) {
        evaluate(fmt::format("byId('place').value = '{}', byId('place').dispatchEvent(new Event('change')), drawNow()",
                             place));
        return evaluate("[state.tile, state.at, byId('place').value]");
    };
    EXPECT_EQ(go_to("-1000000.25, 7.5"), (nlohmann::json{{-1000001, 7}, {0.75, 0.5}, "-1000000.25, 7.50"}));
    EXPECT_EQ(go_to("here")[0], (nlohmann::json{-1000001, 7}));
    EXPECT_THAT(evaluate("byId('place').value = '1 2 3', byId('place').dispatchEvent(new Event('change')), "
                         "byId('status').textContent")
                    .get<std::string>(),
                HasSubstr("1 2 3: must be two numbers"));
    EXPECT_EQ(evaluate("byId('density-number').textContent"), "1");
}

/// Files have places from the window's corner, as the command that the page shows has them.
TEST_F(EndlessPage, WritesFiles)
{
    open();
    for (const char* window : {"0, 0, 2, 1", "2000000000, -3, 2, 1"}) {
        const auto all = shown(window), files = evaluate(fmt::format("filePoints([{}]).map(p => p.position)", window));
        ASSERT_EQ(files.size(), all.size());
        for (std::size_t i = 0; i < all.size(); ++i) {
            EXPECT_EQ(files[i][0].get<double>(), all[i][0].get<double>() - (window[0] == '0' ? 0 : 2e9));
            EXPECT_EQ(files[i][1].get<double>(), all[i][1].get<double>() + (window[0] == '0' ? 0 : 3));
        }
    }
    const std::string csv = evaluate("fileOf('csv', windowPoints([0, 0, 2, 1]), 'x', 0.1)");
    EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(csv, '\n')), expected(1, {0, 0}, 2, 1).size() + 1);
    EXPECT_THAT(csv, testing::StartsWith("x,y,level,id\n"));
    const std::string ply = evaluate("fileOf('ply', windowPoints([0, 0, 2, 1]), 'x', 0.1)");
    EXPECT_THAT(ply, HasSubstr(fmt::format("element vertex {}\n", expected(1, {0, 0}, 2, 1).size())));
    const std::string usd = evaluate("fileOf('usda', windowPoints([0, 0, 1, 1]), 'x', 0.1)");
    EXPECT_THAT(usd, HasSubstr("def PointInstancer \"points\""));
    // A quaternion and a scale each: their numbers of brackets, and those of positions and the triangle's corners.
    EXPECT_EQ(std::ranges::count(usd, '('), static_cast<std::ptrdiff_t>(3 * expected(1, {0, 0}, 1, 1).size() + 3));
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
