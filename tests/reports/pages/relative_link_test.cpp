#include "reports/pages/page_frame.hpp"

#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace poissonlab {
namespace {

TEST(RelativeLink, IsRelativeAndEncoded)
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
