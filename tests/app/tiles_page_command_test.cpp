// `poissonlab tiles page` in a real browser, from disk: its points are those of `poissonlab tiles points`, point for
// point, also where a picture says how dense they are. Needs Chromium.
#include "base/files/whole_file.hpp"
#include "tests/support/browser.hpp"
#include "tests/support/places.hpp"
#include "tests/support/program.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <array>
#include <sstream>

namespace poissonlab {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr auto set_name = "corner-c3-n64-r075.ptiles";

class TilesPage : public testing::Test
{
protected:
    static void SetUpTestSuite()
    {
        folder_ = std::make_unique<TemporaryFolder>();
        std::filesystem::copy(source_folder() + "/runtime/tile_sets/" + set_name, folder_->path() / set_name);
        const Outcome outcome = run_program(folder_->path(), {"tiles", "page", set_name, "--out", "page.html"});
        ASSERT_EQ(outcome.status, 0) << outcome.error;
        browser_ = std::make_unique<test::Browser>();
    }
    static void TearDownTestSuite()
    {
        browser_.reset();
        folder_.reset();
    }

    static void open(const std::string& fragment)
    {
        browser_->resize(900, 900);
        browser_->open(folder_->path() / "page.html", fragment);
    }

    /// The points of the command that the page shows, from the lowest corner of its window.
    static json by_command()
    {
        std::istringstream words(browser_->evaluate("(drawNow(), byId('command').textContent)").get<std::string>());
        std::vector<std::string> arguments;
        for (std::string word; words >> word;) arguments.push_back(word);
        EXPECT_EQ(arguments.front(), "poissonlab");
        arguments.erase(arguments.begin());
        const Outcome outcome = run_program(folder_->path(), arguments);
        EXPECT_EQ(outcome.status, 0) << outcome.error;
        json points = json::array();
        std::istringstream lines(content_of(folder_->path() / "points.txt"));
        for (std::string line; std::getline(lines, line);) {
            if (line.empty() || line.front() == '#') continue;
            std::istringstream numbers(line);
            std::array<double, 2> point{};
            numbers >> point[0] >> point[1];
            points.push_back(point);
        }
        return points;
    }

    /// The text that the page would write into a file, from the same corner.
    static json on_page()
    {
        return browser_->evaluate("(() => { const w = seenWindow();"
                                  "return windowPoints(w).map(({position: p}) => [p[0] - w[0], p[1] - w[1]]); })()");
    }

    inline static std::unique_ptr<TemporaryFolder> folder_;
    inline static std::unique_ptr<test::Browser> browser_;
};

TEST_F(TilesPage, HasThePointsOfTheCommandThatItShows)
{
    for (const char* view :
         {"", "seed=77&tile=-3,12&zoom=60", "seed=4294967295&tile=1000000000,-1999999999", "density=0.4&zoom=90"}) {
        open(view);
        const json points = on_page();
        EXPECT_GT(points.size(), 500u) << view;
        EXPECT_EQ(points, by_command()) << view;
        EXPECT_THAT(browser_->messages(), IsEmpty()) << view;
    }
}

/// A picture is chosen as users do, painted over, and saved; the command takes what was saved.
TEST_F(TilesPage, FollowsAPictureAsTheCommandDoes)
{
    for (const std::string follows : {"light", "ink"}) {
        open("tile=40,-7&zoom=70");
        browser_->evaluate("byId('picture-of').value = '" + follows + "'");
        const json seen = browser_->evaluate(R"js(new Promise((done) => {
            const drawn = document.createElement("canvas");
            [drawn.width, drawn.height] = [60, 40];
            const context = drawn.getContext("2d");
            const slope = context.createLinearGradient(0, 0, 60, 40);
            slope.addColorStop(0, "#fff");
            slope.addColorStop(0.5, "#36c");
            slope.addColorStop(1, "#000");
            context.fillStyle = slope;
            context.fillRect(0, 0, 60, 40);
            drawn.toBlob((blob) => {
                const chosen = new DataTransfer();
                chosen.items.add(new File([blob], "slope.png", { type: "image/png" }));
                byId("picture").files = chosen.files;
                takePicture().then(() => {
                    painted.paint([40, -7], [0.5, 0.5], 0.6, 0.1);
                    done(painted.pictureOf(seenWindow()).toDataURL());
                });
            });
        }))js");
        const std::string url = seen.get<std::string>();
        write_whole_file(folder_->path() / "density.png", test::from_base64(url.substr(url.find(',') + 1)));
        const json points = on_page();
        const auto whole = browser_->evaluate("seenWindow()");
        const std::size_t all = 64u * whole[2].get<std::size_t>() * whole[3].get<std::size_t>();
        EXPECT_GT(points.size(), all / 20) << follows;
        EXPECT_LT(points.size(), all * 9 / 10) << follows;
        EXPECT_EQ(points, by_command()) << follows;
        EXPECT_THAT(browser_->evaluate("byId('command').textContent").get<std::string>(),
                    HasSubstr("--density density.png"));
        EXPECT_THAT(browser_->messages(), IsEmpty());
    }
}

/// A run keeps the tile set of its tilings; the page of a series leads to the endless tiling, whose points are those of
/// the program with that set.
TEST_F(TilesPage, IsInReportsOfTilings)
{
    folder_->write("c.toml", "engine = \"reference\"\n[[method]]\nsampler = \"corner-tiles\"\n"
                             "colors = 2\npoints_per_tile = 16\nrelative_radius = 0.6\npoints = 256\n");
    const Outcome outcome = run_program(folder_->path(), {"run", "c.toml", "--out", "out", "--quiet"});
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    std::filesystem::path series;
    for (const auto& entry : std::filesystem::directory_iterator(folder_->path() / "out"))
        if (std::filesystem::exists(entry.path() / "tile-set.ptiles")) series = entry.path();
    ASSERT_FALSE(series.empty());
    EXPECT_EQ(run_program(folder_->path(), {"tiles", "verify", series / "tile-set.ptiles"}).status, 0);
    browser_->resize(900, 900);
    browser_->open(series / "index.html");
    browser_->open(series /
                   browser_->evaluate("document.querySelector('a[href$=\"endless.html\"]').getAttribute('href')")
                       .get<std::string>());
    std::filesystem::copy(series / "tile-set.ptiles", folder_->path() / "tile-set.ptiles");
    const json points = on_page();
    EXPECT_GT(points.size(), 100u);
    EXPECT_EQ(points, by_command());
    EXPECT_THAT(browser_->messages(), IsEmpty());
    EXPECT_THAT(browser_->requests(), IsEmpty());
}

TEST_F(TilesPage, SaysWhatIsNoPicture)
{
    open("");
    EXPECT_THAT(browser_
                    ->evaluate(R"js((() => {
        const chosen = new DataTransfer();
        chosen.items.add(new File(["words"], "words.txt"));
        byId("picture").files = chosen.files;
        return takePicture().then(() => byId("status").textContent);
    })())js")
                    .get<std::string>(),
                HasSubstr("words.txt: is no picture"));
}

}
}
