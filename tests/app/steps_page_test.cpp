// Pages that show constructions step by step, in a real browser: steps, play and pause, by mouse and by keyboard. Needs
// Chromium.
#include "tests/support/browser.hpp"
#include "tests/support/program.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <thread>

namespace poissonlab {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

class StepsPage : public testing::Test
{
protected:
    static void SetUpTestSuite()
    {
        folder_ = std::make_unique<TemporaryFolder>();
        folder_->write("c.toml", "engine = \"reference\"\n"
                                 "[[construction]]\nkind = \"set\"\nshow = \"dart-throwing\"\npoints = 40\n"
                                 "[[construction]]\nkind = \"set\"\nshow = \"lloyd\"\npoints = 40\niterations = 6\n"
                                 "[[construction]]\nshow = \"edge\"\npoints_per_tile = 16\nrelative_radius = 0.6\n");
        const Outcome outcome = run_program(folder_->path(), {"run", "c.toml", "--out", "out", "--quiet"});
        ASSERT_EQ(outcome.status, 0) << outcome.error;
        browser_ = std::make_unique<test::Browser>();
    }
    static void TearDownTestSuite()
    {
        browser_.reset();
        folder_.reset();
    }

    static void open(const std::string& construction)
    {
        browser_->open(folder_->path() / "out" / construction / "steps.html");
    }
    static std::string caption()
    {
        return browser_->evaluate("document.getElementById('caption').textContent").get<std::string>();
    }
    static int count(const std::string& selector)
    {
        return browser_->evaluate("document.querySelectorAll('" + selector + "').length").get<int>();
    }

    inline static std::unique_ptr<TemporaryFolder> folder_;
    inline static std::unique_ptr<test::Browser> browser_;
};

TEST_F(StepsPage, GoesThroughTheStoredSteps)
{
    open("construction-set-dart-throwing");
    const json stored =
        json::parse(content_of(folder_->path() / "out/construction-set-dart-throwing/construction.json"));
    const auto& panels = stored["panels"];
    EXPECT_THAT(caption(), HasSubstr("There is no point yet."));
    EXPECT_EQ(count(".dot"), 0);
    browser_->click("#forward");
    EXPECT_THAT(caption(), StartsWith("1 of " + std::to_string(panels.size() - 1) + ": Dart 1 becomes point 1."));
    EXPECT_EQ(count(".dot.inner"), 1);
    browser_->click("#last");
    EXPECT_THAT(caption(), HasSubstr(panels.back()["caption"].get<std::string>()));
    EXPECT_EQ(count(".dot"), 40);
    // The dots lie where the stored places are, y upwards.
    const json first = browser_->evaluate("[...document.querySelectorAll('.dot')].map(d => "
                                          "[Number(d.getAttribute('cx')), 65536 - Number(d.getAttribute('cy'))])");
    std::set<std::vector<int>> shown, expected;
    for (const auto& place : first) shown.insert(place.get<std::vector<int>>());
    for (const char* kind : {"held", "inner"}) {
        const auto places = panels.back()["points"].value(kind, std::vector<int>{});
        for (std::size_t i = 0; i < places.size(); i += 2) expected.insert({places[i], places[i + 1]});
    }
    EXPECT_EQ(shown, expected);
    browser_->click("#back");
    EXPECT_THAT(caption(), StartsWith(std::to_string(panels.size() - 2) + " of "));
    browser_->click("#first");
    EXPECT_THAT(caption(), StartsWith("0 of "));
    EXPECT_THAT(browser_->messages(), IsEmpty());
    EXPECT_THAT(browser_->requests(), IsEmpty());
}

TEST_F(StepsPage, PlaysAndPauses)
{
    open("construction-set-lloyd");
    EXPECT_THAT(caption(), StartsWith("0 of 6: Random points"));
    browser_->evaluate("document.getElementById('speed').value = '25'");
    browser_->click("#play");
    EXPECT_EQ(browser_->evaluate("document.getElementById('play').textContent"), "pause");
    for (int i = 0; i < 100 && !caption().starts_with("6 of 6"); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    EXPECT_THAT(caption(), StartsWith("6 of 6: After 6 iterations"));
    EXPECT_EQ(browser_->evaluate("document.getElementById('play').textContent"), "play") << "it ends at the last step";
    EXPECT_EQ(count(".way"), 40) << "lines from where points came";
    browser_->evaluate("document.getElementById('speed').value = '1'");
    browser_->click("#play");
    browser_->click("#play");
    EXPECT_THAT(caption(), StartsWith("0 of 6")) << "paused before the first step";
    EXPECT_THAT(browser_->messages(), IsEmpty());
}

TEST_F(StepsPage, IsReachedByTheKeyboardAlone)
{
    open("construction-corner-edge");
    browser_->evaluate("document.getElementById('place').focus()");
    browser_->press("ArrowRight");
    EXPECT_THAT(caption(), StartsWith("1 of "));
    EXPECT_EQ(count("#stage img"), 1) << "stages of tiles are pictures with their regions";
    EXPECT_GT(browser_->evaluate("document.querySelector('#stage img').naturalWidth").get<int>(), 0);
    browser_->press("End");
    EXPECT_EQ(browser_->evaluate("document.getElementById('last').disabled"), true);
    browser_->press("Home");
    EXPECT_THAT(caption(), StartsWith("0 of "));
    EXPECT_THAT(browser_->messages(), IsEmpty());
}

TEST_F(StepsPage, IsLinkedFromThePictures)
{
    const std::string page = content_of(folder_->path() / "out/index.html");
    for (const char* name : {"construction-set-dart-throwing", "construction-set-lloyd", "construction-corner-edge"})
        EXPECT_THAT(page, HasSubstr(std::string(name) + "/steps.html"));
}

}
}
