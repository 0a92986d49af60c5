// Embedded kernel files and their includes.
#include "host/device/kernel_source.hpp"

#include <gmock/gmock.h>

namespace poissonlab {
namespace {

using ::testing::HasSubstr;

TEST(KernelSource, EmbedsFilesWhole)
{
    const std::string_view text = embedded_kernel_file("kernels/common/philox.clh");
    EXPECT_THAT(text, HasSubstr("0xD2511F53u"));
    EXPECT_TRUE(text.ends_with("}\n"));
    EXPECT_TRUE(embedded_kernel_file("no-such-file.cl").empty());
}

TEST(KernelSource, ReplacesIncludesOnceAndKeepsLineNumbers)
{
    const std::string text = kernel_source("kernels/dart_throwing.cl");
    EXPECT_EQ(text.find("#include \""), std::string::npos);
    const std::size_t first = text.find("uint4 philox(");
    ASSERT_NE(first, std::string::npos);
    EXPECT_EQ(text.find("uint4 philox(", first + 1), std::string::npos);
    EXPECT_THAT(text, HasSubstr("#line 1 \"kernels/common/philox.clh\""));
}

}
}
