// poissonlab isohedral: what its commands print, draw and refuse.
#include "tests/support/picture.hpp"
#include "tests/support/program.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace poissonlab {
namespace {

using testing::HasSubstr;

class IsohedralCommand : public testing::Test
{
protected:
    Outcome run(const std::vector<std::string>& words) const
    {
        std::vector<std::string> all{"isohedral"};
        all.insert(all.end(), words.begin(), words.end());
        return run_program(folder_.path(), all);
    }

    void expect_error(const std::vector<std::string>& words, const std::string& message) const
    {
        const Outcome outcome = run(words);
        EXPECT_EQ(outcome.status, 2);
        EXPECT_EQ(outcome.error, "poissonlab: error: " + message + "\n");
    }

    TemporaryFolder folder_;
};

TEST_F(IsohedralCommand, ListsAllTypes)
{
    const Outcome outcome = run({"list", "--json"});
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    const auto types = nlohmann::json::parse(outcome.out);
    ASSERT_EQ(types.size(), 93U);
    EXPECT_EQ(types[15]["ih"], 16);
    EXPECT_EQ(types[15]["symbol"], "a+b+c+c-b-a-;a-c+b+");
    EXPECT_EQ(types[15]["topology"], "3^6");
    EXPECT_EQ(types[15]["aspects"], 3);
    EXPECT_EQ(types[15]["parameters"], 1);
    EXPECT_EQ(types[15]["marked"], false);
    EXPECT_EQ(types[18]["marked"], true);
    EXPECT_THAT(run({"list"}).out, HasSubstr("IH16  3^6         a+b+c+c-b-a-;a-c+b+"));
}

TEST_F(IsohedralCommand, DrawsTilings)
{
    EXPECT_EQ(run({"draw", "16", "--parameters", "0.3", "--window", "6", "4", "--out", "a.png"}).status, 0);
    const test::Picture picture = test::decode_png(content_of(folder_.path() / "a.png"));
    EXPECT_EQ(picture.width, 2 * 6 * 32);
    EXPECT_EQ(picture.height, 2 * 4 * 32);
    EXPECT_GT(picture.variance(), 100);
    EXPECT_EQ(run({"draw", "IH1", "--curve", "0.3,0.2 0.7,-0.1", "--curve", "0.5,0.1", "--out", "b.svg"}).status, 0);
    EXPECT_THAT(content_of(folder_.path() / "b.svg"), HasSubstr("<svg"));
    for (const char* file : {"c.svg", "d.svg"})
        EXPECT_EQ(run({"draw", "28", "--random", "--seed", "5", "--out", file}).status, 0);
    EXPECT_EQ(content_of(folder_.path() / "c.svg"), content_of(folder_.path() / "d.svg"));
}

TEST_F(IsohedralCommand, WrongArguments)
{
    expect_error({"draw", "94", "--out", "a.png"}, "isohedral draw: TYPE 94: must be an integer from 1 to 93, or all");
    expect_error({"draw", "16", "--out", "a.jpg"}, "isohedral draw: --out a.jpg: must end in .svg or .png");
    expect_error({"draw", "16", "--parameters", "1,2", "--out", "a.png"},
                 "isohedral draw: --parameters 1,2: must be as many as IH16 has: 1; the comma of \"1,2\" is no "
                 "decimal point: must be 1.2");
    expect_error({"draw", "16", "--parameters", "x", "--out", "a.png"},
                 "isohedral draw: --parameters x: \"x\" is not a number");
    expect_error({"draw", "16", "--curve", "0.5", "--out", "a.png"},
                 "isohedral draw: --curve 0.5: must be points, two numbers each");
    expect_error({"draw", "20", "--curve", "0.5,0", "--curve", "0.5,0", "--out", "a.png"},
                 "isohedral draw: --curve: IH20 has 1 curves, not 2");
    expect_error({"draw", "16", "--window", "0", "4", "--out", "a.png"},
                 "isohedral draw: --window 0 4: must be W H, each from 1 to 200");
    expect_error({"draw", "16", "--random", "--parameters", "0.1", "--out", "a.png"},
                 "isohedral draw: --random: cannot be combined with --parameters and --curve");
}

}
}
