// The pair correlation in the report: plots, words, and damaged results.
#include "tests/reports/support/page_text.hpp"
#include "tests/reports/support/report_fixture.hpp"
#include "tests/support/picture.hpp"

#include <gmock/gmock.h>

namespace poissonlab {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

class PairCorrelationReport : public test::ReportFixture
{
protected:
    /// Gives a series a curve of three bins; the largest possible minimum distance of 256 points is 0.06716.
    void add_curve(int series)
    {
        auto& json = json_["series"][series];
        const auto file = json["name"].get<std::string>() + "/pair-correlation.csv";
        write_whole_file(path() / file, "distance,pair_correlation,standard_error,pairs\n"
                                        "0.01,0,0,0\n0.06716,2.25,0.1,9\n0.2,0.98,0.1,90\n");
        json["pair_correlation"] = {{"file", file}};
    }
};

TEST_F(PairCorrelationReport, ShowsPlotsAndWords)
{
    add_curve(0);
    add_curve(1);
    print_ = PrintPictures::drawn;
    const auto text = page();
    EXPECT_THAT(text, HasSubstr("Highest 2.25 at 1.00 of the largest possible minimum distance, 0.06716."));
    for (const char* file :
         {"random/pair-correlation.png", "jittered/pair-correlation.png", "pair-correlation-all.png"})
        EXPECT_GT(test::decode_png(read_whole_file(path() / file)).variance(), 1) << file;
    EXPECT_FALSE(fs::exists(path() / "regular/pair-correlation.png"));
    const auto svg = read_whole_file(path() / "random/pair-correlation.svg");
    EXPECT_THAT(svg, HasSubstr(">distance / largest possible minimum distance<"));
    EXPECT_THAT(svg, HasSubstr(">pair correlation<"));
}

TEST_F(PairCorrelationReport, NoneMeansNoWord)
{
    EXPECT_THAT(page(), Not(HasSubstr("Pair correlation")));
    EXPECT_FALSE(fs::exists(path() / "pair-correlation-all.svg"));
}

TEST_F(PairCorrelationReport, DamagedResultsNameTheMember)
{
    EXPECT_THAT(error_after("pair_correlation",
                            [](auto& json) {
                                json = {{"file", "random/none.csv"}};
                            }),
                HasSubstr("series[0].pair_correlation.file = "));
}

}
}
