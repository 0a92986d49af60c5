// `poissonlab distribute stipple` and `distribute hatch`: their files, what they say, and what they refuse.
#include "base/images/png_file.hpp"
#include "base/points/point_file.hpp"
#include "tests/support/places.hpp"
#include "tests/support/program.hpp"
#include "tests/support/raw_png.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <regex>

#include <nlohmann/json.hpp>

namespace poissonlab {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class DistributeStipple : public testing::Test
{
protected:
    Outcome run(const std::string& verb, const std::vector<std::string>& arguments) const
    {
        std::vector<std::string> words{"distribute", verb};
        words.insert(words.end(), arguments.begin(), arguments.end());
        return run_program(folder_.path(), words);
    }

    void expect_error(const std::vector<std::string>& arguments, const std::string& message,
                      const std::string& verb = "stipple") const
    {
        std::vector<std::string> words = arguments;
        words.insert(words.end(), {"--out", "out.svg"});
        const Outcome outcome = run(verb, words);
        EXPECT_EQ(outcome.status, 2);
        EXPECT_THAT(outcome.error, HasSubstr(message));
        EXPECT_EQ(std::ranges::count(outcome.error, '\n'), 1) << outcome.error;
        EXPECT_FALSE(std::filesystem::exists(folder_.path() / "out.svg"));
    }

    TemporaryFolder folder_;
    std::string tiles_ = source_folder() + "/runtime/tile_sets/corner-c3-n64-r075.ptiles";
};

/// The ink of a grey picture as a viewer sees it, who decodes it as sRGB (IEC 61966-2-1).
double seen_ink(const std::filesystem::path& file)
{
    const PngPixels png = read_png(file);
    EXPECT_EQ(png.channels, 1);
    double ink = 0;
    for (const std::uint8_t value : png.values) {
        const double v = value / 255.0;
        ink += 1 - (v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4));
    }
    return ink / static_cast<double>(png.values.size());
}

/// x, y and radius of each circle.
std::vector<std::array<double, 3>> circles_of(const std::string& svg)
{
    std::vector<std::array<double, 3>> circles;
    const std::regex circle("<circle cx=\"([0-9.]+)\" cy=\"([0-9.]+)\" r=\"([0-9.]+)\"/>");
    for (std::sregex_iterator at(svg.begin(), svg.end(), circle), end; at != end; ++at)
        circles.push_back({std::stod((*at)[1]), std::stod((*at)[2]), std::stod((*at)[3])});
    return circles;
}

/// Dots of radius r that are cut off at the frame lose 8 r / (3 pi L) of the ink on average; that part varies with some
/// 250 dots there, each by a fifth of its area or so. Rounding of half a million grey pixels by 0.0026 is less.
TEST_F(DistributeStipple, ShowsTheInkThatIsAskedFor)
{
    for (const std::string by : {"warping", "ranks", "gaussian"}) {
        std::vector<std::string> words{"--image", "0.25", "--points", "40000",    "--by",  by,
                                       "--tiles", tiles_, "--out",    "dots.png", "--json"};
        if (by == "gaussian") words.insert(words.end(), {"--iterations", "5"});
        const Outcome outcome = run("stipple", words);
        ASSERT_EQ(outcome.status, 0) << outcome.error;
        const auto said = nlohmann::json::parse(outcome.out);
        const double radius = said.at("mark_width").get<double>() / 2, area = said.at("mark_area").get<double>();
        const double lost = 8 * radius / (3 * std::numbers::pi * 1024), overlap = said.at("overlap").get<double>();
        EXPECT_GE(overlap, 0);
        EXPECT_NEAR(seen_ink(folder_.path() / "dots.png"), 0.25 * (1 - lost) * (1 - overlap),
                    4 * 0.2 * std::sqrt(250) * area / (1024 * 1024))
            << by;
        EXPECT_LT(said.at("tone_error").get<double>(), 0.01) << by;
    }
}

/// sRGB 188 is half of the light: the mean of the pixels that dots cover is half black, in linear light.
TEST_F(DistributeStipple, PrintsAPhotographAsItIs)
{
    std::vector<std::uint8_t> grey(96 * 64, 188);
    write_png(folder_.path() / "photo.png", {96, 64, 1}, [&](int first, int) { return grey.data() + first * 96; });
    const Outcome outcome =
        run("stipple", {"--image", "photo.png", "--points", "300", "--by", "warping", "--ink", "0.8", "--tiles", tiles_,
                        "--out", "dots.svg", "--out", "dots.png", "--out", "dots.npy", "--pixels", "960", "--json"});
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    const auto said = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(said.at("marks"), 300);
    EXPECT_NEAR(said.at("mark_area").get<double>(), 0.8 * 0.497 * 96 * 64 / 300, 0.02); // 188 is 0.503 of the light
    EXPECT_NEAR(said.at("overlap").get<double>(), 0, 1e-9);
    const PointSet points = read_points(folder_.path() / "dots.npy").at(0);
    EXPECT_EQ(points.size(), 300);
    for (std::size_t i = 0; i < points.size(); ++i) EXPECT_LT(points[i][1], 2.0 / 3);
    const PngPixels png = read_png(folder_.path() / "dots.png");
    EXPECT_EQ(png.width, 960);
    EXPECT_EQ(png.height, 640);
    // Some 4 * sqrt(300) dots are at the frame, and half of each beyond it, on average.
    const double ink = 0.8 * 0.497;
    EXPECT_NEAR(seen_ink(folder_.path() / "dots.png"), ink, ink * 4 * std::sqrt(300) / 300 / 2);
    EXPECT_THAT(content_of(folder_.path() / "dots.svg"), HasSubstr("<svg"));
}

TEST_F(DistributeStipple, IsTheSameByBothEngines)
{
    for (const std::string engine : {"opencl", "reference"}) {
        const Outcome outcome = run("hatch", {"--image", "0.2+0.1*x", "--stroke", "4", "--tiles", tiles_, "--engine",
                                              engine, "--out", engine + ".svg", "--out", engine + ".png"});
        ASSERT_EQ(outcome.status, 0) << outcome.error;
        EXPECT_THAT(outcome.out, HasSubstr("strokes, 4 pixels wide; tone error"));
    }
    for (const char* kind : {".svg", ".png"})
        EXPECT_EQ(content_of(folder_.path() / (std::string("opencl") + kind)),
                  content_of(folder_.path() / (std::string("reference") + kind)));
}

/// An opaque quarter of a transparent picture, black all over: all dots are in it.
TEST_F(DistributeStipple, LeavesWhatIsTransparentWhite)
{
    test::RawPng picture{40, 40, 4, 8, std::vector<std::uint16_t>(40 * 40 * 4)};
    for (int row = 20; row < 40; ++row)
        for (int column = 0; column < 20; ++column)
            picture.samples[static_cast<std::size_t>(row * 40 + column) * 4 + 3] = 255;
    test::write_raw_png(folder_.path() / "black.png", picture);
    const Outcome outcome = run("stipple", {"--image", "black.png", "--points", "200", "--by", "warping", "--out",
                                            "dots.npy", "--out", "dots.svg", "--width", "8cm", "--json"});
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_NEAR(nlohmann::json::parse(outcome.out).at("mark_area").get<double>(), 20.0 * 20 / 200, 1e-6);
    const PointSet points = read_points(folder_.path() / "dots.npy").at(0);
    EXPECT_EQ(points.size(), 200U);
    for (const double coordinate : points.coordinates) EXPECT_LE(coordinate, 0.5);
    // The file for plotters has a circle for each point, and all circles lie on the sheet. A disk with the area of two
    // pixels of 2 mm has a radius of 1.596 mm, and margins are twice as wide.
    const std::string svg = content_of(folder_.path() / "dots.svg");
    EXPECT_THAT(svg, HasSubstr("width=\"86.383mm\" height=\"86.383mm\" viewBox=\"0 0 86.383 86.383\""));
    const auto circles = circles_of(svg);
    EXPECT_EQ(circles.size(), 200U);
    for (const auto& [x, y, r] : circles) {
        EXPECT_EQ(r, 1.596);
        EXPECT_GE(std::min(x, y), r);
        EXPECT_LE(std::max(x, y), 86.383 - r);
    }
    // A dot has the area of two of 40 x 40 pixels of 2 mm: 2 sqrt(8 / pi) mm across. The way is that of 200 dots.
    EXPECT_THAT(outcome.error, testing::ContainsRegex(
                                   "the sheet is 86.38 x 86.38 mm, wider than --width for dots at the edges; the "
                                   "pen's way between marks is [0-9.]+ mm \\([0-9]\\.[0-9] m as made\\); dots are 3.19 "
                                   "mm in diameter, which a pen of up to that width draws"));
}

/// Short strokes are as wide as the pen. 200 dots have a quarter of 80 x 80 mm, 8 square millimetres each, of which a
/// pen of 0.5 mm draws pi / 16.
TEST_F(DistributeStipple, SaysHowLittleInkShortStrokesOfAThinPenLeave)
{
    const auto said = [&](const std::vector<std::string>& pen) {
        std::vector<std::string> words{"--image", "0.25", "--points", "200",     "--by",  "warping",
                                       "--width", "8cm",  "--dots",   "strokes", "--out", "dots.svg"};
        words.insert(words.end(), pen.begin(), pen.end());
        return run("stipple", words).out;
    };
    EXPECT_THAT(said({"--pen", "0.5mm"}),
                HasSubstr("dots are 3.19 mm in diameter, but strokes of the pen are 0.5 mm wide and draw 2.5 % of the "
                          "ink: circles draw more of it, and with 8149 dots each dot would be as wide as the pen"));
    EXPECT_THAT(said({}), HasSubstr("dots are 3.19 mm in diameter, as wide as the pen has to be"));
    EXPECT_THAT(said({"--pen", "3.19mm"}), Not(HasSubstr("strokes of the pen")));
}

/// Separations of colours have equal sheets, wherever their dots lie and however many they are: pixels of 2.5 mm, dots
/// of 3 pixels, and margins of 7.5 mm. As their number is whole, n dots differ in area from what is asked for by half
/// of an nth.
TEST_F(DistributeStipple, HasSheetsThatRegister)
{
    std::vector<std::uint8_t> colours(80 * 60 * 3);
    for (std::size_t i = 0; i < colours.size(); ++i)
        colours[i] = static_cast<std::uint8_t>(i % 3 == 0 ? i % 240 : i % 3 == 1 ? i / 240 * 4 : (i * i / 240) % 256);
    write_png(folder_.path() / "colours.png", {80, 60, 3}, [&](int first, int) { return &colours[first * 240]; });
    std::vector<std::string> boxes;
    for (const std::string channel : {"R", "G", "B"})
        for (const std::string by : {"warping", "ranks"}) {
            const std::vector<std::string> words{"--image", "colours.png", "--image-from", channel,
                                                 "--dot",   "3",           "--by",         by,
                                                 "--out",   "dots.svg",    "--json"};
            std::vector<std::string> on_paper = words;
            on_paper.insert(on_paper.end(), {"--width", "200mm"});
            const Outcome outcome = run("stipple", on_paper);
            ASSERT_EQ(outcome.status, 0) << outcome.error;
            const std::string svg = content_of(folder_.path() / "dots.svg");
            EXPECT_THAT(svg, HasSubstr("width=\"215mm\" height=\"165mm\" viewBox=\"0 0 215 165\""));
            const auto said = nlohmann::json::parse(outcome.out);
            const auto circles = circles_of(svg);
            ASSERT_EQ(circles.size(), said.at("marks").get<std::size_t>());
            EXPECT_GT(circles.size(), 100U);
            if (by == "warping") {
                EXPECT_NEAR(circles[0][2], 3.75, 3.75 / 4 / static_cast<double>(circles.size()) + 0.001);
            }
            for (const auto& [x, y, r] : circles) {
                EXPECT_NEAR(r, said.at("mark_width").get<double>() / 2 * 200 / 80, 0.0006); // rounded to 0.001
                EXPECT_TRUE(x >= 7.5 - 0.001 && x <= 207.5 + 0.001 && y >= 7.5 - 0.001 && y <= 157.5 + 0.001) << x;
            }
            ASSERT_EQ(run("stipple", words).status, 0);
            const std::string plain = content_of(folder_.path() / "dots.svg");
            std::smatch box;
            ASSERT_TRUE(std::regex_search(plain, box, std::regex("viewBox=\"[^\"]*\"")));
            boxes.push_back(box[0]);
        }
    EXPECT_THAT(boxes, testing::Each(boxes.front()));
}

TEST_F(DistributeStipple, SaysWhatIsTooDark)
{
    const Outcome outcome =
        run("stipple", {"--image", "x < 0 ? 0.9 : 0.1", "--points", "500", "--by", "ranks", "--out", "dots.txt"});
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_THAT(outcome.out, HasSubstr("50.0 % of the pixels are too dark"));
    EXPECT_THAT(content_of(folder_.path() / "dots.txt"), StartsWith("# domain 0:1\n# poissonlab distribute stipple"));
}

TEST_F(DistributeStipple, RefusesWhatItCannotDo)
{
    expect_error({"--image", "none.png", "--points", "9"}, "distribute stipple: --image: none.png: no such file");
    expect_error({"--image", "2", "--points", "9"},
                 "distribute stipple: image 2: pixel (0, 1023): ink 2: must be from 0");
    expect_error({"--image", "0.5"}, "distribute stipple: needs --points or --dot");
    expect_error({"--image", "0.5", "--dot", "-3"}, "distribute stipple: --dot -3: must be a number from 0.01");
    expect_error({"--image", "0.5", "--dot", "9000"}, "distribute stipple: 0 marks for the ink of");
    expect_error({"--image", "0.5", "--points", "9", "--dot", "3"}, "--points: cannot be combined with --dot");
    expect_error({"--image", "0.5", "--points", "9", "--ink", "1.5"}, "--ink 1.5: must be a number from 0.001 to 1");
    expect_error({"--image", "0.5", "--points", "9", "--by", "rank"},
                 "--by rank: must be one of \"gaussian\", \"warping\", \"ranks\"");
    expect_error({"--image", "0.5", "--points", "9", "--by", "ranks", "--method", "random"},
                 "--method random: cannot be combined with --by ranks");
    expect_error({"--image", "0.5", "--points", "9", "--by", "ranks", "--iterations", "3"},
                 "--iterations 3: is for --by gaussian");
    expect_error({"--image", "0.5", "--points", "9", "--pixels", "40000"},
                 "--pixels 40000: must be an integer from 1 to 32768 ");
    expect_error({"--image", "0.5", "--points", "9", "--slenderness", "0"}, "--slenderness 0: must be a number from 1",
                 "hatch");
    expect_error({"--image", "0.5", "--points", "9", "--out", "no/a.png"}, "there is no folder no");
    expect_error({"--image", "0.5", "--points", "9", "--out", "."}, "--out .: is a folder");
    for (const std::string out : {"a.gif", "a.JPG"})
        expect_error({"--image", "0.5", "--points", "9", "--out", out},
                     "--out " + out +
                         ": must end in .svg, .png, .dxf, .txt, .dat, .csv, .npy, .ply, .h5, .hdf5, .usda, .h5part or "
                         ".geojson");
    expect_error({"--image", "0.5", "--points", "9", "--width", "200"},
                 "--width 200: must be a length such as 200mm, 20cm or 8in");
    expect_error({"--image", "0.5", "--points", "9", "--pen", "0.3mm"}, "--pen 0.3mm: needs --width");
    expect_error({"--image", "0.5", "--points", "9", "--dots", "rings"},
                 "--dots rings: must be one of \"circles\", \"strokes\"");
    expect_error({"--image", "0.5", "--points", "9", "--travel", "far"},
                 "--travel far: must be one of \"nearest\", \"as-made\"");
    EXPECT_THAT(run("stipple", {"--image", "0.5", "--points", "9", "--width", "9cm", "--out", "a.png"}).error,
                HasSubstr("--width: needs an --out that ends in .svg or .dxf"));
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "a.gif"));
}

}
}
