// `poissonlab analyze` on a set as another program writes it, to the page in a browser. Needs Chromium.
#include "tests/support/browser.hpp"
#include "tests/support/picture.hpp"
#include "tests/support/program.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <random>

namespace poissonlab {
namespace {

/// Two sets in one file as UTK writes them, separated by lines with # alone: 32 x 32 points, one in each of
/// as many cells, in pixels of a picture of 512 x 512.
std::string two_jittered_sets()
{
    std::mt19937_64 random(1);
    std::string text;
    for (int set = 0; set < 2; ++set) {
        if (set > 0) text += "#\n";
        for (int i = 0; i < 1024; ++i) {
            const auto place = [&](int cell) { return 16 * (cell + std::uniform_real_distribution()(random)); };
            text += fmt::format("{:.6f} {:.6f}\n", place(i % 32), place(i / 32));
        }
    }
    return text;
}

TEST(ForeignSet, IsAPageInABrowser)
{
    const TemporaryFolder folder;
    folder.write("jittered.dat", two_jittered_sets());
    const Outcome outcome = run_program(folder.path(), {"analyze", "jittered.dat", "--domain", "512", "--label",
                                                        "Jittered, by hand", "--set", "analysis.zone_plate=true"});
    ASSERT_EQ(outcome.status, 0) << outcome.error;

    const auto out = folder.path() / "out/Jittered-by-hand";
    const auto series = nlohmann::json::parse(content_of(out / "results.json"))["series"][0];
    EXPECT_EQ(series["points"], 1024);
    EXPECT_EQ(series["realizations"], 2);
    EXPECT_EQ(series["spectrum"]["kind"], "power spectrum estimate");
    const auto page = content_of(out / series["name"].get<std::string>() / "index.html");
    for (const char* words : {"Jittered, by hand", "Power spectrum estimate", "Pair correlation", "Zone plate",
                              "Effective Nyquist", "Error of integrals"})
        EXPECT_THAT(page, testing::HasSubstr(words));

    test::Browser browser;
    browser.open(out / "index.html");
    EXPECT_THAT(browser.messages(), testing::IsEmpty());
    EXPECT_THAT(browser.requests(), testing::IsEmpty());
    EXPECT_GT(test::decode_png(browser.screenshot()).variance(), 100);
}

}
}
