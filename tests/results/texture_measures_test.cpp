// The catalogue of measures of textures: complete, and as the documentation prints it.
#include "results/texture_measures.hpp"

#include "base/files/whole_file.hpp"
#include "tests/support/places.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <stdexcept>

namespace poissonlab {
namespace {

using testing::HasSubstr;

TEST(TextureMeasures, HaveKeysAndMeaningsOfTheirOwn)
{
    std::set<std::string> keys;
    for (const Measure& row : texture_measures()) {
        EXPECT_TRUE(keys.insert(row.key).second) << row.key;
        EXPECT_FALSE(row.meaning.empty()) << row.key;
    }
}

TEST(TextureMeasures, AreFoundInResults)
{
    DistributionResult result;
    result.numbers = {texture_number("seam_mismatch", 1.25, 0.5)};
    for (const Measure& row : texture_measures()) {
        const auto value = texture_value(row, result);
        EXPECT_EQ(value.has_value(), row.key == "seam_mismatch");
        if (!value) continue;
        EXPECT_EQ(value->value, 1.25);
        EXPECT_EQ(value->standard_error, 0.5);
    }
    EXPECT_THROW(texture_number("seams", 1, {}), std::out_of_range);
}

TEST(TextureMeasures, AreTheTableOfTheDocumentation)
{
    EXPECT_THAT(read_whole_file(std::filesystem::path(source_folder()) / "docs/output-folder.md"),
                HasSubstr("<!-- measures of textures -->\n\n" + texture_measures_table() +
                          "\n<!-- end of measures of textures -->\n"))
        << "docs/output-folder.md must have\n<!-- measures of textures -->\n\n"
        << texture_measures_table() << "\n<!-- end of measures of textures -->";
}

}
}
