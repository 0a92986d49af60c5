// Iterations in the report: which plots there are, what their axes say, and damaged results.
#include "reports/plots/series_plots.hpp"
#include "results/series.hpp"
#include "tests/reports/support/page_text.hpp"
#include "tests/reports/support/report_fixture.hpp"
#include "tests/support/picture.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

namespace poissonlab {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

/// Gives a series so many iterations: a relative radius from 0.1 to 0.7, an energy from 0.3 to 0.17.
void add_iterations(const fs::path& folder, nlohmann::json& series, int iterations)
{
    std::vector<double> radius;
    std::vector<double> energy;
    for (int i = 0; i <= iterations; ++i) {
        const double share = static_cast<double>(i) / std::max(1, iterations);
        radius.push_back(0.1 + 0.6 * share);
        energy.push_back(0.3 - 0.13 * share);
    }
    const auto spread = [](const std::vector<double>& values) {
        return nlohmann::json{{"min", values}, {"mean", values}, {"max", values}};
    };
    const auto file = series["name"].get<std::string>() + "/iterations.csv";
    std::vector<IterationRecord> records;
    for (std::size_t i = 0; i < radius.size(); ++i) records.push_back({radius[i], energy[i]});
    write_whole_file(folder / file, iterations_csv({records, records}));
    series["iterations"] = {{"file", file},
                            {"realizations", std::vector<int>(radius.size(), 2)},
                            {"relative_radius", spread(radius)},
                            {"energy", spread(energy)}};
}

class IterationReport : public test::ReportFixture
{
};

TEST_F(IterationReport, PlotsSeriesThatHaveThemAndAllOfThese)
{
    add_iterations(path(), json_["series"][0], 20);
    add_iterations(path(), json_["series"][1], 16);
    print_ = PrintPictures::drawn;
    const auto text = page();
    EXPECT_THAT(text, HasSubstr("<b>Relative radius over iterations.</b>"));
    EXPECT_THAT(text, HasSubstr("From 0.1000 to 0.7000 in 16 iterations. Mean over 2 sets"));
    EXPECT_THAT(text, HasSubstr("From 0.3000 to 0.1700 in 20 iterations."));
    EXPECT_THAT(text, HasSubstr("<b>Energy</b> over iterations."));
    EXPECT_EQ(test::count_of(text, "<figcaption>"), 3 * 7 + 2 * 2 + 2 * (3 + 2) + 3 * 4)
        << "overlays are on two pages, and the overview has four pictures of each series";
    for (const char* file :
         {"random/relative-radius", "random/energy", "jittered/energy", "relative-radius-all", "energy-all"}) {
        const auto png = read_whole_file(path() / (std::string(file) + ".png"));
        EXPECT_GT(test::decode_png(png).variance(), 1) << file;
        EXPECT_THAT(svg(std::string(file) + ".svg"), HasSubstr(">iterations<")) << file;
    }
    EXPECT_THAT(svg("relative-radius-all.svg"), HasSubstr(">relative radius<"));
    EXPECT_THAT(svg("energy-all.svg"), HasSubstr(">hexagonal lattice<"));
    EXPECT_FALSE(fs::exists(path() / "regular/energy.svg"));
}

TEST_F(IterationReport, ManyIterationsHaveALogarithmicAxis)
{
    add_iterations(path(), json_["series"][0], 1000);
    const auto text = page();
    const auto plot = svg("random/relative-radius.svg");
    EXPECT_THAT(plot, HasSubstr(">iterations (logarithmic)<"));
    for (const char* tick :
         {"> 0</tspan>", ">0</tspan>", ">1</tspan>", ">10</tspan>", ">100</tspan>", ">1,000</tspan>"})
        EXPECT_THAT(plot, HasSubstr(tick));
    EXPECT_FALSE(fs::exists(path() / "relative-radius-all.svg")) << "the only series that has iterations";
    EXPECT_THAT(text, Not(HasSubstr("<b>Energy</b> over iterations.")));
}

TEST_F(IterationReport, NoneMeansNoWord) { EXPECT_THAT(page(), Not(HasSubstr("iterations"))); }

TEST_F(IterationReport, MethodsThatStopAtOnceHaveAPoint)
{
    add_iterations(path(), json_["series"][0], 0);
    EXPECT_THAT(page(), HasSubstr("From 0.1000 to 0.1000 in 0 iterations."));
    EXPECT_THAT(svg("random/energy.svg"), HasSubstr("<use xlink:href='#gpPt6'"));
}

TEST_F(IterationReport, SaysHowManySetsWentOn)
{
    add_iterations(path(), json_["series"][0], 2);
    json_["series"][0]["iterations"]["realizations"] = {2, 2, 1};
    EXPECT_THAT(page(), HasSubstr("1 of them went on to the end, and means are over those that did."));
}

TEST_F(IterationReport, IsTheSameEveryTime)
{
    add_iterations(path(), json_["series"][0], 5000);
    const auto first = page();
    const auto plot = svg("random/energy.svg");
    EXPECT_EQ(page(), first);
    EXPECT_EQ(svg("random/energy.svg"), plot);
    EXPECT_LT(plot.size(), 100'000U) << "points that nobody sees are left out";
}

TEST_F(IterationReport, DamagedResultsNameTheMember)
{
    add_iterations(path(), json_["series"][0], 3);
    const auto error_of = [&](auto damage) { return error_after("iterations", damage); };
    EXPECT_THAT(error_of([](auto& json) { json["file"] = "random/none.csv"; }),
                HasSubstr("series[0].iterations.file = "));
    EXPECT_THAT(error_of([](auto& json) { json.erase("energy"); }),
                HasSubstr("series[0].iterations.energy: is missing"));
    EXPECT_THAT(error_of([](auto& json) { json["energy"]["mean"].erase(0); }),
                HasSubstr("series[0].iterations.energy.mean: must have a number for each iteration"));
    EXPECT_THAT(error_of([](auto& json) { json["realizations"] = nlohmann::json::array(); }),
                HasSubstr("series[0].iterations.realizations: must have a number for each iteration"));
}

/// The second moments by numerical integration: the mean of |x|^2 over the Voronoi cell of the lattice.
TEST(LeastEnergy, IsThatOfTheBestLattices)
{
    // Hexagonal, spacing 1, area sqrt 3 / 2 a point: twelve right triangles with legs 1/2 and 1/2 tan 30.
    const double t = 0.5 / std::numbers::sqrt3;
    const double moment = 12 * (0.5 * 0.5 * 0.5 * t / 4 + 0.5 * t * t * t / 12);
    const double area = std::numbers::sqrt3 / 2;
    EXPECT_NEAR(least_energy(2), moment / area / area, 1e-12); // times N^(2/2)

    // Body-centred cubic: cube corners and centres, volume 1/2 a point. Midpoint rule over the cube.
    constexpr int n = 200;
    double sum = 0;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
            for (int k = 0; k < n; ++k) {
                double corner = 0;
                double centre = 0;
                for (const int c : {i, j, k}) {
                    const double x = (c + 0.5) / n;
                    corner += std::pow(std::min(x, 1 - x), 2);
                    centre += std::pow(x - 0.5, 2);
                }
                sum += std::min(corner, centre);
            }
    EXPECT_NEAR(least_energy(3), sum / (n * n * n) * std::pow(2.0, 2.0 / 3), 1e-5);
}

}
}
