// Small files of regions by hand, one for each way in which programs write them, and their areas.
#include "base/regions/region_text.hpp"
#include "tests/support/corpus.hpp"
#include "tests/support/places.hpp"

#include <gtest/gtest.h>

namespace poissonlab {
namespace {

const std::filesystem::path region_corpus = std::filesystem::path(source_folder()) / "tests/base/regions/files";

/// Polygons and areas.
std::map<std::string, std::vector<double>> right_regions() { return test::right_numbers(region_corpus, 2); }

/// Edges on the globe are off by at most 1e-6 of the longest side, on each of the four sides of regions that are about
/// as wide as high.
TEST(RegionCorpus, HasItsRightAreas)
{
    for (const auto& [file, right] : right_regions()) {
        SCOPED_TRACE(file);
        const bool is_of_globe = file.starts_with("globe/");
        const PlaneRegion region = read_region((region_corpus / file).string(), {.is_planar = !is_of_globe});
        EXPECT_EQ(static_cast<double>(region.polygons.size()), right.at(0));
        EXPECT_NEAR(area_of(region), right.at(1), right.at(1) * (is_of_globe ? 4e-6 : 1e-14));
    }
}

TEST(RegionCorpus, HasAnExpectedAreaForEachFile) { test::expect_numbers_of_all(region_corpus, right_regions()); }

}
}
