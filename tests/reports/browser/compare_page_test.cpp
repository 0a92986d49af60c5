// The compare page in a real browser, from disk: zoom, bands, several charts, links and tables of what is shown. Needs
// Chromium.
#include "reports/site/report.hpp"

#include "base/files/whole_file.hpp"
#include "results/curve_tables.hpp"
#include "tests/reports/support/synthetic_results.hpp"
#include "tests/support/browser.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace poissonlab {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

/// A report over a run of three series, two of which have standard errors and a pair correlation.
class ComparePage : public testing::Test
{
protected:
    static void SetUpTestSuite()
    {
        folder_ = std::make_unique<TemporaryFolder>();
        auto json = test::write_synthetic_results(folder_->path() / "run");
        std::string pairs = "distance,pair_correlation,standard_error,pairs\n";
        for (int i = 1; i <= 20; ++i) pairs += fmt::format("{},{},0.25,50\n", 0.01 * i, i < 5 ? 0.0 : 1.0);
        for (const int i : {0, 1}) {
            const std::string name = json["series"][i]["name"];
            folder_->write("run/" + name + "/pair-correlation.csv", pairs);
            json["series"][i]["pair_correlation"] = {{"file", name + "/pair-correlation.csv"}};
        }
        test::write_results_json(folder_->path() / "run", json);
        write_report({folder_->path() / "run"}, folder_->path() / "site");
        browser_ = std::make_unique<test::Browser>();
    }
    static void TearDownTestSuite()
    {
        browser_.reset();
        folder_.reset();
    }

    static void open(const std::string& fragment = {})
    {
        browser_->resize(1280, 900);
        browser_->open(folder_->path() / "site/compare.html", fragment);
        EXPECT_THAT(browser_->messages(), IsEmpty());
    }
    static nlohmann::json evaluate(const std::string& script) { return browser_->evaluate(script); }

    /// The range of the first chart's horizontal axis.
    static std::array<double, 2> range() { return evaluate("[charts[0].x.low, charts[0].x.high]"); }
    static void choose(const std::string& id, const std::string& value)
    {
        evaluate("(() => { const e = document.getElementById('" + id + "'); e.value = '" + value +
                 "'; e.dispatchEvent(new Event('change')); })()");
    }
    static std::string hash() { return evaluate("location.hash").get<std::string>().substr(1); }

    /// Numbers of the places of a path.
    static std::vector<std::array<double, 2>> places(const std::string& selector, int number = 0)
    {
        const std::string path = evaluate(fmt::format(
            "document.querySelectorAll('{}')[{}].getAttribute('d').replace(/[MLZ]/g, ' ')", selector, number));
        std::vector<std::array<double, 2>> all;
        std::istringstream numbers(path);
        for (std::array<double, 2> place{}; numbers >> place[0] >> place[1];) all.push_back(place);
        return all;
    }

    static inline std::unique_ptr<TemporaryFolder> folder_;
    static inline std::unique_ptr<test::Browser> browser_;
};

TEST_F(ComparePage, ZoomsAndMovesByMouseKeysAndButtons)
{
    open();
    const auto whole = range();
    browser_->drag("#chart svg", 0.3, 0.6, 0.5, 0.5);
    const auto dragged = range();
    const double width = evaluate("charts[0].size.width");
    const auto value_at = [&](double share) {
        return whole[0] + (share * width - 64) / (width - 80) * (whole[1] - whole[0]);
    };
    EXPECT_NEAR(dragged[0], value_at(0.3), 0.01 * whole[1]);
    EXPECT_NEAR(dragged[1], value_at(0.6), 0.01 * whole[1]);

    evaluate("document.getElementById('chart').focus()");
    browser_->press(">");
    const double by = 0.25 * (dragged[1] - dragged[0]);
    EXPECT_NEAR(range()[0], dragged[0] + by, 1e-3 * whole[1]);
    EXPECT_NEAR(range()[1], dragged[1] + by, 1e-3 * whole[1]);
    browser_->press("+");
    EXPECT_NEAR((dragged[1] - dragged[0]) / (range()[1] - range()[0]), 1.5, 1e-3);
    browser_->press("0");
    EXPECT_EQ(range(), whole);
    browser_->press("-");
    EXPECT_EQ(range(), whole);
    browser_->click("#nearer");
    EXPECT_NEAR((whole[1] - whole[0]) / (range()[1] - range()[0]), 1.5, 1e-3);
    for (int i = 0; i < 9; ++i) browser_->click("#left");
    EXPECT_EQ(range()[0], whole[0]) << "nothing lies left of all";
    browser_->click("#whole");
    EXPECT_EQ(range(), whole);

    // A high frame zooms into heights as well.
    browser_->drag("#chart svg", 0.3, 0.6, 0.2, 0.6);
    EXPECT_TRUE(evaluate("charts[0].settings.y !== null").get<bool>());
    EXPECT_EQ(evaluate("document.querySelectorAll('#chart path.curve').length"), 3);
    EXPECT_THAT(browser_->messages(), IsEmpty());
}

/// The values under two fingers stay under them.
TEST_F(ComparePage, ZoomsBetweenTwoFingers)
{
    open();
    const auto whole = range();
    const double width = evaluate("charts[0].size.width");
    const auto part_of = [&](double share) { return (share * width - 64) / (width - 80); };
    const std::array<double, 2> across{0.4, 0.6}, spread{0.3, 0.8};
    browser_->pinch("#chart svg", across, spread);
    const auto pinched = range();
    for (const std::size_t finger : {0, 1})
        EXPECT_NEAR(std::lerp(pinched[0], pinched[1], part_of(spread[finger])),
                    std::lerp(whole[0], whole[1], part_of(across[finger])), 2e-3 * whole[1]);
    browser_->pinch("#chart svg", {0.2, 0.8}, {0.48, 0.52});
    EXPECT_EQ(range(), whole) << "nothing lies beyond all";

    // The second of two charts, over another axis.
    choose("quantity", "all");
    const nlohmann::json frequencies = evaluate("[charts[0].x.low, charts[0].x.high]");
    browser_->pinch("#chart svg[data-plot=pairs]", {0.4, 0.6}, {0.3, 0.7});
    EXPECT_NEAR(
        evaluate("(charts[2].whole[1] - charts[2].whole[0]) / (charts[2].x.high - charts[2].x.low)").get<double>(), 2,
        0.02);
    EXPECT_EQ(evaluate("[charts[0].x.low, charts[0].x.high]"), frequencies);
    EXPECT_THAT(browser_->messages(), IsEmpty());
}

/// A band reaches one standard error, as the table has it, above and below its curve.
TEST_F(ComparePage, BandsAreOneStandardError)
{
    open();
    choose("quantity", "pairs");
    EXPECT_EQ(evaluate("document.querySelectorAll('#chart path.band').length"), 0);
    browser_->click("#bands");
    ASSERT_EQ(evaluate("document.querySelectorAll('#chart path.band').length"), 2);
    const auto band = places("#chart path.band");
    const auto line = places("#chart path.curve");
    ASSERT_EQ(band.size(), 2 * line.size());
    const double pixels = evaluate("charts[0].y.at(0) - charts[0].y.at(0.25)");
    EXPECT_GT(pixels, 5);
    for (std::size_t i = 0; i < line.size(); ++i) {
        EXPECT_NEAR(line[i][1] - band[i][1], pixels, 0.11);
        EXPECT_NEAR(band[band.size() - 1 - i][1] - line[i][1], pixels, 0.11);
    }
}

TEST_F(ComparePage, HasLogarithmicFrequencies)
{
    open();
    choose("across", "log");
    const auto table = read_radial_table(folder_->path() / "run/random/radial.csv");
    const auto line = places("#chart path.curve");
    ASSERT_EQ(line.size(), table.size());
    // Equal factors are equal distances.
    const double span = std::log(table.back().frequency / table.front().frequency);
    for (std::size_t i = 0; i < line.size(); ++i)
        EXPECT_NEAR(
            line[i][0],
            std::lerp(line.front()[0], line.back()[0], std::log(table[i].frequency / table.front().frequency) / span),
            0.11);
    EXPECT_THAT(evaluate("charts[0].x.ticks").get<std::vector<double>>(), testing::IsSupersetOf({1.0, 2.0, 5.0, 10.0}));
}

/// All plots stand one below the other; those over the same axis zoom and read together.
TEST_F(ComparePage, PlotsAreSynchronised)
{
    open();
    choose("quantity", "all");
    EXPECT_EQ(evaluate("charts.map((chart) => chart.quantity)"), (nlohmann::json{"power", "anisotropy", "pairs"}));
    const nlohmann::json distances = evaluate("[charts[2].x.low, charts[2].x.high]");
    browser_->drag("#chart svg[data-plot=power]", 0.3, 0.6, 0.5, 0.5);
    EXPECT_EQ(evaluate("[charts[1].x.low, charts[1].x.high]"), evaluate("[charts[0].x.low, charts[0].x.high]"));
    EXPECT_EQ(evaluate("[charts[2].x.low, charts[2].x.high]"), distances);
    browser_->point_at("#chart svg[data-plot=anisotropy]", 0.5, 0.5);
    const nlohmann::json cursors = evaluate("charts.map((chart) => chart.cursor.getAttribute('x1'))");
    EXPECT_EQ(cursors[0], cursors[1]);
    EXPECT_NE(cursors[0], "-9");
    EXPECT_EQ(cursors[2], "-9");
    EXPECT_EQ(evaluate("document.querySelectorAll('#readout span').length"), 6);
    EXPECT_EQ(evaluate("document.querySelectorAll('#readout .near').length"), 1);
    EXPECT_THAT(browser_->messages(), IsEmpty());
}

/// The address gives the same picture in a new window.
TEST_F(ComparePage, ALinkReproducesTheView)
{
    open();
    browser_->click("input[data-series=\"1\"]");
    choose("quantity", "all");
    choose("axis", "spacing");
    choose("scale", "log");
    choose("across", "log");
    browser_->click("#bands");
    browser_->drag("#chart svg", 0.3, 0.6, 0.3, 0.6);
    const std::string link = hash();
    const std::string picture = evaluate("document.getElementById('chart').innerHTML.replaceAll(' near', '')");
    EXPECT_THAT(link, HasSubstr("series=0,2"));
    open();
    EXPECT_NE(evaluate("document.getElementById('chart').innerHTML"), picture);
    open(link);
    const auto without_cursor = [](std::string text) {
        const auto cut = text.find("<line class=\"cursor\"");
        return text.substr(0, cut);
    };
    EXPECT_EQ(without_cursor(evaluate("document.getElementById('chart').innerHTML")), without_cursor(picture));
    EXPECT_FALSE(evaluate("document.querySelector('input[data-series=\"1\"]').checked").get<bool>());
    EXPECT_TRUE(evaluate("document.getElementById('bands').checked").get<bool>());
    // An address of nonsense leaves the page as it is.
    open("quantity=nothing&frequencies=9~x&series=abc");
    EXPECT_EQ(evaluate("charts.length"), 0);
    open("series=0-1&frequencies=30~20");
    EXPECT_EQ(evaluate("charts[0].curves.length"), 2);
    EXPECT_EQ(evaluate("charts[0].settings.x"), nullptr);
}

/// The table of what is shown against the stored tables.
TEST_F(ComparePage, GivesATableOfWhatIsShown)
{
    open();
    browser_->drag("#chart svg", 0.3, 0.6, 0.5, 0.5);
    const auto shown = range();
    std::istringstream lines(evaluate("shownCsv()").get<std::string>());
    std::string line;
    std::getline(lines, line);
    EXPECT_EQ(line, "plot,series,run,x,y,standard_error");
    std::size_t rows = 0;
    const auto table = read_radial_table(folder_->path() / "run/jittered/radial.csv");
    while (std::getline(lines, line)) {
        constexpr std::string_view begin = "power,\"Jittered, it's fine\",";
        if (!line.starts_with(begin)) continue;
        const std::size_t at = line.rfind("\",") + 2;
        const double x = std::stod(line.substr(at)), y = std::stod(line.substr(line.find(',', at) + 1));
        const auto bin = std::ranges::find(table, x, &RadialBin::frequency);
        ASSERT_NE(bin, table.end()) << line;
        EXPECT_NEAR(y, bin->power, 5e-5 * std::abs(bin->power)) << line; // five digits
        ++rows;
    }
    EXPECT_EQ(rows, static_cast<std::size_t>(std::ranges::count_if(table, [&](const RadialBin& bin) {
                  return bin.frequency >= shown[0] && bin.frequency <= shown[1];
              })));
}

}
}
