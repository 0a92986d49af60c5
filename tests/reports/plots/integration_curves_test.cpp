// Which series make a curve of integration errors against N, and what the plot shows.
#include "reports/plots/series_plots.hpp"

#include "base/files/whole_file.hpp"
#include "reports/layout/series_curves.hpp"
#include "reports/plots/gnuplot_text.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>

#include <deque>

namespace poissonlab {
namespace {

using testing::ElementsAre;

/// Series of one run; the report would read the rest.
class IntegrationCurves : public testing::Test
{
protected:
    void add(const std::string& sampler, const std::string& label, const std::string& parameter, std::size_t points,
             double error)
    {
        Series series;
        series.sampler = sampler;
        series.label = label;
        series.parameters = {{"points", std::to_string(points)}, {"rho", parameter}};
        series.points = points;
        series.measures.integration = {{"disk", 0, error, error / 10, 1}, {"step", 0, 2 * error, 0, 1}};
        stored_.push_back(series);
    }

    std::vector<IntegrationCurve> curves()
    {
        std::deque<ReportSeries> series;
        SeriesList list;
        for (const auto& stored : stored_) {
            ReportSeries& entry = series.emplace_back();
            entry.run = &run_;
            entry.stored = &stored;
            list.push_back({&entry, stored.label});
        }
        return integration_curves(list);
    }

    poissonlab::Run run_;
    std::vector<Series> stored_;
};

TEST_F(IntegrationCurves, JoinSeriesThatDifferOnlyInSize)
{
    add("random", "Random, N = 1,024", "", 1024, 0.01);
    add("random", "Random, N = 64", "", 64, 0.1);
    add("darts", "Darts, N = 64, rho = 0.7", "0.7", 64, 0.05);
    add("darts", "Darts, N = 256, rho = 0.7", "0.7", 256, 0.02);
    const auto all = curves();
    ASSERT_EQ(all.size(), 4);
    EXPECT_EQ(all[0].label, "Random");
    EXPECT_EQ(all[0].integrand, "disk");
    EXPECT_EQ(all[0].index, 0);
    ASSERT_EQ(all[0].samples.size(), 2);
    EXPECT_EQ(all[0].samples[0].points, 64) << "N grows";
    EXPECT_EQ(all[0].samples[0].rms_error, 0.1);
    EXPECT_EQ(all[0].samples[0].standard_error, 0.01);
    EXPECT_EQ(all[1].integrand, "step");
    EXPECT_EQ(all[1].samples[1].rms_error, 0.02);
    EXPECT_EQ(all[2].label, "Darts, rho = 0.7");
    EXPECT_EQ(all[2].index, 1);
    EXPECT_THAT(integrands_of(all), ElementsAre("disk", "step"));
}

TEST_F(IntegrationCurves, KeepOtherSeriesApart)
{
    add("darts", "Darts, N = 64, rho = 0.7", "0.7", 64, 0.1);
    add("darts", "Darts, N = 256, rho = 0.8", "0.8", 256, 0.1);
    add("random", "Random, N = 64", "", 64, 0.1);
    EXPECT_TRUE(curves().empty()) << "none has two sizes";
}

TEST_F(IntegrationCurves, AreDrawnWithBothAxes)
{
    add("random", "Random, N = 64", "", 64, 0.1);
    add("random", "Random, N = 256", "", 256, 0.05);
    add("exact", "Exact, N = 64", "", 64, 0);
    add("exact", "Exact, N = 256", "", 256, 0);
    const TemporaryFolder folder;
    draw_with_gnuplot({gnuplot_picture(integration_error_plot(curves(), "disk"), folder.path() / "all")},
                      PrintPictures::none);
    const auto svg = read_whole_file(folder.path() / "all.svg");
    for (const char* text : {">number of points N<", ">RMS error of the integral<", ">Random<", ">Exact<"})
        EXPECT_THAT(svg, testing::HasSubstr(text)) << "errors of 0 do not stop the plot";
}

}
}
