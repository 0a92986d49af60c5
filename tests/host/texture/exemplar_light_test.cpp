// Exemplars of floating-point numbers as the 8 bits by which tiles are chosen and cut.
#include "base/images/float_image.hpp"
#include "host/texture/exemplar.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace poissonlab {
namespace {

using testing::HasSubstr;

/// Light above 1 makes all light be tone-mapped, v becoming v (1 + v / 16) / (1 + v) where 4 is the brightest; without
/// it light stays as it is.
TEST(ExemplarLight, ToneMapsLightThatIsBrighterThanWhite)
{
    const TemporaryFolder folder;
    FloatImage image;
    image.width = image.height = 2;
    image.channels["Y"] = {-3, 0.5f, 1, 4};
    write_float_image(folder.path() / "bright.exr", image);
    std::string note;
    EXPECT_THAT(read_exemplar(folder.path() / "bright.exr", note).values, testing::ElementsAre(0, 158, 193, 255));
    EXPECT_EQ(note,
              "bright.exr: light up to 4 is tone-mapped and negative numbers, down to -3, count as 0 where tiles are "
              "chosen and cut");
    image.channels["Y"] = {0, 0.25f, 1, 1};
    write_float_image(folder.path() / "plain.exr", image);
    EXPECT_THAT(read_exemplar(folder.path() / "plain.exr", note).values, testing::ElementsAre(0, 137, 255, 255));
    EXPECT_EQ(note, "");
    image.channels["Y"][2] = std::numeric_limits<float>::quiet_NaN();
    write_float_image(folder.path() / "plain.exr", image);
    EXPECT_THAT(message_of([&] { read_exemplar(folder.path() / "plain.exr"); }),
                HasSubstr("the pixel in column 0, row 1 is not a finite number"));
}

}
}
