// gnuplot as a child process: both kinds of picture, and clear words when something is wrong.
#include "reports/plots/gnuplot.hpp"

#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/picture.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>

#include <cstdlib>

namespace poissonlab {
namespace {

using testing::HasSubstr;

std::string error_of(const std::vector<GnuplotPicture>& pictures)
{
    return message_of<StorageError>([&] { draw_with_gnuplot(pictures, PrintPictures::drawn); });
}

TEST(Gnuplot, DrawsSvgAndPng)
{
    const TemporaryFolder folder;
    draw_with_gnuplot(
        {{"plot x title " + gnuplot_quoted("it's <x> & ü") + " noenhanced", 300, 200, folder.path() / "a"},
         {"plot x**2", 200, 300, folder.path() / "b"}},
        PrintPictures::drawn);
    const auto svg = read_whole_file(folder.path() / "a.svg");
    EXPECT_TRUE(svg.find("it's &lt;x> &amp; ü") != std::string::npos); // escaped
    EXPECT_TRUE(svg.find("& ü") == std::string::npos);
    const auto picture = test::decode_png(read_whole_file(folder.path() / "b.png"));
    EXPECT_EQ(picture.width, 400);
    EXPECT_EQ(picture.height, 600);
    EXPECT_GT(picture.variance(), 1);
}

/// A PNG of an earlier report must not show something else than the SVG beside it.
TEST(Gnuplot, PrintPicturesStayWhileTheyShowTheSame)
{
    const TemporaryFolder folder;
    const auto png = folder.path() / "a.png";
    const auto draw = [&](const char* commands, PrintPictures print) {
        PictureStore store(folder.path(), folder.path() / "keys.txt");
        draw_with_gnuplot({{commands, 300, 200, folder.path() / "a"}}, print, &store);
        store.save();
    };
    draw("plot x", PrintPictures::none);
    EXPECT_FALSE(std::filesystem::exists(png));
    draw("plot x", PrintPictures::drawn);
    const auto first = read_whole_file(png);
    draw("plot x", PrintPictures::none);
    EXPECT_EQ(read_whole_file(png), first);
    draw("plot x**2", PrintPictures::none);
    EXPECT_FALSE(std::filesystem::exists(png));
}

TEST(Gnuplot, TellsWhatGnuplotSaid)
{
    const TemporaryFolder folder;
    EXPECT_THAT(error_of({{"plot no_such_function(x)", 300, 200, folder.path() / "a"}}), HasSubstr("no_such_function"));
    EXPECT_TRUE(folder.names().empty());
}

TEST(Gnuplot, NamesThePackageWhenMissing)
{
    const TemporaryFolder folder;
    const std::string path = std::getenv("PATH");
    setenv("PATH", folder.path().c_str(), 1);
    const auto message = error_of({{"plot x", 300, 200, folder.path() / "a"}});
    setenv("PATH", path.c_str(), 1);
    EXPECT_THAT(message, HasSubstr("gnuplot-nox"));
}

}
}
