// Pictures are drawn again where their input has changed, where they are gone, and only then.
#include "reports/images/picture_store.hpp"

#include "base/files/whole_file.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace poissonlab {
namespace {

class PictureStoreTest : public testing::Test
{
protected:
    /// True if a new store draws the picture.
    bool draws(const std::string& input)
    {
        PictureStore store(folder_.path(), folder_.path() / "keys");
        bool drawn = false;
        store.draw_once({picture_}, input, [&] {
            drawn = true;
            write_whole_file(picture_, "picture of " + input);
        });
        store.save();
        return drawn;
    }

    TemporaryFolder folder_;
    std::filesystem::path picture_ = folder_.path() / "a b.png";
};

TEST_F(PictureStoreTest, DrawsOnceForAnInput)
{
    EXPECT_TRUE(draws("one"));
    EXPECT_FALSE(draws("one"));
    EXPECT_TRUE(draws("two"));
    EXPECT_EQ(read_whole_file(picture_), "picture of two");
    EXPECT_FALSE(draws("two"));
    EXPECT_TRUE(draws("one"));
}

TEST_F(PictureStoreTest, DrawsWhatIsGone)
{
    draws("one");
    std::filesystem::remove(picture_);
    EXPECT_TRUE(draws("one"));
}

TEST_F(PictureStoreTest, DrawsWithoutUsableKeys)
{
    draws("one");
    write_whole_file(folder_.path() / "keys", "nonsense\n\n x\n0 a b.png\n");
    EXPECT_TRUE(draws("one"));
    std::filesystem::remove(folder_.path() / "keys");
    EXPECT_TRUE(draws("one"));
}

TEST_F(PictureStoreTest, OneMissingFileOfSeveralIsEnough)
{
    const auto other = folder_.path() / "other.png";
    write_whole_file(picture_, "x");
    {
        PictureStore store(folder_.path(), folder_.path() / "keys");
        store.note({picture_, other}, "one");
        store.save();
    }
    const PictureStore store(folder_.path(), folder_.path() / "keys");
    EXPECT_TRUE(store.is_current({picture_}, "one"));
    EXPECT_FALSE(store.is_current({picture_, other}, "one"));
}

}
}
