// Small files of regions by hand, one for each way in which programs write them, and their areas.
#include "base/files/text_lines.hpp"
#include "base/files/whole_file.hpp"
#include "base/regions/region_text.hpp"
#include "tests/support/places.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <sstream>

namespace poissonlab {
namespace {

namespace fs = std::filesystem;

const fs::path corpus = fs::path(source_folder()) / "tests/base/regions/files";

struct RightRegion
{
    std::string file;
    std::size_t polygons = 0;
    double area = 0;

    bool is_of_globe() const { return file.starts_with("globe/"); }
};

std::vector<RightRegion> right_regions()
{
    const std::string text = read_whole_file(corpus / "right.txt");
    std::vector<RightRegion> regions;
    for (LineReader lines(text); lines.next();) {
        if (lines.line().starts_with('#')) continue;
        std::istringstream words{std::string(lines.line())};
        RightRegion& region = regions.emplace_back();
        words >> region.file >> region.polygons >> region.area;
        EXPECT_TRUE(words) << lines.line();
    }
    return regions;
}

/// Edges on the globe are off by at most 1e-6 of the longest side, on each of the four sides of regions that are about
/// as wide as high.
TEST(RegionCorpus, HasItsRightAreas)
{
    for (const RightRegion& right : right_regions()) {
        SCOPED_TRACE(right.file);
        const PlaneRegion region = read_region((corpus / right.file).string(), {.is_planar = !right.is_of_globe()});
        EXPECT_EQ(region.polygons.size(), right.polygons);
        EXPECT_NEAR(area_of(region), right.area, right.area * (right.is_of_globe() ? 4e-6 : 1e-14));
    }
}

TEST(RegionCorpus, HasAnExpectedAreaForEachFile)
{
    std::set<std::string> known, found;
    for (const RightRegion& right : right_regions()) known.insert(right.file);
    for (const auto& file : fs::recursive_directory_iterator(corpus))
        if (file.is_regular_file() && file.path().filename() != "right.txt")
            found.insert(fs::relative(file.path(), corpus).string());
    EXPECT_EQ(found, known);
}

}
}
