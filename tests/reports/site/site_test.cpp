// The site: grids as tables of pictures, the ranking's cells, the compare page's data, collections, several machines.
#include "reports/words/number_format.hpp"
#include "tests/reports/support/page_text.hpp"
#include "tests/reports/support/report_fixture.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/picture.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <fstream>
#include <sstream>

namespace poissonlab {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

class SiteTest : public test::ReportFixture
{
protected:
    /// The three series as a grid of one method: 2 x 2 places, of which one is empty.
    void make_grid()
    {
        json_["methods"] = {{{"sampler", "corner-tiles"},
                             {"label", ""},
                             {"axes",
                              {{{"key", "colors"}, {"symbol", "C"}, {"values", {"2", "3"}}},
                               {{"key", "points_per_tile"}, {"symbol", "N"}, {"values", {"32", "64"}}}}}}};
        const std::vector<std::vector<int>> places = {{0, 0}, {0, 1}, {1, 1}};
        for (std::size_t i = 0; i < 3; ++i) {
            json_["series"][i]["method"] = 0;
            json_["series"][i]["place"] = places[i];
        }
    }

    std::string file(const std::string& name) const { return read_whole_file(path() / name); }

    /// The first series under many names, by these samplers.
    void repeat_series(const std::vector<std::string>& samplers)
    {
        const nlohmann::json model = json_["series"][0];
        json_["series"] = nlohmann::json::array();
        for (std::size_t i = 0; i < samplers.size(); ++i) {
            json_["series"].push_back(model);
            json_["series"][i]["name"] = fmt::format("series-{}", i);
            json_["series"][i]["sampler"] = samplers[i];
        }
    }

    /// The numbers of the series that the compare page shows at first.
    std::vector<std::string> shown_at_first() const
    {
        const auto page = file("compare.html");
        const std::string box = "data-series=\"";
        std::vector<std::string> numbers;
        for (auto at = page.find(box); at != std::string::npos; at = page.find(box, at)) {
            at += box.size();
            const auto end = page.find('"', at);
            if (page.compare(end + 1, 8, " checked") == 0) numbers.push_back(page.substr(at, end - at));
        }
        return numbers;
    }

    /// The data of the compare page.
    nlohmann::json compare_data() const
    {
        const auto page = file("compare.html");
        const std::string mark = "<script type=\"application/json\" id=\"data\">";
        const auto begin = page.find(mark) + mark.size();
        return nlohmann::json::parse(page.substr(begin, page.find("</script>", begin) - begin));
    }
};

TEST_F(SiteTest, AGridIsATableOfPictures)
{
    make_grid();
    page();
    const auto text = file("index.html");
    const auto begin = text.find("<table class=\"matrix\">");
    const auto table = text.substr(begin, text.find("</table>", begin) - begin);
    EXPECT_THAT(text, HasSubstr("<h2>corner-tiles</h2>")) << "the labels have nothing in common";
    for (const char* heading : {"<th scope=\"col\">N = 32</th>", "<th scope=\"col\">N = 64</th>",
                                "<th scope=\"row\">C = 2</th>", "<th scope=\"row\">C = 3</th>"})
        EXPECT_THAT(table, HasSubstr(heading));
    EXPECT_THAT(test::attribute_values(table, "href"),
                ElementsAre("random/index.html", "jittered/index.html", "regular/index.html"));
    EXPECT_EQ(test::count_of(table, "<td></td>"), 1) << "C = 3, N = 32";
    EXPECT_LT(table.find("<td></td>"), table.find("regular/index.html"));
    EXPECT_EQ(test::count_of(table, "<img "), 3 * 3) << "spectrum, radial power and points";
    EXPECT_EQ(test::count_of(table, " hidden=\"hidden\""), 3 * 2) << "but for the spectra";
    EXPECT_EQ(test::count_of(text, "<article class=\"glance\">"), 3) << "small runs show all series large as well";
}

TEST_F(SiteTest, LargeRunsShowSeriesOfTablesOnlyThere)
{
    repeat_series(std::vector<std::string>(7, "corner-tiles"));
    std::vector<std::string> values;
    for (int i = 0; i < 7; ++i) {
        json_["series"][i]["method"] = 0;
        json_["series"][i]["place"] = {i};
        values.push_back(fmt::format("{}", i));
    }
    json_["methods"] = {
        {{"sampler", "corner-tiles"}, {"label", ""}, {"axes", {{{"key", "c"}, {"symbol", "C"}, {"values", values}}}}}};
    page();
    EXPECT_THAT(file("index.html"), Not(HasSubstr("Series by series")));
}

TEST_F(SiteTest, ATableIsCalledWhatItsSeriesHaveInCommon)
{
    make_grid();
    for (int i = 0; i < 3; ++i) json_["series"][i]["label"] = fmt::format("Tiles, C = {}, N = 64, repulsion", i);
    EXPECT_THAT(page(), HasSubstr("<h2>Tiles, N = 64, repulsion</h2>"));
}

TEST_F(SiteTest, OneAxisIsARow)
{
    json_["methods"] = {{{"sampler", "darts"},
                         {"label", "Darts"},
                         {"axes", {{{"key", "rho"}, {"symbol", "ρ"}, {"values", {"0.7", "0.75"}}}}}}};
    for (int i = 0; i < 2; ++i) {
        json_["series"][i]["method"] = 0;
        json_["series"][i]["place"] = {i};
    }
    page();
    const auto text = file("index.html");
    EXPECT_THAT(text, HasSubstr("<h2>Darts</h2>"));
    EXPECT_EQ(test::count_of(text, "<th scope=\"col\">ρ = "), 2);
    EXPECT_EQ(test::count_of(text, "<article class=\"glance\">"), 3);
}

TEST_F(SiteTest, FurtherAxesMakeATableForEachOfTheirValues)
{
    make_grid();
    json_["methods"][0]["axes"].push_back({{"key", "x"}, {"symbol", "X"}, {"values", {"a", "b"}}});
    for (int i = 0; i < 3; ++i) json_["series"][i]["place"].push_back(i % 2);
    page();
    EXPECT_THAT(file("index.html"),
                testing::AllOf(HasSubstr("<h2>corner-tiles, X = a</h2>"), HasSubstr("<h2>corner-tiles, X = b</h2>")));
}

TEST_F(SiteTest, PlacesOutsideTheGridAreErrors)
{
    make_grid();
    EXPECT_THAT(error_after("place",
                            [](auto& json) {
                                json = {0, 2};
                            }),
                HasSubstr("series[0].place: must be an index"));
    EXPECT_THAT(error_after("place", [](auto& json) { json = {0}; }), HasSubstr("series[0].place: must be an index"));
    EXPECT_THAT(error_after("method", [](auto& json) { json = 1; }),
                HasSubstr("series[0].method = 1: must be the number"));
}

/// Where methods have several series, each has a row: the series of the largest relative radius, with pictures.
TEST_F(SiteTest, EachMethodHasARowWithItsBestSeries)
{
    std::vector<std::string> samplers{"random", "corner-tiles", "random", "corner-tiles", "corner-tiles"};
    std::vector<double> radii{0.1, 0.7, 0.3, 0.72, 0.66};
    samplers.resize(13, "corner-tiles");
    radii.resize(13, 0.5);
    repeat_series(samplers);
    for (std::size_t i = 0; i < radii.size(); ++i) {
        json_["series"][i]["label"] = fmt::format("Series {}", i);
        json_["series"][i]["relative_radius"] = {
            {"min", radii[i]}, {"mean", radii[i]}, {"max", radii[i]}, {"each", {radii[i], radii[i]}}};
        json_["series"][i]["realizations"] = 2;
    }
    page();
    const auto text = file("index.html");
    const auto begin = text.find("<table id=\"method-table\">");
    ASSERT_NE(begin, std::string::npos);
    const auto table = text.substr(begin, text.find("</table>", begin) - begin);
    EXPECT_EQ(test::count_of(table, "<th scope=\"row\">"), 2);
    EXPECT_THAT(table, HasSubstr("<a href=\"series-2/index.html\">random</a><small>Series 2</small>"
                                 "<small>best of 2 series</small>"));
    EXPECT_THAT(table, HasSubstr("<a href=\"series-3/index.html\">corner-tiles</a><small>Series 3</small>"
                                 "<small>best of 11 series</small>"));
    EXPECT_THAT(table, HasSubstr("<td class=\"number\">0.720</td>"));
    EXPECT_THAT(table, HasSubstr("seem to be the best of those that tile"));
    EXPECT_THAT(table, HasSubstr("points meet"));
    EXPECT_GE(test::count_of(table, "<img "), 2 * 2);
    EXPECT_THAT(text, HasSubstr("<a href=\"#methods\">Methods</a>"));
    EXPECT_LT(begin, text.find("<section id=\"overview\">")) << "before the ranking";
}

TEST_F(SiteTest, AFewSeriesNeedNoTableOfMethods)
{
    repeat_series({"random", "jittered", "jittered", "regular"});
    EXPECT_THAT(page(), Not(HasSubstr("method-table")));
}

TEST_F(SiteTest, ALongRankingIsBehindAClick)
{
    repeat_series(std::vector<std::string>(30, "random"));
    const auto text = page();
    EXPECT_THAT(text, HasSubstr("<details class=\"whole\"><summary>All 30 series, sorted by any measure</summary>"));
    EXPECT_THAT(text, HasSubstr("<tr data-method=\"random\" data-points="));
    repeat_series(std::vector<std::string>(5, "random"));
    EXPECT_THAT(page(), Not(HasSubstr("<details class=\"whole\">")));
}

TEST_F(SiteTest, TheRankingShowsMeasuresWithErrors)
{
    auto& first = json_["series"][0];
    first["measures"] = {
        {"effective_nyquist", 0.6314159},
        {"effective_nyquist_standard_error", 0.00123},
        {"oscillation", {{"value", 2.5}, {"standard_error", 0.25}}},
        {"lattice_peaks",
         {{"tiles", 4}, {"max_ratio", 9.0}, {"mean_ratio", 3.25}, {"peaks", 12}, {"mean_ratio_standard_error", 0.5}}},
        {"peak_anisotropy", {{"db", -7.25}, {"frequency", 20.0}, {"standard_error_db", 0.125}, {"samples", 120}}},
        {"largest_empty", {{"radius", 0.1}, {"relative_radius", 0.875}}}};
    first["tile_set"] = {{"tiles", 16}, {"points_per_tile", 64}, {"build_seconds", 0.25}, {"cached", true}};
    page();
    const auto text = file("index.html");
    const auto cell = [](const char* key, const char* exact, const char* shown, const char* error,
                         const char* classes = " class=\"detail\"") {
        return fmt::format("<td data-key=\"{}\"{}><data value=\"{}\">{}</data>{}</td>", key, classes, exact, shown,
                           *error ? fmt::format(" <small>{}</small>", error) : "");
    };
    EXPECT_THAT(text, HasSubstr(cell("effective_nyquist", "0.6314159", "0.6314", "± 0.0012", "")));
    EXPECT_THAT(text, HasSubstr(cell("oscillation", "2.5", "2.50", "± 0.25")));
    EXPECT_THAT(text, HasSubstr(cell("lattice_peaks", "3.25", "3.2", "± 0.5")));
    EXPECT_THAT(text, HasSubstr(cell("peak_anisotropy", "-7.25", "−7.25", "± 0.12")));
    EXPECT_THAT(text, HasSubstr(cell("largest_empty", "0.875", "0.8750", "")));
    EXPECT_THAT(text, HasSubstr(cell("build_time", "0.25", "250 ms", "earlier")));
    EXPECT_EQ(test::count_of(text, "<td data-key=\"build_time\" class=\"detail\">–</td>"), 2) << "of the others";
    EXPECT_THAT(text, HasSubstr("data-key=\"peak_anisotropy\" data-better=\"lower\" aria-sort=\"none\""));
    EXPECT_THAT(text, HasSubstr("data-key=\"effective_nyquist\" data-better=\"higher\" aria-sort=\"none\""));
}

TEST_F(SiteTest, TheRankingIsSortedAndMarksTheBest)
{
    for (int i = 0; i < 3; ++i) {
        const double radius = 0.5 + 0.1 * i;
        auto& series = json_["series"][static_cast<std::size_t>(i)];
        series["label"] = fmt::format("Series {}", i);
        series["relative_radius"] = {{"min", radius}, {"mean", radius}, {"max", radius}, {"each", {radius}}};
        series["measures"] = {{"low_frequency_mean", 0.3 - 0.1 * i}, {"anisotropy_above_chance", i == 2 ? 12 : 0}};
    }
    json_["series"][0]["parameters"]["density"] = "ramp";
    page();
    const auto text = file("index.html");
    const auto table = text.substr(text.find("<table id=\"ranking\">"));
    EXPECT_LT(table.find("Series 2"), table.find("Series 1"));
    EXPECT_LT(table.find("Series 1"), table.find("Series 0"));
    EXPECT_THAT(table, HasSubstr("<small>follows a density: not ranked</small>"));
    EXPECT_THAT(table, HasSubstr("data-key=\"relative_radius\" data-better=\"higher\" aria-sort=\"descending\""));
    EXPECT_THAT(table, HasSubstr("<td data-key=\"relative_radius\" class=\"best\"><data value=\"0.7\">"));
    EXPECT_THAT(text,
                HasSubstr("for points far apart: <a href=\"jittered/index.html\">Series 1</a> (mean ρ = 0.6000);"));
    EXPECT_THAT(text, HasSubstr("Left out here for their preferred directions: Series 2."));
    EXPECT_LT(text.find("<section id=\"overview\">"), text.find("<section id=\"series\">"))
        << "the ranking comes before the pictures";
    for (const char* picture : {"points.", "spectrum-small.", "radial.", "anisotropy."})
        EXPECT_THAT(text, HasSubstr(fmt::format("src=\"jittered/{}", picture)));
}

TEST_F(SiteTest, ThePageHasTheRadialCurvesToFiveDigits)
{
    page();
    const auto data = compare_data();
    ASSERT_GT(data["series"].size(), 3) << "those of the gallery follow";
    for (const auto& series : json_["series"]) {
        const auto& shown = data["series"][static_cast<std::size_t>(&series - &json_["series"][0])];
        EXPECT_EQ(shown["label"], series["label"]);
        std::istringstream csv(file(series["radial"]["file"]));
        std::string line;
        std::getline(csv, line); // header
        const auto& frequencies = data["abscissae"][shown["frequencies"].get<std::size_t>()];
        for (std::size_t i = 0; std::getline(csv, line); ++i) {
            std::istringstream fields(line);
            double frequency = 0, power = 0;
            char comma = 0;
            fields >> frequency >> comma >> power;
            EXPECT_NEAR(frequencies[i].get<double>(), frequency, 5e-5 * frequency);
            EXPECT_NEAR(shown["power"][i].get<double>(), power, 5e-5 * std::abs(power) + 1e-300);
        }
    }
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_EQ(data["series"][i]["frequencies"], 0) << "all have the same frequencies";
    EXPECT_EQ(data["series"].back()["page"], nullptr);
}

TEST_F(SiteTest, TheComparePageBeginsWithAllOfAFewSeries)
{
    repeat_series({"a", "a", "b"});
    page();
    EXPECT_THAT(shown_at_first(), ElementsAre("0", "1", "2"));
}

TEST_F(SiteTest, TheComparePageBeginsWithTheFirstSeriesOfEachMethodOfMany)
{
    std::vector<std::string> samplers(14, "a");
    samplers[5] = samplers[7] = samplers[9] = "b";
    repeat_series(samplers);
    json_["series"][5]["points"] = 2 * json_["series"][0]["points"].get<int>(); // of another size than most
    json_["series"][5]["points_each"] = {json_["series"][0]["points"], 3 * json_["series"][0]["points"].get<int>()};
    page();
    EXPECT_THAT(shown_at_first(), ElementsAre("0", "7"));
}

TEST_F(SiteTest, OfManySeriesByOneMethodSomeFromAllOverTheListAreShownAtFirst)
{
    repeat_series(std::vector<std::string>(24, "a"));
    page();
    const auto shown = shown_at_first();
    EXPECT_EQ(shown.size(), 12);
    EXPECT_GT(std::stoi(shown.back()), 20);
}

TEST_F(SiteTest, SeriesWithoutSpectrumAreShownWithWhatTheyHave)
{
    auto& first = json_["series"][0];
    first.erase("spectrum");
    first.erase("radial");
    page();
    const auto own = file("random/index.html");
    for (const char* words : {"Power spectrum", "Radially averaged power", "Anisotropy"})
        EXPECT_THAT(own, Not(HasSubstr(words)));
    EXPECT_THAT(own, testing::AllOf(HasSubstr("points.svg"), HasSubstr("cells.svg")));
    EXPECT_FALSE(compare_data()["series"][0].contains("power"));
    EXPECT_THAT(file("radial-all.svg"), Not(HasSubstr("Random")));
}

TEST_F(SiteTest, NeighboursOfCellsHaveAKey)
{
    json_["series"][1]["measures"] = {
        {"voronoi", {{"relative_area_variance", 0.02}, {"neighbour_share", {0.01, 0.25, 0.5, 0.2, 0.04}}}}};
    page();
    const auto own = file("jittered/index.html");
    for (const char* share : {"up to 4: 1.0 %", "5: 25.0 %", "6: 50.0 %", "7: 20.0 %", "8 and more: 4.0 %"})
        EXPECT_THAT(own, HasSubstr(share));
    EXPECT_THAT(own, HasSubstr("shares are of all cells of the set (first of 2 realizations)."));
    EXPECT_THAT(file("regular/index.html"), HasSubstr("up to 4: 100.0 %"));
}

/// Two runs in a folder, as a collection lists them.
class CollectionTest : public testing::Test
{
protected:
    void SetUp() override
    {
        for (const char* name : {"first", "second"}) runs_[name] = test::write_synthetic_results(path() / name);
        runs_["second"]["title"] = "The second";
        write("second");
        write_collection({"first", "second"});
    }

    fs::path path() const { return folder_.path(); }
    void write(const std::string& name) { test::write_results_json(path() / name, runs_[name]); }
    void write_collection(const nlohmann::json& runs)
    {
        const nlohmann::json json = {{"format", "poissonlab-collection"},
                                     {"format_version", 1},
                                     {"title", "All of them"},
                                     {"command", "poissonlab run all.toml"},
                                     {"runs", runs}};
        write_whole_file(path() / "collection.json", json.dump());
    }
    std::string overview()
    {
        write_report({path()}, path());
        EXPECT_EQ(test::site_errors(path()), "");
        return read_whole_file(path() / "index.html");
    }

    TemporaryFolder folder_;
    std::map<std::string, nlohmann::json> runs_;
};

TEST_F(CollectionTest, IsOneReportOverItsRuns)
{
    const auto text = overview();
    EXPECT_THAT(text, HasSubstr("<h1>All of them</h1>"));
    EXPECT_THAT(test::attribute_values(text, "href"),
                testing::IsSupersetOf({"first/index.html", "second/index.html", "first/random/index.html"}));
    EXPECT_TRUE(fs::exists(path() / "first/random/radial.svg")) << "beside the results";
    EXPECT_THAT(read_whole_file(path() / "second/index.html"), HasSubstr("<h1>The second</h1>"));
    EXPECT_THAT(text, Not(HasSubstr("class=\"notice\"")));
}

TEST_F(CollectionTest, TimesOfDifferentMachinesAreMarked)
{
    runs_["second"]["machine"]["device"] = "Another device";
    runs_["second"]["version"] = "0.2.0";
    write("second");
    const auto text = overview();
    EXPECT_THAT(text, HasSubstr("do not compare with times of another"));
    EXPECT_THAT(text,
                HasSubstr("A: Test &lt;device&gt;, driver 1.2, threads 2. B: Another device, driver 1.2, threads 2."));
    EXPECT_THAT(text, HasSubstr("different versions of the program: 0.1.0 (test); 0.2.0."));
    EXPECT_EQ(test::count_of(text, "<data value=\"0.0123\">12.3 ms</data> <sup>A</sup>"), 3);
    EXPECT_EQ(test::count_of(text, "<data value=\"0.0123\">12.3 ms</data> <sup>B</sup>"), 3);
    EXPECT_EQ(test::count_of(text, "<td data-key=\"version\" class=\"text\">0.2.0</td>"), 3);
}

TEST_F(CollectionTest, OfOneRunIsAReportOfThat)
{
    write_collection({"first"});
    EXPECT_THAT(overview(), HasSubstr("href=\"first/jittered/index.html\""));
}

TEST_F(CollectionTest, DamagedOnesNameTheMember)
{
    const auto error = [&] { return message_of([&] { overview(); }); };
    write_collection({"../first"});
    EXPECT_THAT(error(), HasSubstr("collection.json: runs: \"../first\" must be the name of a folder beside the file"));
    write_collection(nlohmann::json::array());
    EXPECT_THAT(error(), HasSubstr("collection.json: runs: must name at least one folder"));
    write_collection({"third"});
    EXPECT_THAT(error(), HasSubstr("third: no such folder"));
    write_whole_file(path() / "collection.json", "{\"format\": \"x\"}");
    EXPECT_THAT(error(), HasSubstr("collection.json: format: "));
}

}
}
