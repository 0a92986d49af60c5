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
