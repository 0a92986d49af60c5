// PNG files come back pixel for pixel.
#include "base/images/grey_image.hpp"

#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"
#include "tests/support/picture.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace poissonlab {
namespace {

TEST(GreyImage, ComesBackAsItWas)
{
    GreyImage image(17, 9, 0);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = static_cast<std::uint8_t>(i * 5);
    const TemporaryFolder folder;
    write_png(folder.path() / "a.png", image);
    const auto picture = test::decode_png(read_whole_file(folder.path() / "a.png"));
    EXPECT_EQ(picture.width, 17);
    EXPECT_EQ(picture.height, 9);
    EXPECT_EQ(picture.grey, image.pixels);
    EXPECT_EQ(folder.names().size(), 1);
}

TEST(GreyImage, SaysWhereItCannotWrite)
{
    const TemporaryFolder folder;
    EXPECT_THROW(write_png(folder.path() / "missing" / "a.png", GreyImage(2, 2, 0)), StorageError);
}

}
}
