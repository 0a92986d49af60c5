// `poissonlab distribute recursive`: its files, and its page in a real browser, from disk: the points that the page
// shows are those of the command, at any depth. Needs Chromium.
#include "base/files/whole_file.hpp"
#include "base/images/png_file.hpp"
#include "tests/support/browser.hpp"
#include "tests/support/places.hpp"
#include "tests/support/program.hpp"
#include "tests/support/temporary_folder.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

namespace poissonlab {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::IsEmpty;

/// Levels that are as deep as 2^60 times the size of a tile, and far away.
const std::string deep_x = "2147483648:031213012302123012301203120321";
const std::string deep_y = "-7:330121230120312301203123012301";

class RecursivePageOfCommand : public testing::Test
{
protected:
    static void SetUpTestSuite()
    {
        folder_ = std::make_unique<TemporaryFolder>();
        const std::string leaf = source_folder() + "/configs/papers/notes-2008/painting/leaf-1.png";
        const Outcome outcome = run({"--points", "10", "--stamps", leaf, "--out", "zoom.html"});
        ASSERT_EQ(outcome.status, 0) << outcome.error;
        browser_ = std::make_unique<test::Browser>();
    }
    static void TearDownTestSuite()
    {
        browser_.reset();
        folder_.reset();
    }

    static Outcome run(std::vector<std::string> words)
    {
        words.insert(words.begin(), {"distribute", "recursive", "--quiet"});
        return run_program(folder_->path(), words);
    }

    static void open(const std::string& fragment = {})
    {
        browser_->resize(900, 900);
        browser_->open(folder_->path() / "zoom.html", fragment);
        EXPECT_THAT(browser_->messages(), IsEmpty());
        EXPECT_THAT(browser_->requests(), IsEmpty());
    }

    static json evaluate(const std::string& script) { return browser_->evaluate(script); }

    /// The lines of a table, sorted.
    static std::vector<std::string> lines_of(const std::string& text)
    {
        std::vector<std::string> lines;
        std::istringstream all(text);
        for (std::string line; std::getline(all, line);) lines.push_back(line);
        std::ranges::sort(lines);
        return lines;
    }

    /// x and y of a table's lines, sorted.
    static std::vector<std::array<double, 2>> places_of(const std::string& text)
    {
        std::vector<std::array<double, 2>> places;
        std::istringstream all(text);
        std::string line;
        std::getline(all, line);
        while (std::getline(all, line)) {
            std::array<double, 2> place{};
            char comma = 0;
            std::istringstream(line) >> place[0] >> comma >> place[1];
            places.push_back(place);
        }
        std::ranges::sort(places);
        return places;
    }

    inline static std::unique_ptr<TemporaryFolder> folder_;
    inline static std::unique_ptr<test::Browser> browser_;
};

/// The page's points with just the density of the command, which has a whole number of points.
TEST_F(RecursivePageOfCommand, HasThePointsOfTheCommandThatItShows)
{
    for (const std::string& view :
         {std::string(), std::string("x=-3&y=4503599627370000&zoom=90"),
          std::string("x=-1:3333&y=0:0000&at=0.9,0.1&zoom=300"), "x=" + deep_x + "&y=" + deep_y + "&zoom=200",
          "x=5:" + std::string(300, '3') + "&y=-1:" + std::string(300, '0') + "&zoom=170"}) {
        open(view);
        std::istringstream words(evaluate("(drawNow(), byId('command').textContent)").get<std::string>());
        std::vector<std::string> arguments;
        for (std::string word; words >> word;) arguments.push_back(word);
        ASSERT_GT(arguments.size(), 5u) << view;
        arguments.erase(arguments.begin());
        arguments.emplace_back("--quiet");
        const Outcome outcome = run_program(folder_->path(), arguments);
        ASSERT_EQ(outcome.status, 0) << outcome.error;
        const auto by_command = lines_of(content_of(folder_->path() / "points.csv"));
        const auto on_page = lines_of(evaluate("(() => { const w = seenWindow(); const n = w.size[0] * w.size[1];"
                                               "return csvOf(plane.points(w, Math.round(perTile() * n) / n), 1); })()")
                                          .get<std::string>());
        EXPECT_GT(by_command.size(), 300u) << view;
        ASSERT_EQ(on_page.size(), by_command.size()) << view;
        // Turns and sizes are rounded by two languages: places and stamps are the same to the last digit.
        for (std::size_t i = 0; i < on_page.size(); ++i) {
            const auto cut = [](const std::string& line) {
                std::size_t end = 0;
                for (int comma = 0; comma < 3 && end != std::string::npos; ++comma) end = line.find(',', end + 1);
                return line.substr(0, end);
            };
            EXPECT_EQ(cut(on_page[i]), cut(by_command[i])) << view;
        }
        EXPECT_THAT(browser_->messages(), IsEmpty());
    }
}

/// All points that are drawn, by the cells that are: { x, y, shown } from the middle, in pixels, by what they look
/// like.
constexpr auto drawn_script = R"js((() => {
    const all = new Map();
    const n = set.pointsPerTile;
    for (const p of partsOf())
        for (let k = p.first; k < p.first + p.count; ++k) {
            const at = 4 * (p.segment * n + k);
            const rank = set.cellPoints[at + 2];
            const shown = Math.min(1, (p.demand / (rank + p.turn) - 1) / (fullAt - 1));
            if (rank < p.firstRank || shown <= 0) continue;
            const x = (p.offset[0] + set.cellPoints[at] / wholeTurn) * p.pixels;
            const y = (p.offset[1] + set.cellPoints[at + 1] / wholeTurn) * p.pixels;
            if (Math.abs(x) > 300 || Math.abs(y) > 250) continue;
            all.set(`${p.level}/${p.low}/${rank}`, [x, y, shown]);
        }
    return all;
}))js";

/// Zooming in and out by small steps, about a place: points that are seen before and after have moved as that place
/// says, none but new ones have appeared, those are pale, and there are as many as before.
TEST_F(RecursivePageOfCommand, KeepsPointsAndTheirNumberWhileOneZooms)
{
    for (const std::string& view : {std::string("zoom=40"), "x=" + deep_x + "&y=" + deep_y}) {
        open(view);
        const json said = evaluate(std::string(R"js((() => {
            const drawn = )js") + drawn_script +
                                   R"js(;
            const said = { counts: [], worst: 0, lost: 0, sudden: 0, renamed: 0, steps: 0 };
            for (let step = 0; step < 520; ++step) {
                const before = drawn();
                zoomBy(1.03, 31, -17);
                const after = drawn();
                let count = 0;
                for (const [name, [x, y, shown]] of before) {
                    count += shown;
                    const now = [31 + (x - 31) * 1.03, -17 + (y + 17) * 1.03];
                    if (Math.abs(now[0]) > 299 || Math.abs(now[1]) > 249) continue;
                    const found = after.get(name);
                    if (!found) {
                        // Points of tiles far above are taken over by the next tiles: they stay, under another name.
                        const same = [...after.values()].some((p) => Math.hypot(p[0] - now[0], p[1] - now[1]) < 1e-3);
                        if (same) ++said.renamed; else ++said.lost;
                        continue;
                    }
                    said.worst = Math.max(said.worst, Math.hypot(found[0] - now[0], found[1] - now[1]));
                    if (Math.abs(found[2] - shown) > 0.25) ++said.sudden;
                }
                said.counts.push(count);
                ++said.steps;
            }
            said.level = level();
            return said;
        })())js");
        EXPECT_EQ(said["lost"], 0);
        EXPECT_EQ(said["sudden"], 0); // a step adds 6.1 % to the density, and points come within 30 %
        // N times the view in tiles of level l, which are 160 pixels wide at least, over 16^4: 0.05 a level, and 1 in
        // all.
        EXPECT_LE(said["renamed"].get<int>(), 8);
        EXPECT_LT(said["worst"].get<double>(), 1e-3);
        EXPECT_GT(said["level"].get<int>(), 8);
        // 600 x 500 pixels have 3,000 points of a density, and a seventh less where new ones are pale.
        const auto counts = said["counts"].get<std::vector<double>>();
        const auto [least, most] = std::ranges::minmax_element(counts.begin() + 80, counts.end());
        EXPECT_GT(*least, 2400);
        EXPECT_LT(*most, 2900);
    }
}

/// Dark pixels are at the points that the page names, and nowhere else, on a tile of level 0 and 2^60 times as near.
TEST_F(RecursivePageOfCommand, DrawsPointsWhereTheyAre)
{
    for (const std::string& view : {std::string("zoom=300"), "x=" + deep_x + "&y=" + deep_y + "&zoom=200"}) {
        open(view);
        const json said = evaluate(R"js((() => {
            byId("stamps").value = "dots";
            byId("spacing").value = 16;
            byId("stamp-size").value = 0.8;
            showStamps();
            drawNow();
            const { gl } = transparentPicture();
            const [width, height] = [canvas.width, canvas.height];
            const pixels = new Uint8Array(4 * width * height);
            gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
            const window = seenWindow();
            const tiles = tilesInView(level(), 0);
            const near = new Uint8Array(width * height);
            let [all, missing] = [0, 0];
            for (const { x, y, threshold } of windowPoints(window)) {
                const [px, py] = [width / 2 + (tiles.offset[0] + x) * tiles.pixels, height / 2 + (tiles.offset[1] + y) * tiles.pixels];
                for (let j = Math.floor(py) - 9; j <= py + 9; ++j)
                    for (let i = Math.floor(px) - 9; i <= px + 9; ++i)
                        if (i >= 0 && j >= 0 && i < width && j < height) near[j * width + i] = 1;
                if (px < 8 || py < 8 || px > width - 8 || py > height - 8 || perTile() < fullAt * threshold) continue;
                ++all;
                if (pixels[4 * (Math.floor(py) * width + Math.floor(px)) + 3] < 250) ++missing;
            }
            let stray = 0;
            near.forEach((is, i) => { if (!is && pixels[4 * i + 3] > 0) ++stray; });
            const edge = (i) => i % width < 12 || i % width > width - 12 || i < 12 * width || i > (height - 12) * width;
            near.forEach((is, i) => { if (!is && edge(i) && pixels[4 * i + 3] > 0) --stray; });
            return [all, missing, stray];
        })())js");
        EXPECT_GT(said[0].get<int>(), 1000) << view;
        EXPECT_EQ(said[1], 0) << view;
        EXPECT_EQ(said[2], 0) << view;
    }
}

/// The painted sheet decides which points there are, in files, in the picture, and after zooming far in.
TEST_F(RecursivePageOfCommand, PaintsWithTheMouse)
{
    open("zoom=200");
    EXPECT_GT(evaluate("windowPoints(seenWindow()).length"), 1000);
    browser_->click("#empty");
    EXPECT_EQ(evaluate("windowPoints(seenWindow()).length"), 0);
    EXPECT_EQ(
        evaluate("(drawNow(), seenInk = () => { const { gl } = transparentPicture(); const p = new Uint8Array(4 * "
                 "canvas.width * "
                 "canvas.height); gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, p); "
                 "let sum = 0; for (let i = 3; i < p.length; i += 4) sum += p[i] > 0; return sum; }, seenInk())"),
        0);
    browser_->click("#painting");
    browser_->drag("#view", 0.3, 0.7, 0.5, 0.5);
    const json points = evaluate(R"js((() => {
        drawNow();
        const all = windowPoints(seenWindow());
        const weight = weightIn(seenWindow());
        return [all.length, all.every(({ x, y }) => weight(x, y) === 1), seenInk(), painted.layer.greys.includes(255), painted.layer.greys.includes(0)];
    })())js");
    // Forty pixels on each side of the way, and a half disk at each end, where a point has ten by ten. The border of
    // some 1,000 pixels has a point each ten, which is on either side of it.
    const double way = 0.4 * evaluate("canvas.clientWidth").get<double>();
    EXPECT_NEAR(points[0].get<int>(), (way * 80 + 1600 * std::numbers::pi) / 100, 5 * std::sqrt(2 * way / 10));
    EXPECT_EQ(points[1], true);
    EXPECT_GT(points[2].get<int>(), 1000);
    EXPECT_EQ(points[3], true);
    EXPECT_EQ(points[4], true);
    // Far in there, all is painted; far beside, nothing is.
    EXPECT_GT(evaluate("(zoomBy(2 ** 61), drawNow(), seenInk())"), 1000);
    EXPECT_GT(evaluate("level()"), 29);
    EXPECT_EQ(evaluate("(goHome(), move(1e6, 0), drawNow(), seenInk())"), 0);
    EXPECT_GT(evaluate("(goHome(), zoomBy(2 ** 700), newSheet(0), level())"), 300); // 16^-300 is 0 in doubles
    EXPECT_EQ(evaluate("windowPoints(seenWindow()).length"), 0);
    // The space bar paints in the middle.
    evaluate("byId('brush').value = 0.5, canvas.focus()");
    open("zoom=200");
    browser_->click("#empty");
    evaluate("byId('painting').checked = true, canvas.focus()");
    browser_->press("Space");
    EXPECT_GT(evaluate("windowPoints(seenWindow()).length"), 20);
    EXPECT_THAT(browser_->messages(), IsEmpty());
}

/// The density that is saved makes about the same points in the command, whose number is rounded to a whole one.
TEST_F(RecursivePageOfCommand, SavesADensityThatTheCommandTakes)
{
    open("zoom=220");
    browser_->click("#empty");
    const std::string url =
        evaluate("(byId('brush').value = 0.6, paint(-100, 40), byId('brush').value = 1, paint(80, 0), "
                 "layerPicture().toDataURL())");
    write_whole_file(folder_->path() / "density.png", test::from_base64(url.substr(url.find(',') + 1)));
    const json window =
        evaluate("({ x: Address.text(painted.layer.corner[0]), y: Address.text(painted.layer.corner[1]), "
                 "size: painted.layer.size })");
    const json on_page = evaluate(R"js((() => {
        const { corner, size, greys } = painted.layer;
        const per = perTile() / 16 ** (corner[0].digits.length - level());
        const mean = greys.reduce((sum, grey) => sum + lightOf[grey], 0) / greys.length;
        const number = Math.round(per * size[0] * size[1] * mean);
        const exact = number / (size[0] * size[1] * mean);
        return { number, places: plane.points({ corner, size }, exact, weightIn({ corner })).map(({ x, y }) => [x, y]).sort((a, b) => a[0] - b[0] || a[1] - b[1]) };
    })())js");
    const Outcome outcome =
        run({"--x", window["x"], "--y", window["y"], "--size", std::to_string(window["size"][0].get<int>()),
             std::to_string(window["size"][1].get<int>()), "--points", std::to_string(on_page["number"].get<int>()),
             "--density", "density.png", "--out", "painted.csv"});
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    const auto by_command = places_of(content_of(folder_->path() / "painted.csv"));
    EXPECT_GT(by_command.size(), 80u);
    EXPECT_EQ(json(by_command), on_page["places"]);
}

TEST_F(RecursivePageOfCommand, GoesByKeysTheWheelAndFingers)
{
    open("zoom=300");
    browser_->click("#view");
    for (const char* key : {"ArrowRight", "ArrowUp"}) browser_->press(key);
    EXPECT_NEAR(evaluate("state.at[0]").get<double>(), 0.5 + 40.0 / 300, 1e-9);
    EXPECT_NEAR(evaluate("state.at[1]").get<double>(), 0.5 + 40.0 / 300, 1e-9);
    browser_->press("+");
    EXPECT_NEAR(evaluate("state.zoom").get<double>(), 375, 1e-9);
    browser_->press("-");
    browser_->press("Home");
    EXPECT_EQ(evaluate("[state.at, level()]"), (json{{0.5, 0.5}, 0}));
    evaluate("canvas.dispatchEvent(new WheelEvent('wheel', { deltaY: -5000, clientX: 300, clientY: 300, cancelable: "
             "true }))");
    EXPECT_GT(evaluate("level()"), 6);
    const int before = evaluate("level()");
    browser_->pinch("#view", {0.45, 0.55}, {0.1, 0.9});
    EXPECT_GT(evaluate("level()"), before);
    // As far as addresses go, and back: no further than tiles of level 0 that are 96 pixels wide.
    EXPECT_EQ(evaluate("(() => { for (let i = 0; i < 2100; ++i) zoomBy(2); drawNow(); return level(); })()"), 1000);
    EXPECT_LE(evaluate("state.zoom").get<double>(), 512);
    EXPECT_EQ(
        evaluate("(() => { for (let i = 0; i < 2100; ++i) zoomBy(0.5); drawNow(); return [level(), state.zoom]; })()"),
        (json{0, 96}));
    EXPECT_THAT(browser_->messages(), IsEmpty());
}

TEST_F(RecursivePageOfCommand, GoesToPlacesAndKeepsThemInLinks)
{
    open();
    const auto go_to = [](const std::string& place) {
        return evaluate(fmt::format("(byId('place').value = '{}', byId('place').dispatchEvent(new Event('change')), "
                                    "drawNow(), state.tile.map(Address.text).join(' '))",
                                    place));
    };
    EXPECT_EQ(go_to(deep_x + " " + deep_y), deep_x + " " + deep_y);
    for (const char* wrong : {"1 2:3", "x y", "1", "1:4 1:4", "9007199254740993 1"}) {
        EXPECT_EQ(go_to(wrong), deep_x + " " + deep_y);
        EXPECT_THAT(evaluate("byId('said').textContent").get<std::string>(), HasSubstr("must be two tiles"));
    }
    const std::string state = evaluate("(move(0.2, 0.1), drawNow(), JSON.stringify(state))");
    const std::string link = evaluate("byId('link').href");
    open("x=3&y=4");
    EXPECT_NE(evaluate("JSON.stringify(state)"), state);
    open(link.substr(link.find('#') + 1));
    EXPECT_EQ(evaluate("JSON.stringify(state)"), state);
    open("x=1:2&y=nowhere");
    EXPECT_THAT(evaluate("byId('said').textContent").get<std::string>(), HasSubstr("names no place"));
}

/// The stamps of the command are on the page; the number of frames is said.
TEST_F(RecursivePageOfCommand, HasStampsAndCountsFrames)
{
    open();
    EXPECT_EQ(
        evaluate("readGiven !== undefined && new Promise((done) => setTimeout(() => done(byId('stamps').value), 300))"),
        "given");
    for (const char* stamps : {"dots", "leaves", "given"})
        EXPECT_GT(evaluate(fmt::format(
                      "(byId('stamps').value = '{}', showStamps(), drawNow(), (() => {{ const {{ gl }} = "
                      "transparentPicture(); "
                      "const p = new Uint8Array(4 * canvas.width * canvas.height); gl.readPixels(0, 0, "
                      "canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, p); return p.reduce((a, b) => a + "
                      "(b > 0), 0); }})())",
                      stamps)),
                  10'000)
            << stamps;
    browser_->resize(560, 900);
    browser_->click("#dive");
    const std::string frames =
        evaluate("new Promise((done) => setTimeout(() => done(byId('frames').textContent), 2500))");
    EXPECT_THAT(frames, HasSubstr(" frames a second"));
    RecordProperty("frames", frames);
    // Diving that is ended and begun again within a frame counts each frame once.
    EXPECT_EQ(evaluate("(byId('dive').click(), byId('dive').click(), new Promise((done) => setTimeout(() => "
                       "done(dive.length > 1 && dive.every((at, i) => i === 0 || at > dive[i - 1])), 2000)))"),
              true);
    RecordProperty("milliseconds", evaluate(R"js((() => {
        const pixel = new Uint8Array(4);
        byId("dive").click();
        document.querySelector(".view").style.cssText = "width: 514px; height: 514px";
        const draw = () => {
            zoomBy(1.01);
            drawNow();
            drawing.gl.readPixels(0, 0, 1, 1, drawing.gl.RGBA, drawing.gl.UNSIGNED_BYTE, pixel);
        };
        draw();
        const begin = performance.now();
        for (let i = 0; i < 100; ++i) draw();
        return `${(performance.now() - begin) / 100} with ${canvas.width} x ${canvas.height} pixels`;
    })())js")
                                       .get<std::string>());
    EXPECT_GT(evaluate("level() + state.zoom / 512"), 0.5);
    EXPECT_THAT(browser_->messages(), IsEmpty());
}

TEST_F(RecursivePageOfCommand, WritesFiles)
{
    ASSERT_EQ(run({"--x", deep_x, "--y", deep_y, "--size", "2", "3", "--points", "700", "--out", "a.csv", "--out",
                   "a.txt", "--out", "a.npy", "--out", "a.png", "--pixels", "100"})
                  .status,
              0);
    EXPECT_NEAR(static_cast<double>(places_of(content_of(folder_->path() / "a.csv")).size()), 700, 20);
    EXPECT_THAT(content_of(folder_->path() / "a.txt"), HasSubstr("distribute recursive"));
    EXPECT_EQ(read_png(folder_->path() / "a.png").height, 150);
    const Outcome numbers = run({"--points", "700", "--out", "b.csv", "--json"});
    EXPECT_EQ(json::parse(numbers.out)["asked_for"], 700);
    for (const auto& [wrong, said] : std::vector<std::pair<std::vector<std::string>, std::string>>{
             {{"--x", "1:2"}, "must have as many digits after the colon as"},
             {{"--x", "1:4", "--y", "1:3"}, "must be a tile from"},
             {{"--size", "0", "1"}, "--size"},
             {{"--size", "257", "1"}, "--size"},
             {{"--points-per-tile", "127"}, "--points-per-tile"},
             {{"--stamps", "none.png"}, "none.png"},
             {{"--density", "x+"}, "--density"},
             {{"--density", "0*x"}, "0"}}) {
        std::vector<std::string> words{"--points", "10", "--out", "wrong.csv"};
        words.insert(words.end(), wrong.begin(), wrong.end());
        const Outcome outcome = run(words);
        EXPECT_EQ(outcome.status, 2) << wrong[1];
        EXPECT_THAT(outcome.error, HasSubstr(said));
        EXPECT_EQ(std::ranges::count(outcome.error, '\n'), 1) << outcome.error;
        EXPECT_FALSE(std::filesystem::exists(folder_->path() / "wrong.csv"));
    }
}

}
}
