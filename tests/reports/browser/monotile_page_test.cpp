// The page of hats and spectres in a real browser, from disk: its points are those of runtime/monotile_points.h, and
// its tiles cover the plane. Needs Chromium.
#include "reports/engine/monotile_page.hpp"

#include "base/files/whole_file.hpp"
#include "host/settings/tilings/polygon_tiling_file.hpp"
#include "tests/support/browser.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/places.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tiles/poisson/monotile_points_file.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <map>

namespace poissonlab {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

std::string monotile_page_of(const std::string& bytes, const std::string& word)
{
    std::vector<std::array<std::int64_t, 4>> outline;
    for (const RingPlace& corner : built_in_tiling(word).prototiles[0].corners)
        outline.push_back({corner.c[0], corner.c[1], corner.c[2], corner.c[3]});
    return render_monotile_page(bytes, word + ".ptiles", outline);
}

class MonotilePage : public testing::TestWithParam<std::string>
{
protected:
    MonotilePage()
    {
        write_whole_file(page(), monotile_page_of(bytes_, GetParam()));
        browser_.resize(1000, 900);
    }

    std::filesystem::path page() const { return folder_.path() / "a page.html"; }

    void open(const std::string& fragment = {})
    {
        browser_.open(page(), fragment);
        EXPECT_THAT(browser_.messages(), IsEmpty());
        EXPECT_THAT(browser_.requests(), IsEmpty());
    }

    /// The points of a window, as the page has them and as the header has them.
    nlohmann::json shown() { return evaluate("windowPoints(seenWindow()).map(p => [...p.position, p.id, p.level])"); }
    nlohmann::json expected(std::uint32_t seed, double density)
    {
        const auto window = evaluate("seenWindow()");
        nlohmann::json all = nlohmann::json::array();
        for (const pmono_point& p :
             file_.in_window(seed, {window[0], window[1]}, {0, 0}, {window[2], window[3]}, density))
            all.push_back({p.position[0], p.position[1], p.id, p.level});
        return all;
    }

    nlohmann::json evaluate(const std::string& script) { return browser_.evaluate(script); }

    std::string bytes_ = read_whole_file(fmt::format("{}/runtime/tile_sets/{}-n4.ptiles", source_folder(), GetParam()));
    MonotilePointsFile file_{bytes_, "a"};
    TemporaryFolder folder_;
    test::Browser browser_;
};

TEST_P(MonotilePage, HasThePointsOfTheHeader)
{
    open();
    EXPECT_GT(shown().size(), 20U);
    EXPECT_EQ(shown(), expected(1, 1));
    open("seed=4000000000&density=0.3&tile=1000000000000,-7&zoom=30");
    EXPECT_EQ(shown(), expected(4'000'000'000, 0.3));
    EXPECT_THAT(evaluate("describe(), byId('command').textContent").get<std::string>(),
                HasSubstr(GetParam() + ".ptiles --window 9999999999"));
    EXPECT_THAT(evaluate("byId('status').textContent").get<std::string>(),
                HasSubstr(" points around 1000000000000, -7"));
    browser_.click("#jump");
    EXPECT_EQ(evaluate("state.tile"), (nlohmann::json{1'001'000'000'000, -7}));
    EXPECT_EQ(shown(), expected(4'000'000'000, 0.3));
}

/// The page draws the points that the view has, however the view was moved there.
TEST_P(MonotilePage, SeesTheSamePointsAfterMoving)
{
    open("tile=-70000000000,123456789012&zoom=25");
    browser_.drag("#view", 0.4, 0.62, 0.5, 0.4);
    browser_.press("ArrowRight");
    const std::string seen = "seenPoints(halves()).map(p => [p.x.toFixed(6), p.y.toFixed(6), p.id]).sort().join(';')";
    const auto kept = evaluate(seen);
    EXPECT_GT(kept.get<std::string>().size(), 1000U);
    EXPECT_EQ(evaluate("kept.key = '', " + seen), kept);
}

/// Each edge of a tile is one of another tile as well, and of no third one.
TEST_P(MonotilePage, DrawsTilesThatFit)
{
    open("tile=123456789,-55");
    const auto tiles = evaluate("tilesIn(state.tile, [-20, -20], [20, 20]).map(t => t.corners.map(c => "
                                "[c[0] + t.at[0], c[1] + t.at[1]]))");
    std::map<std::array<long, 2>, int> edges; // by their middles
    for (const auto& corners : tiles)
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const auto& a = corners[i];
            const auto& b = corners[(i + 1) % corners.size()];
            const std::array<double, 2> middle{(a[0].get<double>() + b[0].get<double>()) / 2,
                                               (a[1].get<double>() + b[1].get<double>()) / 2};
            if (std::abs(middle[0]) < 12 && std::abs(middle[1]) < 12)
                ++edges[{std::lround(middle[0] * 1000), std::lround(middle[1] * 1000)}];
        }
    EXPECT_GT(edges.size(), 100U);
    for (const auto& [middle, count] : edges) EXPECT_EQ(count, 2) << middle[0] << " " << middle[1];
}

TEST_P(MonotilePage, ThinsByRanksAndByABrush)
{
    open("density=0.3");
    EXPECT_EQ(shown(), expected(1, 0.3));
    open();
    const nlohmann::json all = shown();
    evaluate("byId('painting').checked = true, byId('brush').value = 0, byId('brush-size').value = 120");
    browser_.click("#view");
    const nlohmann::json painted = shown();
    EXPECT_LT(painted.size() + 10, all.size());
    EXPECT_GT(painted.size(), 5U);
    for (const auto& point : painted) EXPECT_NE(std::ranges::find(all, point), all.end());
    browser_.click("#clear");
    EXPECT_EQ(shown(), all);
}

INSTANTIATE_TEST_SUITE_P(Tiles, MonotilePage, testing::Values("hat", "spectre"),
                         [](const auto& each) { return each.param; });

TEST(MonotilePages, AreOfFilesThatAreWhole)
{
    EXPECT_THAT(message_of([] { monotile_page_of("nothing", "hat"); }), StartsWith("hat.ptiles: is damaged"));
}

}
}
