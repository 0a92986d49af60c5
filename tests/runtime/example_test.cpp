// runtime/example.cpp prints the points of a window, and says what is wrong with files.
#include "tests/support/places.hpp"
#include "tests/support/random_tile_set.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <iterator>

namespace poissonlab {
namespace {

/// The output of the example, errors too.
std::string printed(const TemporaryFolder& folder, const std::string& arguments)
{
    const std::string command =
        "cd '" + folder.path().string() + "' && '" + example_file() + "' " + arguments + " > out 2>&1";
    const int status = std::system(command.c_str());
    std::ifstream out(folder.path() / "out");
    return std::string(std::istreambuf_iterator<char>(out), {}) + (status == 0 ? "" : "failed");
}

TEST(Example, PrintsTheWindowAndTheNearestPoint)
{
    PoissonTileSet set = random_tile_set(PoissonTileKind::corner, 2, 1, 2);
    set.points = {16384, 32768, 49152, 0};
    const TemporaryFolder folder;
    write_tile_set_file(folder.path() / "tiles.ptiles", set);
    EXPECT_THAT(printed(folder, "tiles.ptiles -1 0 1.5 0.75"),
                testing::StartsWith("-0.75 0.5 0\n-0.25 0 0\n0.25 0.5 0\n"
                                    "# nearest to -0.25 0.375: -0.25 0, number 1 of the tile (-1, 0), id "));
}

TEST(Example, SaysWhatIsWrong)
{
    const TemporaryFolder folder;
    EXPECT_EQ(printed(folder, "none 0 0 1 1"), "none: shorter than the header of a tile set file\nfailed");
}

}
}
