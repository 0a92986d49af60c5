// Base64 and links.
#include "reports/pages/embedding.hpp"

#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace poissonlab {
namespace {

TEST(Embedding, Base64TestVectorsOfRfc4648)
{
    EXPECT_EQ(base64(""), "");
    EXPECT_EQ(base64("f"), "Zg==");
    EXPECT_EQ(base64("fo"), "Zm8=");
    EXPECT_EQ(base64("foo"), "Zm9v");
    EXPECT_EQ(base64("foob"), "Zm9vYg==");
    EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
    EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
    EXPECT_EQ(base64("\xff\xfe\xfd"), "//79");
}

TEST(Embedding, DataUrisNameTheType)
{
    const TemporaryFolder folder;
    EXPECT_EQ(data_uri(folder.write("a.svg", "foo")), "data:image/svg+xml;base64,Zm9v");
    EXPECT_EQ(data_uri(folder.write("a.png", "foo")), "data:image/png;base64,Zm9v");
}

TEST(Embedding, LinksAreRelativeAndEncoded)
{
    const TemporaryFolder folder;
    const auto& base = folder.path();
    EXPECT_EQ(relative_link(base, base / "a" / "b.png"), "a/b.png");
    EXPECT_EQ(relative_link(base / "out", base / "run" / "b.png"), "../run/b.png");
    EXPECT_EQ(relative_link(base, base / "a b#1?%\"<é>.png"), "a%20b%231%3F%25%22%3C%C3%A9%3E.png");
    EXPECT_EQ(relative_link(base, base / "javascript:x"), "javascript%3Ax");
}

}
}
