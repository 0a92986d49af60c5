// The page of `texture design` in a real browser, from disk: marks that are drawn on it belong to all tiles that share
// what they cross, and what it saves is a texture set whose tiles are proved to fit. Needs Chromium.
#include "base/images/png_file.hpp"
#include "tests/support/browser.hpp"
#include "tests/support/command_test.hpp"
#include "tests/support/places.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <memory>
#include <set>
#include <utility>
#include <vector>

namespace poissonlab {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

constexpr auto window = "0 0 12 9";

/// Areas of the connected dark parts of a picture that do not touch its border, in pixels.
std::multiset<int> dark_areas(const PngPixels& picture)
{
    const auto is_dark = [&](int x, int y) { return picture.values[picture.at(x, y, 0)] < 128; };
    std::vector<bool> is_seen(static_cast<std::size_t>(picture.width * picture.height));
    std::multiset<int> areas;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            std::vector<std::pair<int, int>> open{{x, y}};
            int area = 0;
            bool is_inside = true;
            while (!open.empty()) {
                const auto [column, row] = open.back();
                open.pop_back();
                if (column < 0 || row < 0 || column >= picture.width || row >= picture.height) continue;
                const auto at = static_cast<std::size_t>(row * picture.width + column);
                if (is_seen[at] || !is_dark(column, row)) continue;
                is_seen[at] = true;
                ++area;
                is_inside =
                    is_inside && column > 0 && row > 0 && column < picture.width - 1 && row < picture.height - 1;
                for (const auto& [dx, dy] : {std::pair(1, 0), std::pair(-1, 0), std::pair(0, 1), std::pair(0, -1)})
                    open.emplace_back(column + dx, row + dy);
            }
            if (area > 0 && is_inside) areas.insert(area);
        }
    return areas;
}

class TextureDesignPage : public test::CommandTest
{
protected:
    static void SetUpTestSuite() { browser_ = std::make_unique<test::Browser>(); }
    static void TearDownTestSuite() { browser_.reset(); }

    TextureDesignPage() : CommandTest("texture") {}

    void open(const std::string& options)
    {
        printed("design " + options + " --out page.html");
        // The page asks before a drawing is left.
        browser_->evaluate("typeof drawing === 'undefined' ? 0 : (drawing.clear(), 0)");
        browser_->open(folder_.path() / "page.html");
        EXPECT_THAT(browser_->messages(), IsEmpty());
        EXPECT_THAT(browser_->requests(), IsEmpty());
    }

    /// A mark on a tile of the page, in its pixels.
    void add(int tile, double x, double y, double radius, const std::string& shape = "disk")
    {
        browser_->evaluate(fmt::format("drawing.beginStroke(), show(drawing.add({{tile: {}, x: {}, y: {}, radius: {}, "
                                       "shape: '{}', color: [0, 0, 0], turn: 0.4}})), 0",
                                       tile, x, y, radius, shape));
    }

    /// Saves the set, and unpacks it into the folder "drawn".
    void save()
    {
        const std::string text =
            browser_
                ->evaluate("textureSet().then((bytes) => { let text = ''; for (const byte of bytes) "
                           "text += String.fromCharCode(byte); return btoa(text); })")
                .get<std::string>();
        folder_.write("drawn.zip", test::from_base64(text));
        const Outcome unpacked =
            run_in_shell(folder_.path(), "rm -rf drawn; /usr/bin/python3 -m zipfile -e drawn.zip .");
        ASSERT_EQ(unpacked.status, 0) << unpacked.error;
    }

    PngPixels tiling() const
    {
        printed(std::string("tile drawn --window ") + window + " --seed 7 --out plain.png");
        return read_png(folder_.path() / "plain.png");
    }

    inline static std::unique_ptr<test::Browser> browser_;
};

/// Marks of all shapes and sizes anywhere on all tiles.
TEST_F(TextureDesignPage, SavesSetsThatFit)
{
    for (const char* options :
         {"corner --size 32", "corner --colors 3 --size 32", "wang --size 64", "wang --colors 3 --size 32"}) {
        SCOPED_TRACE(options);
        open(options);
        browser_->evaluate("let state = 5; const next = () => (state = mix(state + 1)) / 4294967296;"
                           "for (let i = 0; i < 400; ++i) drawing.add({tile: Math.floor(next() * tileSet.tiles.length),"
                           "x: next() * tileSet.size, y: next() * tileSet.size,"
                           "radius: 0.5 + next() * (drawing.mostRadius - 0.5),"
                           "shape: Object.keys(shapes)[Math.floor(4 * next())], turn: 6 * next(),"
                           "color: [255 * next(), 255 * next(), 255 * next()]}); 0");
        save();
        const auto json = nlohmann::json::parse(printed("verify drawn --json"));
        EXPECT_EQ(json["tiles"], browser_->evaluate("tileSet.tiles.length"));
        EXPECT_GT(json["joints"].get<int>(), 0);
    }
}

/// Each disk is whole wherever a border or a corner goes through it: all have as many pixels as a disk inside of a
/// tile.
TEST_F(TextureDesignPage, DrawsWholeMarksAcrossBorders)
{
    for (const std::string kind : {"corner", "wang"}) {
        open(kind + " --size 64");
        for (const auto& [x, y] : {std::pair(32.25, 31.5), std::pair(0.5, 30.25), std::pair(31.0, 63.5),
                                   std::pair(61.75, 20.5), std::pair(3.5, 61.25), std::pair(63.25, 63.75)}) {
            SCOPED_TRACE(fmt::format("{}: {}, {}", kind, x, y));
            browser_->evaluate("drawing.clear()");
            add(5, x, y, 9);
            save();
            const std::multiset<int> areas = dark_areas(tiling());
            ASSERT_FALSE(areas.empty());
            EXPECT_EQ(*areas.begin(), *areas.rbegin());
            EXPECT_NEAR(*areas.begin(), 3.14159 * 81, 8) << "pixels whose middles are inside";
        }
    }
}

TEST_F(TextureDesignPage, ShowsTheTilingThatCommandsLay)
{
    for (const std::string kind : {"corner", "wang"}) {
        open(kind + " --colors 3 --size 32");
        for (int tile = 0; tile < 81; ++tile) add(tile, 10 + tile % 9, 8 + tile / 9, 2 + tile % 5, "leaf");
        save();
        browser_->evaluate("byId('seed').value = 7; showNow(); 0");
        const PngPixels laid = tiling();
        const auto shown = browser_->evaluate(
            "(() => { const rows = plane.rows; return Array.from(plane.canvas.getContext('2d').getImageData(0, "
            "(rows - 9) * 32, 12 * 32, 9 * 32).data).filter((b, i) => i % 4 < 3); })()");
        EXPECT_EQ(shown.get<std::vector<int>>(), (std::vector<int>(laid.values.begin(), laid.values.end())));
    }
}

TEST_F(TextureDesignPage, IsDrawnOnWithMouseAndFingers)
{
    open("corner");
    const auto strokes = [&] { return browser_->evaluate("drawing.strokes.length").get<int>(); };
    const auto marks = [&] { return browser_->evaluate("drawing.marks.length").get<int>(); };
    browser_->drag("#tiles", 0.1, 0.3, 0.1, 0.25);
    EXPECT_EQ(strokes(), 1);
    EXPECT_GT(marks(), 5);
    const int before = marks();
    browser_->pinch("#plane", {0.3, 0.7}, {0.4, 0.8});
    EXPECT_EQ(strokes(), 2) << "the second finger draws nothing";
    EXPECT_GT(marks(), before);
    browser_->click("#undo");
    EXPECT_EQ(marks(), before);
    browser_->click("#undo");
    EXPECT_EQ(marks(), 0);
    browser_->evaluate("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(() => done(0))))");
    EXPECT_TRUE(browser_->evaluate("byId('undo').disabled").get<bool>());
    EXPECT_THAT(browser_->messages(), IsEmpty());
}

TEST_F(TextureDesignPage, GoesOnFromSavedDrawings)
{
    open("wang --size 32");
    add(3, 1, 12, 5);
    add(9, 16, 16, 4, "square");
    const std::string pixels = "Array.from(drawing.pictures().atlas)";
    const auto drawn = browser_->evaluate(pixels);
    const std::string text = browser_->evaluate("drawingText()").get<std::string>();
    open("wang --size 32");
    const auto opened = [&](const std::string& saved) {
        return browser_
            ->evaluate("(() => { try { openDrawing(" + nlohmann::json(saved).dump() +
                       "); return ''; } catch (problem) { return problem.message; } })()")
            .get<std::string>();
    };
    EXPECT_EQ(opened(text), "");
    EXPECT_EQ(browser_->evaluate(pixels), drawn);
    for (const char* other : {"", "{}", "[", "null"}) EXPECT_EQ(opened(other), "the file is no drawing of this page");
    auto json = nlohmann::json::parse(text);
    json["marks"][0]["radius"] = 1e9;
    EXPECT_EQ(opened(json.dump()), "the drawing is damaged");
    json["colors"] = 3;
    EXPECT_EQ(opened(json.dump()), "the drawing has colors 3, and this page has 2");
    EXPECT_EQ(browser_->evaluate(pixels), drawn) << "what cannot be opened changes nothing";
}

/// The drawings in the spirit of figure 3 of Cohen and others: the page takes them, and their tiles fit.
TEST_F(TextureDesignPage, TakesTheDrawingsOfTheConfigs)
{
    for (const std::string name : {"lines", "leaves"}) {
        const Outcome drawn = run_in_shell(folder_.path(), "/usr/bin/python3 " + source_folder() +
                                                               "/configs/papers/cohen-2003/draw_tiles.py " + name);
        ASSERT_EQ(drawn.status, 0) << drawn.error;
        open("wang --colors 2 --size 64");
        browser_->evaluate("openDrawing(" + nlohmann::json(drawn.out).dump() + "), 0");
        EXPECT_GT(browser_->evaluate("drawing.strokes.length").get<int>(), 60) << name;
        save();
        EXPECT_EQ(nlohmann::json::parse(printed("verify drawn --json"))["tiles"], 16) << name;
    }
}

TEST_F(TextureDesignPage, Mistakes)
{
    expect_error("design hexagon --out a.html", "texture design: KIND hexagon: must be one of \"corner\", \"wang\"");
    expect_error("design corner --size 33 --out a.html",
                 "texture design: --size 33: must be an even number from 32 to 128");
    for (const char* colors : {"1", "5"})
        expect_error(std::string("design corner --out a.html --colors ") + colors,
                     std::string("texture design: --colors ") + colors + ": must be an integer from 2 to 4");
    EXPECT_THAT(run("design corner --out a.png").error, HasSubstr("--out a.png: must end in .html"));
    folder_.write("mine.html", "<p>mine</p>\n");
    EXPECT_EQ(run("design corner --out mine.html").status, 2);
    EXPECT_EQ(content_of(folder_.path() / "mine.html"), "<p>mine</p>\n");
}

}
}
