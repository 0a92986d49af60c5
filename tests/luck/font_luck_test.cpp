// A machine without fonts: pictures with letters are not drawn without them, and can be drawn later.
#include "tests/luck/bad_luck.hpp"

namespace poissonlab {
namespace {

using FontLuck = BadLuck;

TEST_F(FontLuck, IsSaidInOneLineAndMendedByReport)
{
    write_config("figure.toml", "[[construction]]\nkind = \"corner\"\nshow = \"regions\"\ncolors = 4\n"
                                "points_per_tile = 12\nrelative_radius = 0.7\n");
    folder_.write("no-fonts.conf", "<?xml version=\"1.0\"?><fontconfig><dir>/proc/none</dir></fontconfig>");
    const std::string no_fonts = "FONTCONFIG_FILE=" + quoted(path("no-fonts.conf").string());
    expect_one_line(run("out", no_fonts, "figure.toml"), 1, "install the package fonts-dejavu-core");
    EXPECT_TRUE(std::filesystem::exists(path("out") / "results.json"));
    EXPECT_THAT(left_over(path("out")), ::testing::IsEmpty());

    EXPECT_EQ(run_program(folder_.path(), {"report", "out", "--quiet"}).status, 0);
    ASSERT_EQ(run("plain", "", "figure.toml").status, 0);
    EXPECT_EQ(lasting_files(path("out")), lasting_files(path("plain")));
}

}
}
