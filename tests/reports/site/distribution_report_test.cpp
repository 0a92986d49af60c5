// The overview's sections on distributions and schemes, and the words on where points are.
#include "results/pictures/mark_picture.hpp"
#include "tests/reports/support/report_fixture.hpp"
#include "tests/support/picture.hpp"

#include <gmock/gmock.h>

namespace poissonlab {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class DistributionReport : public test::ReportFixture
{
protected:
    /// A result with a picture of a red square and a blue disk, a table, and numbers.
    nlohmann::json result(const std::string& name, const std::string& kind)
    {
        MarkPicture picture;
        picture.pixels = 100;
        picture.groups = {{"#ff0000", {}, {}, {{{0.1, 0.1}, {0.4, 0.1}, {0.4, 0.4}, {0.1, 0.4}}}},
                          {"#0000ff", {{0.7, 0.7, 0.2}}, {}, {}}};
        fs::create_directories(path() / name);
        write_whole_file(path() / name / "marks.json", mark_picture_json(picture));
        write_whole_file(path() / name / "numbers.csv", "key,value\n");
        const auto number = [](const char* key, double value) {
            return nlohmann::json{{"key", key}, {"title", key}, {"value", value}, {"meaning", "points"}};
        };
        return {
            {"name", name},
            {"label", name + " <of> two"},
            {"kind", kind},
            {"facts", {"a fact"}},
            {"numbers", {number("count", 44'212), number("part", 0.251234), number("below", -2.5)}},
            {"pictures", {{{"file", name + "/marks.json"}, {"caption", "A square & a disk."}}}},
            {"files", {name + "/numbers.csv"}},
            {"tables", {{{"title", "A table"}, {"columns", {"one", "two"}}, {"rows", {{{"cells", {"1 <", "2"}}}}}}}}};
    }
};

TEST_F(DistributionReport, ShowsNumbersPicturesAndTables)
{
    json_["distributions"] = {result("distribution-ranks", "ranks")};
    json_["schemes"] = {result("scheme-noise", "noise")};
    const std::string text = page();
    for (const char* name : {"distribution-ranks", "scheme-noise"}) {
        EXPECT_THAT(text, HasSubstr(std::string(name) + " &lt;of&gt; two"));
        const auto picture = test::decode_png(read_whole_file(path() / name / "marks.png"));
        EXPECT_GT(picture.variance(), 100) << name;
    }
    EXPECT_THAT(text, HasSubstr("1 distribution, 1 scheme."));
    EXPECT_THAT(text, HasSubstr("44,212")); // counts have all digits
    EXPECT_THAT(text, HasSubstr("0.2512"));
    EXPECT_THAT(text, HasSubstr("−2.500"));
    EXPECT_THAT(text, HasSubstr("A square &amp; a disk."));
    EXPECT_THAT(text, HasSubstr("<td>1 &lt;</td>"));
}

TEST_F(DistributionReport, SaysNumbersOfATableOnce)
{
    auto result_with_table = result("scheme-noise", "noise");
    result_with_table["numbers"][1]["in_table"] = true;
    json_["schemes"] = {result_with_table};
    EXPECT_THAT(page(), AllOf(HasSubstr(">count</th>"), Not(HasSubstr(">part</th>"))));
}

/// Three distributions that have one picture each share a figure and a table, which has the columns of all. Two of them
/// have sections, and so has one with a table of its own. Four sections begin with small pictures.
TEST_F(DistributionReport, PutsSmallDistributionsIntoOneFigure)
{
    const auto small = [&](const std::string& name, const char* more) {
        auto json = result(name, "objects");
        json["tables"] = nlohmann::json::array();
        if (*more != 0)
            json["numbers"].push_back({{"key", more}, {"title", more}, {"value", 7}, {"meaning", "what it is"}});
        return json;
    };
    json_["distributions"] = {small("a", ""), result("b", "ranks"), small("c", "more")};
    EXPECT_THAT(page(), AllOf(HasSubstr("<article id=\"distribution-1\">"), Not(HasSubstr("class=\"numbers\""))));
    json_["distributions"].push_back(small("d", ""));
    const std::string text = page();
    for (const char* place : {"1", "3", "4"})
        EXPECT_THAT(text, AllOf(HasSubstr(std::string("<figure id=\"distribution-") + place + "\">"),
                                HasSubstr(std::string("<a href=\"#distribution-") + place + "\">")));
    EXPECT_THAT(text, HasSubstr("<article id=\"distribution-2\">"));
    EXPECT_THAT(text, HasSubstr("<th scope=\"col\">below</th><th scope=\"col\">more</th></tr>"));
    EXPECT_THAT(text, HasSubstr("<td>44,212</td><td>0.2512</td><td>−2.500</td><td>–</td></tr>"));
    EXPECT_THAT(text, HasSubstr("<td>44,212</td><td>0.2512</td><td>−2.500</td><td>7</td></tr>"));
    EXPECT_THAT(text, HasSubstr("<b>more.</b> what it is"));
    EXPECT_THAT(text, Not(HasSubstr("<ul class=\"cards\">\n<li><a href=\"#distribution")));
    json_["distributions"] = {result("a", "ranks"), result("b", "ranks"), result("c", "ranks"), result("d", "ranks")};
    EXPECT_THAT(page(), HasSubstr("<li><a href=\"#distribution-4\"><img class=\"framed\" src=\"d/marks.png\""));
}

TEST_F(DistributionReport, PutsTexturesOfAnExemplarSideBySide)
{
    const auto texture = [&](const std::string& name, const std::string& exemplar, double coverage) {
        auto json = result(name, "texture");
        json["parameters"] = {{{"key", "exemplar"}, {"value", exemplar}}};
        json["numbers"] = {{{"key", "coverage"}, {"title", "of " + exemplar}, {"value", coverage}, {"meaning", ""}}};
        return json;
    };
    json_["distributions"] = {texture("a", "gravel", 0.123), texture("b", "cork", 0.456),
                              texture("c", "gravel", 0.789)};
    const std::string text = page();
    EXPECT_THAT(text, HasSubstr("3 textures."));
    EXPECT_THAT(text, AllOf(HasSubstr("Textures of gravel"), Not(HasSubstr("Textures of cork"))));
    // A row has the values of both; their sections do not have them again, as that of the only one of cork does.
    EXPECT_THAT(text,
                HasSubstr(R"(<td><data value="0.123">0.123</data></td><td><data value="0.789">0.789</data></td>)"));
    EXPECT_THAT(text, AllOf(Not(HasSubstr("<th scope=\"row\">of gravel</th><td>0")),
                            HasSubstr("<th scope=\"row\">of cork</th><td>0")));
    EXPECT_LT(text.find("<h3>a &lt;of&gt; two"), text.find("<h3>c &lt;of&gt; two"));
    EXPECT_LT(text.find("<h3>c &lt;of&gt; two"), text.find("<h3>b &lt;of&gt; two")) << "those of gravel come first";
    EXPECT_THAT(text, HasSubstr(R"(<article id="distribution-3">)")) << "by its place among all distributions";
}

/// A copy, a blend and shuffled pieces fail a gate each; what passes comes first, by new patches. A texture without
/// such numbers has a card, and no verdict. One whose edges were not measured is behind those that pass.
TEST_F(DistributionReport, SaysWhichTextureToTake)
{
    const auto texture = [&](const std::string& name, const std::vector<std::pair<std::string, double>>& values) {
        auto json = result(name, "texture");
        json["label"] = "gravel: " + name;
        json["parameters"] = {{{"key", "exemplar"}, {"value", "gravel"}}};
        json["numbers"] = nlohmann::json::array();
        for (const auto& [key, value] : values)
            json["numbers"].push_back({{"key", key}, {"title", key}, {"value", value}, {"meaning", ""}});
        return json;
    };
    json_["distributions"] = {
        texture("copy",
                {{"recurrence", 1}, {"recurrence_width", 512}, {"edge_loss", 1}, {"edge_gain", 0}, {"novelty", 0}}),
        texture("blend", {{"recurrence", 0}, {"edge_loss", 2.5}, {"edge_gain", 0.5}, {"novelty", 0.1}}),
        texture("shuffle", {{"recurrence", 0}, {"edge_loss", 0}, {"edge_gain", 3}, {"novelty", 0.9}}),
        texture("uncompared", {{"recurrence", 0}, {"novelty", 0}}),
        texture(
            "second",
            {{"recurrence", 0.03}, {"recurrence_width", 64}, {"edge_loss", 1}, {"edge_gain", 0}, {"novelty", 0.08}}),
        texture(
            "first",
            {{"recurrence", 0.02}, {"recurrence_width", 64}, {"edge_loss", 1}, {"edge_gain", 0}, {"novelty", 0.01}}),
        texture("unknown", {})};
    const std::string text = page();
    EXPECT_THAT(text, HasSubstr("Take: First. Good as well: Second. Passes what was measured (lost edges and "
                                "added edges not measured: set compare = true): Uncompared. Rejected (repeats): Copy. "
                                "Rejected (blurs edges): Blend. "
                                "Rejected (adds edges, breaks shapes): Shuffle."));
    EXPECT_THAT(text, HasSubstr("Edges kept; recurs faintly every 64 pixels; shapes whole."));
    EXPECT_THAT(text, HasSubstr("Edges kept; repeats every 512 pixels; shapes whole."));
    EXPECT_THAT(text, HasSubstr("Edges added; nothing recurs; shapes fused or broken."));
    EXPECT_THAT(text, HasSubstr("Edges blurred; nothing recurs; some shapes fused or broken."));
    EXPECT_LT(text.find(R"(<a href="#distribution-6">First</a>)"),
              text.find(R"(<a href="#distribution-5">Second</a>)"));
    EXPECT_LT(text.find(R"(<a href="#distribution-5">Second</a>)"), text.find(R"(<a href="#distribution-1">Copy</a>)"));
    const std::size_t table = text.find("aria-label=\"Numbers of textures\"");
    ASSERT_NE(table, std::string::npos);
    EXPECT_THAT(text.substr(table), HasSubstr(R"(<td class="failed"><data value="1">1.00</data></td>)"));
}

/// Features of more than an eighth of a tile are not called whole, however few patches are new.
TEST_F(DistributionReport, DoesNotCallWideShapesWhole)
{
    const auto texture = [&](const std::string& name, const char* size, double feature) {
        auto json = result(name, "texture");
        json["parameters"] = {{{"key", "exemplar"}, {"value", "pebbles"}}, {{"key", "size"}, {"value", size}}};
        json["numbers"] = nlohmann::json::array();
        for (const auto& [key, value] : {std::pair("recurrence", 0.0), {"novelty", 0.002}, {"feature_side", feature}})
            json["numbers"].push_back({{"key", key}, {"title", key}, {"value", value}, {"meaning", ""}});
        return json;
    };
    json_["distributions"] = {texture("narrow", "64", 9), texture("wide", "128", 9), texture("eighth", "64", 8)};
    const std::string text = page();
    const auto times = [&](const std::string& sentence) {
        int count = 0;
        for (std::size_t at = text.find(sentence); at != std::string::npos; at = text.find(sentence, at + 1)) ++count;
        return count;
    };
    EXPECT_EQ(times("Nothing recurs; some shapes fused or broken."), 1);
    EXPECT_EQ(times("Nothing recurs; shapes whole."), 2);
}

TEST_F(DistributionReport, CallsPackingsPackings)
{
    json_["distributions"] = {result("distribution-packing", "packing")};
    const std::string text = page();
    EXPECT_THAT(text, AllOf(HasSubstr("<section id=\"packings\">"), HasSubstr("1 packing.")));
    EXPECT_THAT(text, AllOf(Not(HasSubstr("<section id=\"textures\">")), Not(HasSubstr("1 texture"))));
}

TEST_F(DistributionReport, RefusesTablesWithCellsMissing)
{
    json_["schemes"] = {result("scheme-noise", "noise")};
    json_["schemes"][0]["tables"][0]["rows"][0]["cells"] = {"1"};
    EXPECT_THAT(message_of([&] { page(); }), HasSubstr("schemes[0].tables[0].rows: must have as many cells each"));
}

/// A window of the plane is no torus.
TEST_F(DistributionReport, SaysWhereSetsLie)
{
    EXPECT_THAT(page(), HasSubstr(" points on the unit torus in 2D"));
    json_["series"][0]["window"] = true;
    EXPECT_THAT(page(), HasSubstr(" points on the unit torus or in windows in 2D"));
    for (auto& series : json_["series"]) series["window"] = true;
    const std::string text = page();
    EXPECT_THAT(text, HasSubstr(" points in windows in 2D"));
    EXPECT_THAT(text, Not(HasSubstr("on the unit torus in")));
}

}
}
