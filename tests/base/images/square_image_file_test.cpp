#include "base/images/square_image.hpp"

#include "base/errors/errors.hpp"
#include "tests/support/temporary_folder.hpp"

#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace poissonlab {
namespace {

TEST(SquareImageFile, RoundTrip)
{
    const TemporaryFolder folder;
    const auto path = folder.path() / "plate.exr";
    const SquareImage image{3, {0, 0.25, 0.5, 0.75, 1, 1.25, -0.5, 2, 4}};
    write_square_image(path, image, {{"label", "L"}});
    const auto read = read_square_image(path);
    EXPECT_EQ(read.size, 3);
    EXPECT_EQ(read.pixels, image.pixels);
}

TEST(SquareImageFile, FirstLineIsTheHighestY)
{
    const TemporaryFolder folder;
    const auto path = folder.path() / "plate.exr";
    write_square_image(path, {2, {1, 2, 3, 4}}, {{"label", "L"}});
    Imf::InputFile file(path.c_str());
    const auto* label = file.header().findTypedAttribute<Imf::StringAttribute>("poissonlab:meta:label");
    ASSERT_TRUE(label);
    EXPECT_EQ(label->value(), "L");
    std::vector<float> pixels(4);
    Imf::FrameBuffer frame;
    frame.insert("Y", Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(pixels.data()), 4, 8));
    file.setFrameBuffer(frame);
    file.readPixels(0, 1);
    EXPECT_THAT(pixels, testing::ElementsAre(3, 4, 1, 2));
}

TEST(SquareImageFile, RefusesOtherFiles)
{
    const TemporaryFolder folder;
    EXPECT_THROW(read_square_image(folder.write("a.exr", "no picture")), InputError);
    EXPECT_THROW(read_square_image(folder.path() / "none.exr"), InputError);
    EXPECT_THROW(write_square_image(folder.path() / "none" / "a.exr", {1, {0.5}}, {}), StorageError);
}

}
}
