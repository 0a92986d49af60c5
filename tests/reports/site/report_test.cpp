// write_report on a small result folder: the page, the pictures, and that both are always the same.
#include "reports/site/report.hpp"

#include "base/files/whole_file.hpp"
#include "reports/plots/curves.hpp"
#include "reports/words/number_format.hpp"
#include "tests/reports/support/page_text.hpp"
#include "tests/reports/support/synthetic_results.hpp"
#include "tests/support/picture.hpp"
#include "tests/support/temporary_folder.hpp"

#include "base/errors/errors.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <map>
#include <set>

namespace poissonlab {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

/// A result folder with its report, made once for all tests that only look at it.
class ReportTest : public testing::Test
{
protected:
    static void SetUpTestSuite()
    {
        folder_ = new TemporaryFolder;
        results_ = new nlohmann::json(test::write_synthetic_results(folder_->path()));
        write_report({folder_->path()}, folder_->path(), {}, PrintPictures::drawn);
    }
    static void TearDownTestSuite()
    {
        delete results_;
        delete folder_;
    }

    static const fs::path& folder() { return folder_->path(); }
    static const nlohmann::json& results() { return *results_; }
    static std::string page(const std::string& name = "index.html") { return read_whole_file(folder() / name); }

private:
    inline static TemporaryFolder* folder_ = nullptr;
    inline static nlohmann::json* results_ = nullptr;
};

TEST_F(ReportTest, EveryPageIsSound)
{
    EXPECT_EQ(test::site_errors(folder()), "");
    std::vector<std::string> names;
    for (const auto& [name, text] : test::pages_below(folder())) names.push_back(name);
    EXPECT_THAT(names, ElementsAre("claims.html", "compare.html", "index.html", "jittered/index.html",
                                   "random/index.html", "regular/index.html"));
}

TEST_F(ReportTest, EveryPageIsInReach)
{
    for (const char* name : {"random/index.html", "jittered/index.html", "regular/index.html", "compare.html"})
        EXPECT_THAT(test::attribute_values(page(), "href"), testing::Contains(name));
    EXPECT_THAT(test::attribute_values(page("jittered/index.html"), "href"),
                testing::IsSupersetOf({"../index.html", "../compare.html", "../random/index.html",
                                       "../regular/index.html", "../site/report.css", "spectrum.exr"}));
}

TEST_F(ReportTest, ScriptsAndStylesNameNothingElse)
{
    for (const auto& entry : fs::directory_iterator(folder() / "site")) {
        const auto text = read_whole_file(entry.path());
        for (const char* word : {"@import", "import(", "fetch(", "XMLHttpRequest", "https:"})
            EXPECT_THAT(text, Not(HasSubstr(word))) << entry.path();
    }
}

TEST_F(ReportTest, EveryPictureShowsSomething)
{
    for (const char* series : {"random", "jittered", "regular"})
        EXPECT_EQ(test::count_of(page(series + std::string("/index.html")), "<figure"), 7);
    EXPECT_EQ(test::count_of(page(), "<figure"), 3 + 3 * 4) << "plots of all series, and four pictures of each";
    for (const auto& entry : fs::recursive_directory_iterator(folder())) {
        if (entry.path().extension() == ".png") {
            EXPECT_GT(test::decode_png(read_whole_file(entry.path())).variance(), 1) << entry.path();
        }
        if (entry.path().extension() == ".svg") {
            EXPECT_THAT(read_whole_file(entry.path()),
                        testing::AllOf(HasSubstr("<svg"), HasSubstr("</svg>"), HasSubstr("<path")));
        }
    }
}

/// The mean of a stored statistic with as many digits as its standard error allows.
std::string rounded_mean(const nlohmann::json& statistic)
{
    const auto each = statistic["each"].get<std::vector<double>>();
    const double mean = statistic["mean"];
    if (each.size() < 2) return format_estimate(mean, {}).value;
    double squares = 0;
    for (const double value : each) squares += (value - mean) * (value - mean);
    const auto n = static_cast<double>(each.size());
    return format_estimate(mean, std::sqrt(squares / (n - 1) / n)).value;
}

TEST_F(ReportTest, ShowsTheStoredNumbers)
{
    const auto text = page();
    for (const auto& series : results()["series"]) {
        const auto name = series["name"].get<std::string>();
        const auto begin =
            text.find(fmt::format("<a href=\"{}/index.html\">", name), text.find("<table id=\"ranking\">"));
        const auto row = text.substr(begin, text.find("</tr>", begin) - begin);
        const auto own = page(name + "/index.html");
        const auto shows = [&](const std::string& key, double exact, const std::string& words) {
            const auto data = fmt::format("<data value=\"{}\">{}</data>", format_exact(exact), words);
            const auto cell = row.find(fmt::format("<td data-key=\"{}\"", key));
            EXPECT_THAT(row.substr(cell, row.find("</td>", cell) - cell), HasSubstr(data)) << key;
            if (key != "points" && key != "realizations") {
                EXPECT_THAT(own, HasSubstr(data)) << key;
            }
        };
        const double radius = series["relative_radius"]["mean"];
        const double distance = series["min_distance"]["mean"];
        const double covered = series["covered_fraction"]["mean"];
        shows("relative_radius", radius, rounded_mean(series["relative_radius"]));
        shows("min_distance", distance, rounded_mean(series["min_distance"]));
        shows("sample_time", 0.0123, "12.3 ms");
        shows("points_per_second", 256 / 0.0123 / 1e6, format_significant(256e-6 / 0.0123, 3));
        shows("points", 256, "256");
        shows("realizations", series["realizations"], series["realizations"].dump());
        EXPECT_THAT(own, HasSubstr(fmt::format("<data value=\"{}\">", format_exact(covered))));
        EXPECT_THAT(own, HasSubstr("strength = 0.6"));
    }
    EXPECT_THAT(text, Not(HasSubstr("data-key=\"lattice_peaks\""))) << "columns that no series has";
}

TEST_F(ReportTest, SaysWhereTheResultsComeFrom)
{
    EXPECT_THAT(page(), HasSubstr("0.1.0 (test)"));
    EXPECT_THAT(page(), HasSubstr("<dd>18446744073709551615</dd>"));
    EXPECT_THAT(page(), HasSubstr("<dd>the sequential reference</dd>"));
    EXPECT_THAT(page(), HasSubstr("<dd>seed=7</dd>"));
    EXPECT_THAT(page(), HasSubstr("poissonlab run grids.toml --set"));
}

TEST_F(ReportTest, EscapesWhatUsersWrote)
{
    EXPECT_THAT(page(), HasSubstr("Grids &lt;script&gt;alert(1)&lt;/script&gt; &amp; co"));
    EXPECT_THAT(page(), HasSubstr("Random &lt;b&gt;bold&lt;/b&gt; &amp; &quot;quoted&quot;"));
    EXPECT_THAT(page(), HasSubstr("title = &quot;&lt;i&gt;&amp;amp;&lt;/i&gt;&quot;\n{{braces}}"));
    EXPECT_THAT(page(), HasSubstr("Test &lt;device&gt;"));
    EXPECT_THAT(page("random/index.html"), HasSubstr("note = a&lt;b"));
}

TEST_F(ReportTest, OneSetHasAPeriodogramAndNoEstimate)
{
    EXPECT_THAT(page("random/index.html"), HasSubstr("Power spectrum estimate"));
    const auto text = page("regular/index.html");
    EXPECT_THAT(text, HasSubstr("Periodogram"));
    EXPECT_THAT(text, Not(testing::ContainsRegex("[Pp]ower spectrum")));
    EXPECT_THAT(text, Not(HasSubstr("estimate")));
}

TEST_F(ReportTest, DescribesTheToneMapping)
{
    EXPECT_THAT(page("random/index.html"), HasSubstr("power 0.01 is black, power 10 is white, logarithmic"));
}

TEST_F(ReportTest, PlotsOfAllSeriesHaveLegendsThatLeadToTheSeries)
{
    const auto text = page();
    const auto begin = text.find("<ul class=\"legend\">");
    const auto legend = text.substr(begin, text.find("</ul>", begin) - begin);
    EXPECT_THAT(test::attribute_values(legend, "href"),
                ElementsAre("random/index.html", "jittered/index.html", "regular/index.html"));
    EXPECT_THAT(test::attribute_values(legend, "stroke"), ElementsAre(curve_color(0), curve_color(1), curve_color(2)));
    EXPECT_THAT(legend, HasSubstr("Random &lt;b&gt;bold&lt;/b&gt; &amp; &quot;quoted&quot;"));
}

TEST_F(ReportTest, PrintPicturesOfCurvesAreDrawnWhenAskedFor)
{
    const TemporaryFolder other;
    test::write_synthetic_results(other.path());
    write_report({other.path()}, other.path());
    EXPECT_EQ(test::site_errors(other.path()), "");
    for (const char* stem : {"radial-all", "random/radial", "random/anisotropy"}) {
        EXPECT_TRUE(fs::exists(other.path() / (stem + std::string(".svg")))) << stem;
        EXPECT_FALSE(fs::exists(other.path() / (stem + std::string(".png")))) << stem;
        EXPECT_TRUE(fs::exists(folder() / (stem + std::string(".png")))) << stem;
    }
    EXPECT_THAT(test::attribute_values(page("random/index.html"), "href"), testing::Contains("radial.png"));
}

TEST_F(ReportTest, ColoursOfCurvesStandInTheStyleSheetForBothGrounds)
{
    const auto css = page("site/report.css");
    for (const char* rule : {"--curve-0: #0072b2;", "--curve-0: #4aa8e8;", "--curve-6: #555555;"})
        EXPECT_THAT(css, HasSubstr(rule));
}

/// All files of a folder with their bytes.
std::map<std::string, std::string> bytes_below(const fs::path& folder)
{
    std::map<std::string, std::string> result;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file())
            result[entry.path().lexically_relative(folder).string()] = read_whole_file(entry.path());
    return result;
}

TEST_F(ReportTest, IsTheSameEveryTime)
{
    const TemporaryFolder other;
    test::write_synthetic_results(other.path());
    write_report({other.path()}, other.path(), {}, PrintPictures::drawn);
    const auto first = bytes_below(folder());
    const auto second = bytes_below(other.path());
    ASSERT_EQ(first.size(), second.size());
    for (const auto& [name, bytes] : first) EXPECT_EQ(bytes == second.at(name), true) << name;
}

TEST_F(ReportTest, SeveralFoldersShareOnePage)
{
    const TemporaryFolder base;
    const fs::path a = base.path() / "a" / "run";
    const fs::path b = base.path() / "b" / "run";
    test::write_synthetic_results(a);
    auto other = test::write_synthetic_results(b);
    other["title"] = "The other run";
    test::write_results_json(b, other);
    const auto out = base.path() / "out";
    std::vector<std::string> steps;
    write_report({a, b}, out, [&](const std::string& step) { steps.push_back(step); });

    const auto text = read_whole_file(out / "index.html");
    EXPECT_EQ(test::site_errors(out), "");
    EXPECT_THAT(text, HasSubstr("Comparison: Grids"));
    EXPECT_THAT(text, HasSubstr("; The other run"));
    EXPECT_THAT(text,
                HasSubstr("<td data-key=\"run\" class=\"text\"><a href=\"run-2/index.html\">The other run</a></td>"));
    EXPECT_THAT(test::attribute_values(text, "href"),
                testing::IsSupersetOf(
                    {"run/index.html", "run-2/index.html", "run/regular/index.html", "run-2/regular/index.html"}));
    EXPECT_THAT(test::attribute_values(read_whole_file(out / "run/index.html"), "href"),
                testing::IsSupersetOf({"../index.html", "../run-2/index.html", "random/index.html"}));
    EXPECT_THAT(read_whole_file(out / "radial-all.svg"),
                testing::AllOf(HasSubstr("Regular grid (run)"), HasSubstr("Regular grid (run-2)")));
    for (const char* picture : {"run/thumbnail.png", "run-2/thumbnail.png"})
        EXPECT_GT(test::decode_png(read_whole_file(out / picture)).variance(), 1) << picture;
    EXPECT_TRUE(fs::is_regular_file(out / "run" / "regular" / "points.png"));
    EXPECT_TRUE(fs::is_regular_file(out / "run-2" / "regular" / "spectrum.png"));
    EXPECT_FALSE(fs::exists(a / "regular" / "points.png"));
    EXPECT_THAT(steps, ElementsAre("reading results", "drawing pictures", "writing the pages"));
}

/// The captions of the plots of all series, and the plot of radially averaged power, where the sets of the
/// second series have `points` points (but for the first, which is drawn).
std::string comparison_with(int points)
{
    const TemporaryFolder other;
    auto json = test::write_synthetic_results(other.path());
    json["series"][1]["points"] = points;
    json["series"][1]["points_each"] = {256, 256};
    test::write_results_json(other.path(), json);
    write_report({other.path()}, other.path());
    const auto page = read_whole_file(other.path() / "index.html");
    const auto begin = page.find("<section id=\"compared\"");
    return page.substr(begin, page.find("</section>", begin) - begin) +
           read_whole_file(other.path() / "radial-all.svg");
}

TEST_F(ReportTest, SeriesOfAboutOneSizeAreComparedByFrequency)
{
    const auto text = comparison_with(240);
    EXPECT_THAT(text, HasSubstr(">frequency (cycles per unit length)<"));
    EXPECT_THAT(text, Not(HasSubstr(" points)<")));
}

TEST_F(ReportTest, SeriesOfDifferentSizesAreComparedByMeanSpacing)
{
    const auto text = comparison_with(64);
    EXPECT_THAT(text, HasSubstr("in cycles per mean spacing of the points"));
    EXPECT_THAT(text, HasSubstr(">frequency (cycles per mean spacing of the points)<"));
    EXPECT_THAT(text, HasSubstr(">Jittered, it's fine (64 points)<"));
    EXPECT_THAT(text, HasSubstr(">Regular grid (256 points)<"));
    // All spectra reach 32 cycles per unit length: 4 spacings of 1/8, and 2 of 1/16. The axis has room for 4.
    EXPECT_THAT(text, HasSubstr("> 3.5</tspan>"));
    EXPECT_THAT(text, Not(HasSubstr("> 4.5</tspan>")));
}

TEST_F(ReportTest, KeysSayTheNumberOfPointsOnce)
{
    EXPECT_EQ(label_with_points("Random", 1024), "Random (1,024 points)");
    EXPECT_EQ(label_with_points("Random, N = 1,024", 1024), "Random, N = 1,024");
    EXPECT_EQ(label_with_points("Darts, N = 1,024, rho = 0.7", 1024), "Darts, N = 1,024, rho = 0.7");
    EXPECT_EQ(label_with_points("Darts, N = 1,024,000", 1024), "Darts, N = 1,024,000 (1,024 points)");
}

TEST_F(ReportTest, OneSeriesIsComparedWithTheGalleryAlone)
{
    const TemporaryFolder other;
    auto json = test::write_synthetic_results(other.path());
    json["series"].erase(1);
    json["series"].erase(1);
    test::write_results_json(other.path(), json);
    write_report({other.path()}, other.path());
    const auto text = read_whole_file(other.path() / "index.html");
    EXPECT_EQ(test::site_errors(other.path()), "");
    EXPECT_THAT(text, Not(HasSubstr("All series compared")));
    EXPECT_THAT(read_whole_file(other.path() / "compare.html"), HasSubstr("Dart throwing"));
    EXPECT_FALSE(fs::exists(other.path() / "radial-all.svg"));
}

/// A label is free text: none of it may reach gnuplot as a command.
TEST_F(ReportTest, LabelsAreNoCommands)
{
    const TemporaryFolder other;
    auto json = test::write_synthetic_results(other.path());
    json["series"][0]["label"] = "x' ; system 'touch " + (other.path() / "harm").string() + "'\n!date";
    json["series"][1]["label"] = "{/Symbol a} \\ \" `date` %s $series0 " + std::string(20, '.') + "\u00e9\u00e9";
    test::write_results_json(other.path(), json);
    write_report({other.path()}, other.path());
    EXPECT_FALSE(fs::exists(other.path() / "harm"));
    EXPECT_THAT(read_whole_file(other.path() / "radial-all.svg"), HasSubstr("`date` %s $series0"));
}

TEST_F(ReportTest, RefusesAnEmptyList) { EXPECT_THROW(write_report({}, folder()), InputError); }

}
}
