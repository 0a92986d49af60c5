// Classes of points by runtime/poisson_tiles.h: what the file says, and files that do not fit together.
#include "tests/support/random_tile_set.hpp"
#include "tiles/poisson/tile_lookup.hpp"
#include "tiles/poisson/tile_set_file.hpp"

#include <gtest/gtest.h>

#include <string>

namespace poissonlab {
namespace {

PoissonTileSet set_with_classes() { return random_class_set(2, {4, 9, 20}); }

/// Returns what the header says of a file.
std::string problem_of(const std::string& bytes)
{
    ptiles_set set{};
    const char* problem = ptiles_open(&set, bytes.data(), bytes.size());
    return problem ? problem : "none";
}

TEST(RuntimeClasses, AreThoseOfTheFile)
{
    for (const PoissonTileSet& made : {set_with_classes(), with_random_ranks(set_with_classes())}) {
        const std::string bytes = encode_tile_set(made);
        ptiles_set set{};
        ASSERT_EQ(ptiles_open(&set, bytes.data(), bytes.size()), nullptr);
        EXPECT_EQ(set.classes, 3U);
        const ptiles_set same = runtime_tiling(made, {}).set;
        for (std::uint32_t point = 0; point < 33; ++point) {
            const std::uint32_t expected = point < 4 ? 0 : point < 13 ? 1 : 2;
            EXPECT_EQ(ptiles_class(&set, point), expected);
            EXPECT_EQ(ptiles_class(&same, point), expected);
        }
        EXPECT_EQ(set.points[7], made.points[7]);
        EXPECT_EQ(set.ranks != nullptr, made.parameters.ranked);
    }
    const std::string plain = encode_tile_set(random_tile_set(PoissonTileKind::corner, 2, 2, 5));
    ptiles_set set{};
    ASSERT_EQ(ptiles_open(&set, plain.data(), plain.size()), nullptr);
    EXPECT_EQ(set.classes, 0U);
    EXPECT_EQ(ptiles_class(&set, 3), 0U);
}

TEST(RuntimeClasses, ThatDoNotFitAreRefused)
{
    std::string bytes = encode_tile_set(set_with_classes());
    const std::size_t numbers = bytes.size() - 3 * 4 - 6 * 16; // of points of each class
    EXPECT_EQ(problem_of(bytes), "none");
    EXPECT_EQ(problem_of(bytes.substr(0, bytes.size() - 8)), "too short or too long for its points");
    bytes[numbers] = 5;
    EXPECT_EQ(problem_of(bytes), "classes that have not all points of a tile");
    bytes[numbers] = 4;
    bytes[8] = 4;
    EXPECT_EQ(problem_of(bytes), "an unknown version of the file format");
}

}
}
