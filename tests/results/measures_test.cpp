// The catalogue of measures.
#include "results/measures.hpp"

#include "base/files/whole_file.hpp"
#include "tests/support/places.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <set>
#include <stdexcept>

namespace poissonlab {
namespace {

using testing::HasSubstr;

TEST(Catalogue, HasEachKeyAndEachNameOnce)
{
    std::set<std::string> keys, names;
    for (const Measure& row : measures()) {
        EXPECT_TRUE(keys.insert(row.key).second) << row.key;
        EXPECT_TRUE(names.insert(row.name).second) << row.name;
        EXPECT_TRUE(row.get) << row.key;
        EXPECT_EQ(&measure(row.key), &row);
    }
    EXPECT_THROW(measure("clumpiness"), std::out_of_range);
}

TEST(Catalogue, SaysWhatWasNotMeasured)
{
    const Series nothing;
    for (const Measure& row : measures())
        EXPECT_EQ(row.get(nothing).has_value(), row.key == "points" || row.key == "realizations") << row.key;
}

TEST(Catalogue, NamesExponentsOfPowerLawsOnly)
{
    const auto said = [](double exponent, double error, bool in_region) {
        Series series;
        series.measures.numbers["hyperuniformity_exponent"] = {exponent, error};
        series.measures.low_frequency_power = LowFrequencyPower{.exponent = exponent, .exponent_standard_error = error};
        if (in_region) series.region.emplace();
        const bool is_said = measure("hyperuniformity_exponent").get(series).has_value();
        EXPECT_EQ(measure("low_frequency_exponent").get(series).has_value(), is_said) << exponent;
        return is_said;
    };
    EXPECT_TRUE(said(1.9, 0.02, false));
    EXPECT_TRUE(said(-0.05, 0.02, false)); // level, as random points have it
    EXPECT_FALSE(said(-1.84, 0.02, false));
    EXPECT_FALSE(said(1.9, 0.02, true));
}

/// Sets of 1,000 random points have mean nearest distances with a standard deviation of 1.65 %.
TEST(Mixture, IsToldOfWhereSetsDifferFarMoreThanRandomOnes)
{
    const auto said = [](double deviation) {
        Series series;
        series.points = 1000;
        series.realizations = 4;
        series.measures.numbers["mean_nearest_distance"] = {0.8, 0.8 * deviation / 2};
        return mixture_words(series);
    };
    EXPECT_EQ(said(0.06), "");
    EXPECT_THAT(said(0.07), HasSubstr("mean nearest distances is 7 %; sets of random points have 1.7 %"));
    EXPECT_THAT(said(0.0996), HasSubstr("mean nearest distances is 10 %;"));
    EXPECT_THAT(said(1.4), HasSubstr("mean nearest distances is 140 %;"));
    EXPECT_THAT(said(12.34), HasSubstr("mean nearest distances is 1234 %;"));
}

TEST(Catalogue, KnowsAllNumbersThatAreStored)
{
    Measures unknown;
    unknown.numbers["clumpiness"] = {1, {}};
    EXPECT_THROW(measures_text(unknown), std::out_of_range);
    unknown.numbers = {{"oscillation", {1, {}}}};
    EXPECT_THROW(measures_text(unknown), std::logic_error) << "an object";
}

TEST(Catalogue, ErrorsOfIntegralsAreThoseOfTheirSquares)
{
    Series series;
    series.measures.integration = {{"disk", 0.25, 0.01, 0.001, 0.5}};
    const auto value = measure("integration_disk").get(series);
    EXPECT_EQ(value->value, 0.5);
    EXPECT_NEAR(*value->standard_error, 0.1, 1e-15) << "twice the relative error of the root";
    series.measures.integration[0].standard_error = 0;
    EXPECT_FALSE(measure("integration_disk").get(series)->standard_error) << "one set";
}

TEST(Catalogue, IsTheTableOfTheDocumentation)
{
    EXPECT_THAT(read_whole_file(std::filesystem::path(source_folder()) / "docs/output-folder.md"),
                HasSubstr("<!-- measures -->\n\n" + measures_table() + "\n<!-- end of measures -->\n"))
        << "docs/output-folder.md must have\n<!-- measures -->\n\n"
        << measures_table() << "\n<!-- end of measures -->";
}

}
}
