// The report's site in a real browser, from disk: quiet, complete, and everything that can be pressed does what it
// says. Needs Chromium.
#include "reports/site/report.hpp"

#include "base/files/whole_file.hpp"
#include "base/images/png_file.hpp"
#include "base/images/srgb_light.hpp"
#include "results/curve_tables.hpp"
#include "tests/reports/support/synthetic_results.hpp"
#include "tests/support/browser.hpp"
#include "tests/support/picture.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

namespace poissonlab {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// One report over two runs of other versions and machines, and one browser, for all tests.
class SiteInBrowser : public testing::Test
{
protected:
    static void SetUpTestSuite()
    {
        folder_ = std::make_unique<TemporaryFolder>();
        write_run("one", "0.1.0 (old)", "Old device");
        write_run("two", "0.2.0 (new)", "New device");
        write_report({folder_->path() / "one", folder_->path() / "two"}, site());
        browser_ = std::make_unique<test::Browser>();
    }
    static void TearDownTestSuite()
    {
        browser_.reset();
        folder_.reset();
    }
    void SetUp() override
    {
        browser_->resize(1280, 900);
        browser_->emulate("screen", false);
    }

    static void write_run(const std::string& name, const std::string& version, const std::string& device)
    {
        auto json = test::write_synthetic_results(folder_->path() / name);
        json["version"] = version;
        json["machine"]["device"] = device;
        // The second series has a pair correlation.
        std::string pairs = "distance,pair_correlation,standard_error,pairs\n";
        for (int i = 1; i <= 20; ++i)
            pairs += std::to_string(0.01 * i) + "," + std::to_string(i < 5 ? 0.0 : 1.0) + ",0.01,50\n";
        folder_->write(name + "/jittered/pair-correlation.csv", pairs);
        json["series"][1]["pair_correlation"] = {{"file", "jittered/pair-correlation.csv"}};
        // All three are places of a grid of two axes.
        json["methods"] = {{{"sampler", "corner-tiles"},
                            {"label", ""},
                            {"axes",
                             {{{"key", "colors"}, {"symbol", "C"}, {"values", {"2", "3"}}},
                              {{"key", "points_per_tile"}, {"symbol", "N"}, {"values", {"32", "64"}}}}}}};
        for (int i = 0; i < 3; ++i) {
            json["series"][i]["method"] = 0;
            json["series"][i]["place"] = {i / 2, i % 2};
        }
        test::write_results_json(folder_->path() / name, json);
    }

    static fs::path site() { return folder_->path() / "site-of-two"; }

    static std::vector<fs::path> pages()
    {
        std::vector<fs::path> found;
        for (const auto& entry : fs::recursive_directory_iterator(site()))
            if (entry.path().extension() == ".html") found.push_back(entry.path());
        std::ranges::sort(found);
        return found;
    }

    static nlohmann::json evaluate(const std::string& script) { return browser_->evaluate(script); }

    /// The values that JavaScript gives for each element that a selector finds.
    static nlohmann::json each(const std::string& selector, const std::string& what)
    {
        return evaluate("Array.from(document.querySelectorAll('" + selector + "'), e => " + what + ")");
    }

    static int curves() { return evaluate("document.querySelectorAll('#chart path.curve').length"); }
    static std::string text(const std::string& selector)
    {
        return evaluate("document.querySelector('" + selector + "').textContent");
    }
    static nlohmann::json titles() { return each("#chart text.title", "e.textContent"); }

    static inline std::unique_ptr<TemporaryFolder> folder_;
    static inline std::unique_ptr<test::Browser> browser_;
};

TEST_F(SiteInBrowser, EveryPageIsQuietAndAsksForNothing)
{
    EXPECT_GE(pages().size(), 2u + 2 + 6); // overview and compare page, two runs, six series
    for (const auto& page : pages()) {
        browser_->open(page);
        EXPECT_THAT(browser_->messages(), IsEmpty()) << page;
        EXPECT_THAT(browser_->requests(), IsEmpty()) << page;
        EXPECT_FALSE(evaluate("document.title").get<std::string>().empty()) << page;
    }
}

TEST_F(SiteInBrowser, EveryPictureIsThereAndShowsSomething)
{
    std::set<std::string> sources;
    for (const auto& page : pages()) {
        browser_->open(page);
        // Lazy pictures load once they are near the window.
        const auto images =
            evaluate("Promise.all(Array.from(document.images, i => { i.loading = 'eager';"
                     "return i.decode().then(() => [i.src, i.naturalWidth, i.alt], () => [i.src, 0, i.alt]); }))");
        for (const auto& image : images) {
            EXPECT_GT(image[1].get<int>(), 0) << page << ": " << image[0];
            EXPECT_NE(image[2], "") << page << ": " << image[0];
            sources.insert(image[0].get<std::string>());
        }
        EXPECT_THAT(browser_->messages(), IsEmpty()) << page;
    }
    EXPECT_GT(sources.size(), 20u);
    browser_->resize(600, 600);
    for (const auto& source : sources) {
        if (!source.starts_with("file://")) continue;
        browser_->open(source.substr(7));
        EXPECT_GT(test::decode_png(browser_->screenshot()).variance(), 0) << source;
    }
}

TEST_F(SiteInBrowser, FitsATelephone)
{
    browser_->resize(390, 844, true);
    for (const auto& page : pages()) {
        browser_->open(page);
        EXPECT_LE(evaluate("document.documentElement.scrollWidth"), 390) << page;
    }
}

TEST_F(SiteInBrowser, IsDarkWhereThatIsWantedAndWhiteOnPaper)
{
    // Relative luminance of a computed colour, 0 to 255.
    const auto luminance = [](const std::string& property) {
        return evaluate("(() => { const [r, g, b] = getComputedStyle(document.body)." + property +
                        ".match(/\\d+/g).map(Number); return 0.2126 * r + 0.7152 * g + 0.0722 * b; })()")
            .get<double>();
    };
    for (const auto& page : pages()) {
        browser_->emulate("screen", true);
        browser_->open(page);
        EXPECT_LT(luminance("backgroundColor"), 60) << page;
        EXPECT_GT(luminance("color"), 180) << page;
        browser_->emulate("screen", false);
        EXPECT_GT(luminance("backgroundColor"), 240) << page;
        EXPECT_LT(luminance("color"), 60) << page;
        // Colours of series are those of their curves; only the dark page, whose pictures are inverted, inverts them.
        EXPECT_EQ(evaluate("Array.from(document.querySelectorAll('.swatch, img.ink'))"
                           ".filter(e => getComputedStyle(e).filter !== 'none').length"),
                  0)
            << page;
        browser_->emulate("print", true);
        EXPECT_NEAR(luminance("backgroundColor"), 255, 0.01) << page; // sums of products are rounded
        EXPECT_EQ(evaluate("getComputedStyle(document.querySelector('nav')).display"), "none") << page;
    }
}

/// The values of a column in the order of its rows; null where a cell has none.
nlohmann::json column_values(test::Browser& browser, const std::string& key)
{
    return browser.evaluate("Array.from(document.querySelectorAll('#ranking tbody [data-key=\"" + key +
                            "\"]'), c => { const d = c.querySelector('data'); const t = c.textContent.trim();"
                            "return d ? Number(d.value) : t === '–' || t === '' ? null : t; })");
}

/// True if values rise (or fall), those that are missing last.
bool is_sorted_as_said(const nlohmann::json& values, bool descending)
{
    bool missing = false;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (missing && !values[i].is_null()) return false;
        missing = values[i].is_null();
        if (i == 0 || missing || !values[i].is_number()) continue;
        const double before = values[i - 1], value = values[i];
        if (descending ? value > before : value < before) return false;
    }
    return true;
}

TEST_F(SiteInBrowser, TheRankingSortsByEachColumn)
{
    browser_->open(site() / "index.html");
    browser_->click("#all-measures");
    const auto keys = each("#ranking thead th", "e.dataset.key");
    EXPECT_THAT(keys.get<std::vector<std::string>>(), Contains("relative_radius"));
    for (const std::string key : keys) {
        const auto header = "#ranking thead th[data-key=\"" + key + "\"]";
        const auto sort = [&] {
            return evaluate("document.querySelector('" + header + "').getAttribute('aria-sort')");
        };
        const auto rows_before = column_values(*browser_, key);
        browser_->click(header + " button");
        const bool best_is_highest = evaluate("document.querySelector('" + header + "').dataset.better") == "higher";
        EXPECT_EQ(sort(), best_is_highest ? "descending" : "ascending") << key;
        EXPECT_TRUE(is_sorted_as_said(column_values(*browser_, key), best_is_highest)) << key;
        // The button has the focus now.
        browser_->press("Enter");
        EXPECT_EQ(sort(), best_is_highest ? "ascending" : "descending") << key;
        const auto values = column_values(*browser_, key);
        EXPECT_TRUE(is_sorted_as_said(values, !best_is_highest)) << key << values;
        EXPECT_TRUE(std::is_permutation(values.begin(), values.end(), rows_before.begin(), rows_before.end())) << key;
        EXPECT_EQ(each("#ranking thead th:not([aria-sort=none])", "1").size(), 1u) << key;
    }
    EXPECT_THAT(browser_->messages(), IsEmpty());
}

TEST_F(SiteInBrowser, ALongRankingIsFiltered)
{
    const TemporaryFolder folder;
    auto json = test::write_synthetic_results(folder.path() / "long");
    const nlohmann::json model = json["series"][0];
    json["series"] = nlohmann::json::array();
    for (int i = 0; i < 30; ++i) {
        json["series"].push_back(model);
        json["series"][i]["name"] = "series-" + std::to_string(i);
        json["series"][i]["sampler"] = i < 10 ? "random" : "jittered";
    }
    test::write_results_json(folder.path() / "long", json);
    write_report({folder.path() / "long"}, folder.path() / "site-of-long");
    browser_->open(folder.path() / "site-of-long" / "index.html");
    const auto visible = [&] { return each("#ranking tbody tr:not([hidden])", "1").size(); };
    EXPECT_FALSE(evaluate("document.querySelector('details.whole').open"));
    browser_->click("details.whole > summary");
    EXPECT_EQ(visible(), 30u);
    const auto choose = [&](const std::string& value) {
        evaluate("(() => { const s = Array.from(document.querySelectorAll('#ranking-filters select')).find(e => "
                 "e.parentElement.textContent.startsWith('Method')); s.value = '" +
                 value + "'; s.dispatchEvent(new Event('change')); })()");
    };
    choose("random");
    EXPECT_EQ(visible(), 10u);
    EXPECT_THAT(text("#ranking-filters"), HasSubstr("10 of 30 series"));
    choose("jittered");
    EXPECT_EQ(visible(), 20u);
    choose("");
    EXPECT_EQ(visible(), 30u);
    EXPECT_THAT(browser_->messages(), IsEmpty());
}

TEST_F(SiteInBrowser, TheRankingSaysWhichMachineAndVersion)
{
    browser_->open(site() / "index.html");
    const auto overview = text("#overview");
    for (const char* word : {"0.1.0 (old)", "0.2.0 (new)", "Old device", "New device"})
        EXPECT_THAT(overview, HasSubstr(word));
    EXPECT_GE(each("#overview .notice", "1").size(), 1u);
    // The pages of the runs say theirs.
    browser_->open(site() / "one/index.html");
    EXPECT_THAT(text("#provenance"), testing::AllOf(HasSubstr("0.1.0 (old)"), Not(HasSubstr("0.2.0 (new)"))));
}

TEST_F(SiteInBrowser, AllColumnsOfTheRankingFitADesk)
{
    for (const int width : {1200, 1400, 1600}) {
        browser_->resize(width, 900);
        browser_->open(site() / "index.html");
        // The series and the six measures that people choose by, and what sets of several sizes or numbers add.
        EXPECT_GE(evaluate("document.querySelectorAll('#ranking thead th:not(.detail)').length").get<int>(), 7);
        EXPECT_EQ(evaluate("(f => f.scrollWidth - f.clientWidth)(document.querySelector('#overview .frame'))"), 0)
            << width;
    }
}

TEST_F(SiteInBrowser, EveryBoxShowsAndHidesItsCurve)
{
    browser_->open(site() / "compare.html");
    const int all = 6; // those of the gallery follow, and are not ticked
    const int with_gallery = evaluate("document.querySelectorAll('input[data-series]').length");
    EXPECT_GT(with_gallery, all);
    EXPECT_EQ(curves(), all);
    for (int i = 0; i < all; ++i) {
        const auto box = "input[data-series=\"" + std::to_string(i) + "\"]";
        browser_->click(box);
        EXPECT_EQ(curves(), all - 1) << i;
        EXPECT_EQ(each("#legend li", "1").size(), static_cast<std::size_t>(all - 1));
        browser_->press("Space"); // it has the focus
        EXPECT_EQ(curves(), all) << i;
    }
    browser_->click("#none");
    EXPECT_EQ(curves(), 0);
    browser_->click("#all");
    EXPECT_EQ(curves(), with_gallery);
    EXPECT_THAT(text("#legend"), HasSubstr(" – gallery"));
}

TEST_F(SiteInBrowser, TheFilterLeavesSeriesByTheirNames)
{
    browser_->open(site() / "compare.html");
    browser_->click("#filter");
    browser_->type("jittered");
    const auto left = each("fieldset label", "e.hidden ? null : e.textContent.trim()");
    EXPECT_EQ(std::ranges::count_if(left, [](const auto& label) { return !label.is_null(); }), 3)
        << "one of the gallery";
    for (const auto& label : left) {
        if (label.is_null()) continue;
        EXPECT_THAT(label.get<std::string>(), HasSubstr("Jittered"));
    }
    browser_->click("#none"); // of what the filter leaves
    EXPECT_EQ(curves(), 4);
}

TEST_F(SiteInBrowser, EverySwitchChangesTheChart)
{
    browser_->open(site() / "compare.html");
    const auto choose = [&](const std::string& id, const std::string& key) {
        browser_->evaluate("document.getElementById('" + id + "').focus()");
        browser_->press(key);
        return evaluate("document.getElementById('" + id + "').value");
    };
    EXPECT_THAT(titles().get<std::vector<std::string>>(), Contains(HasSubstr("radially averaged power")));
    EXPECT_EQ(choose("quantity", "ArrowDown"), "anisotropy");
    EXPECT_THAT(titles().get<std::vector<std::string>>(), Contains(HasSubstr("anisotropy")));
    EXPECT_EQ(curves(), 6);
    EXPECT_EQ(choose("quantity", "ArrowDown"), "pairs");
    EXPECT_THAT(titles().get<std::vector<std::string>>(), Contains(HasSubstr("pair correlation")));
    EXPECT_EQ(curves(), 2) << "the two jittered series have one";
    choose("quantity", "Home");

    const auto path = [] { return evaluate("document.querySelector('#chart path.curve').getAttribute('d')"); };
    const auto linear = path();
    EXPECT_EQ(choose("scale", "ArrowDown"), "log");
    EXPECT_NE(path(), linear);
    choose("scale", "Home");
    EXPECT_EQ(path(), linear);

    EXPECT_EQ(choose("axis", "ArrowDown"), "spacing");
    EXPECT_THAT(titles().get<std::vector<std::string>>(), Contains(HasSubstr("mean spacing")));
    EXPECT_EQ(choose("axis", "ArrowDown"), "principal");
    EXPECT_THAT(titles().get<std::vector<std::string>>(), Contains(HasSubstr("principal frequency")));
    EXPECT_THAT(browser_->messages(), IsEmpty());
}

TEST_F(SiteInBrowser, TheTableOfPicturesShowsWhatIsPressed)
{
    browser_->open(site() / "one/index.html");
    const auto kinds = each(".switch button", "e.dataset.kind").get<std::vector<std::string>>();
    ASSERT_GE(kinds.size(), 2u);
    for (const auto& kind : kinds) {
        const auto button = ".switch button[data-kind=\"" + kind + "\"]";
        browser_->click(button);
        EXPECT_EQ(evaluate("document.querySelector('" + button + "').getAttribute('aria-pressed')"), "true");
        EXPECT_EQ(each(".switch button[aria-pressed=true]", "1").size(), 1u);
        const auto shown = each(".matrix img:not([hidden])", "e.dataset.kind");
        EXPECT_EQ(shown.size(), 3u) << kind;
        for (const auto& image : shown) EXPECT_EQ(image, kind);
    }
    // Keys change the kind as well: the first one follows the last.
    browser_->evaluate("document.querySelector('.switch button').focus()");
    browser_->press("Enter");
    EXPECT_EQ(each(".matrix img:not([hidden])", "e.dataset.kind")[0], kinds[0]);
}

/// The frequency of the read-out, and the value of the series that is highlighted.
struct Reading
{
    double frequency = 0, value = 0;
};

Reading reading(test::Browser& browser)
{
    const auto number = [](const std::string& text, std::size_t from) {
        std::string plain = text.substr(from);
        if (const auto minus = plain.find("−"); minus != std::string::npos)
            plain.replace(minus, std::string("−").size(), "-");
        return std::stod(plain);
    };
    const std::string all = browser.evaluate("document.getElementById('readout').firstChild.textContent");
    const std::string near = browser.evaluate("document.querySelector('#readout .near').textContent");
    return {number(all, all.find(' ') + 1), number(near, near.rfind(": ") + 2)};
}

TEST_F(SiteInBrowser, HoveringReadsWhatTheTablesHold)
{
    browser_->open(site() / "compare.html");
    browser_->click("#none");
    browser_->click("input[data-series=\"1\"]");
    const auto table = read_radial_table(folder_->path() / "one/jittered/radial.csv");
    for (const double across : {0.2, 0.5, 0.8}) {
        browser_->point_at("#chart svg", across, 0.5);
        const auto shown = reading(*browser_);
        const auto row = std::ranges::find(table, shown.frequency, &RadialBin::frequency);
        ASSERT_NE(row, table.end()) << shown.frequency;
        EXPECT_NEAR(shown.value, row->power, 5e-5 * std::abs(row->power)); // five digits
    }
    // Keys move the read-out: to the first frequency, to the next, and to the last.
    browser_->evaluate("document.getElementById('chart').focus()");
    browser_->press("Home");
    EXPECT_EQ(reading(*browser_).frequency, table[0].frequency);
    browser_->press("ArrowRight");
    EXPECT_EQ(reading(*browser_).frequency, table[1].frequency);
    EXPECT_NEAR(reading(*browser_).value, table[1].power, 5e-5 * table[1].power);
    browser_->press("End");
    EXPECT_EQ(reading(*browser_).frequency, table.back().frequency);
}

TEST_F(SiteInBrowser, HasThePapersClaims)
{
    browser_->open(site() / "index.html");
    EXPECT_THAT(each("header nav a", "e.getAttribute(\"href\")").get<std::vector<std::string>>(),
                Contains("claims.html"));
    browser_->open(site() / "claims.html");
    EXPECT_THAT(each("#claims tbody tr", "e.id").get<std::vector<std::string>>(),
                Contains("claim-6.2.2-poisson-anisotropy"));
    EXPECT_THAT(each("#claims tbody .verdict", "e.textContent.trim()").get<std::vector<std::string>>(),
                testing::Each(testing::ContainsRegex("agrees|partly|disagrees|open|shown")));
}

/// Half-black pixels are the hardest dots: scaled by bytes they would show a light of 0.37 on a phone.
TEST(DotsInBrowser, AreAsDarkAsAskedAtAnyWidth)
{
    constexpr int side = 1000;
    const TemporaryFolder folder;
    auto json = test::write_synthetic_results(folder.path());
    PngPixels dots{side, side, 1, {}};
    std::mt19937 random(4);
    for (int i = 0; i < side * side; ++i) dots.values.push_back(random() % 1000 < 391 ? 0 : 255);
    fs::create_directories(folder.path() / "dots");
    write_png(folder.path() / "dots/coverage.png", dots);
    json["distributions"] = {{{"name", "dots"},
                              {"label", "Dots"},
                              {"kind", "stippling"},
                              {"facts", nlohmann::json::array()},
                              {"numbers", nlohmann::json::array()},
                              {"pictures", {{{"file", "dots/coverage.png"}, {"caption", "Dots."}}}},
                              {"files", nlohmann::json::array()}}};
    test::write_results_json(folder.path(), json);
    write_report({folder.path()}, folder.path());
    test::Browser browser;
    browser.open(folder.path() / "index.html");
    const std::string image = "document.querySelector('img[src*=coverage-light]')";
    for (const int width : {1400, 800, 390}) {
        browser.resize(width, 900);
        browser.evaluate(image + ".scrollIntoView()");
        browser.evaluate(image + ".decode()");
        const auto sides = browser
                               .evaluate("(r => [r.left, r.top, r.right, r.bottom].map(Math.round))(" + image +
                                         ".getBoundingClientRect())")
                               .get<std::array<int, 4>>();
        const test::Picture shown = test::decode_png(browser.screenshot());
        ASSERT_EQ(shown.width, width);
        double light = 0, pixels = 0;
        for (int y = std::max(sides[1], 0) + 2; y < std::min(sides[3], shown.height) - 2; ++y)
            for (int x = sides[0] + 2; x < sides[2] - 2; ++x, ++pixels)
                light += light_of_bytes()[shown.grey[static_cast<std::size_t>(y * width + x)]] / 65'535.0;
        // By chance the mean of so many pixels differs by 0.001 at most (two standard deviations), and the filter's
        // curve from sRGB's by 0.001 where it is dark. Browsers cut bytes off where they scale and where they filter:
        // on average half of 1 / 255 of light, 0.002, and half a byte of sRGB, which is 0.0035 of light here.
        EXPECT_GT(pixels, 200 * 200);
        EXPECT_NEAR(light / pixels, 1 - 0.391, 0.0075) << width;
    }
}

}
}
