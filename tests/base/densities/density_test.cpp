// Densities against their definition: exact weights, the same way up as coordinates, refusals by pixel.
#include "base/densities/density_text.hpp"
#include "base/densities/plane_formula.hpp"
#include "base/files/whole_file.hpp"
#include "base/images/float_image.hpp"
#include "base/images/png_file.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

namespace poissonlab {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

/// A picture of 8-bit channels, row by row from the top.
std::filesystem::path png(const TemporaryFolder& folder, int width, int height, int channels,
                          const std::vector<std::uint8_t>& values)
{
    const std::filesystem::path path = folder.path() / "picture.png";
    write_png(path, {.width = width, .height = height, .channels = channels},
              [&](int first, int) { return values.data() + first * width * channels; });
    return path;
}

std::uint64_t weight_of(double part) { return static_cast<std::uint64_t>(std::floor(part * 1099511627776.0)); }

TEST(Density, IsAPartOfTheLargestOne)
{
    const Density density = density_of_values(2, 2, {0, 3, 1.5, 6}, "test");
    EXPECT_THAT(density.weights, ElementsAre(0U, full_weight / 2, full_weight / 4, full_weight));
    EXPECT_EQ(density.at(0.49, 0), 0U);
    EXPECT_EQ(density.at(0.5, 0.49), full_weight / 2);
    EXPECT_EQ(density.at(0, 0.5), full_weight / 4);
    EXPECT_EQ(density.at(0.99999, 0.99999), full_weight);
    EXPECT_EQ(density_of_values(1, 1, {1e300}, "test").weights.front(), full_weight);
}

TEST(Density, OfPicturesIsLinearAndUpright)
{
    const TemporaryFolder folder;
    // Black above white, grey beside: the lowest row has the lowest y.
    const LinearPicture picture = read_linear_picture(png(folder, 2, 2, 1, {0, 188, 255, 64}));
    const Density density = density_of_picture(picture, "light", "picture.png");
    // IEC 61966-2-1: 188 is 0.502886 of white's light, 64 is 0.0512695.
    const auto part = [&](double x, double y) { return static_cast<double>(density.at(x, y)) / 1099511627776.0; };
    EXPECT_EQ(density.at(0, 0), full_weight);
    EXPECT_EQ(density.at(0, 0.9), 0U);
    EXPECT_NEAR(part(0.9, 0.9), 0.502886, 1e-6);
    EXPECT_NEAR(part(0.9, 0.1), 0.0512695, 1e-6);
    const Density ink = density_of_picture(picture, "ink", "picture.png");
    EXPECT_EQ(ink.at(0, 0.9), full_weight);
    EXPECT_EQ(ink.at(0, 0), 0U);
    EXPECT_NEAR(static_cast<double>(ink.at(0.9, 0.9)) / 1099511627776.0, 1 - 0.502886, 1e-6);
}

TEST(Density, OfColoursIsTheirLuminance)
{
    const TemporaryFolder folder;
    const LinearPicture picture =
        read_linear_picture(png(folder, 4, 1, 4, {255, 0, 0, 10, 0, 255, 0, 20, 0, 0, 255, 30, 255, 255, 255, 0}));
    EXPECT_THAT(picture.channels, ElementsAre("R", "G", "B", "A"));
    const LinearPicture opaque =
        read_linear_picture(png(folder, 4, 1, 3, {255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255}));
    const Density density = density_of_picture(opaque, "light", "p");
    for (std::size_t i = 0; i < 4; ++i) {
        const double expected = std::array{0.2126, 0.7152, 0.0722, 1.0}[i];
        EXPECT_NEAR(static_cast<double>(density.weights[i]), static_cast<double>(weight_of(expected)), 2);
    }
    // Alpha is no colour, and not linearised.
    const Density alpha = density_of_picture(picture, "A", "p");
    for (std::size_t i = 0; i < 4; ++i) {
        constexpr double rounding = 1e-7; // of floats
        const double expected = std::array{1.0 / 3, 2.0 / 3, 1.0, 0.0}[i];
        EXPECT_NEAR(static_cast<double>(alpha.weights[i]) / 1099511627776.0, expected, rounding);
    }
    EXPECT_EQ(refusal_of([&] { density_of_picture(picture, "Z\n", "p"); }),
              "p: \"Z\\n\": must be light, ink or a channel of the picture: R, G, B, A");
}

TEST(Density, OfFloatsIsTakenAsItIs)
{
    const TemporaryFolder folder;
    FloatImage image{2, 1, {{"Y", {0.25F, 4.0F}}}, {}};
    const std::filesystem::path path = folder.path() / "light.exr";
    write_float_image(path, image);
    EXPECT_THAT(density_of_picture(read_linear_picture(path), "light", "p").weights,
                ElementsAre(full_weight / 16, full_weight));
    EXPECT_EQ(refusal_of([&] { density_of_picture(read_linear_picture(path), "ink", "p"); }),
              "p: pixel (1, 0): luminance 4: must be at most 1 for ink");
    image.channels["Y"][0] = std::numeric_limits<float>::quiet_NaN();
    write_float_image(path, image);
    EXPECT_EQ(refusal_of([&] { density_of_picture(read_linear_picture(path), "light", "p"); }),
              "p: pixel (0, 0): density nan: must be a number that is not negative");
}

TEST(Density, RefusesWhatNoPointsCanFollow)
{
    EXPECT_EQ(refusal_of([] {
                  density_of_values(2, 2, {1, 1, -1, 1}, "p");
              }),
              "p: pixel (0, 0): density -1: must be a number that is not negative");
    EXPECT_EQ(refusal_of([] {
                  density_of_values(1, 2, {std::numeric_limits<double>::infinity(), 1}, "p");
              }),
              "p: pixel (0, 1): density inf: must be a number that is not negative");
    EXPECT_EQ(refusal_of([] {
                  density_of_values(2, 1, {0, 0}, "p");
              }),
              "p: is 0 everywhere: must be positive somewhere");
}

TEST(Density, RefusesFilesThatAreNoPictures)
{
    const TemporaryFolder folder;
    const auto message = [&](const char* name) {
        return refusal_of([&] { read_linear_picture(folder.path() / name); });
    };
    EXPECT_THAT(message("missing.png"), EndsWith("missing.png: cannot read the picture: no such file"));
    folder.write("text.png", "no picture");
    EXPECT_THAT(message("text.png"), HasSubstr("text.png: cannot read the picture: "));
    png(folder, 2, 2, 1, {0, 188, 255, 64});
    const std::string whole = read_whole_file(folder.path() / "picture.png");
    for (const std::size_t size : {whole.size() / 2, whole.size() * 2 / 3}) {
        folder.write("cut.png", whole.substr(0, size));
        EXPECT_THAT(message("cut.png"), EndsWith("cut.png: cannot read the picture: the file is cut off"));
    }
    std::string damaged = whole;
    damaged[damaged.find("IDAT") + 6] ^= 1;
    folder.write("damaged.png", damaged);
    EXPECT_THAT(message("damaged.png"), EndsWith("the file is damaged: its chunk IDAT has another check sum"));
    EXPECT_EQ(message("."), folder.path().string() + "/.: cannot read the picture: is a folder, no file");
    EXPECT_EQ(message("/dev/null"), "/dev/null: cannot read the picture: is a device, no file");
}

TEST(DensityFormula, HasItsValuesInTheMiddlesOfPixels)
{
    // The longest side is from -1 to 1.
    const Density density = density_of_formula("x + 1", 2, 1);
    EXPECT_EQ(density.width, formula_pixels);
    EXPECT_EQ(density.height, formula_pixels / 2);
    const double largest = 2 - 1.0 / formula_pixels;
    for (const int column : {0, 7, 512, 1023}) {
        const double x = (2 * column + 1.0) / formula_pixels - 1;
        EXPECT_EQ(density.weights[static_cast<std::size_t>(column)], weight_of((x + 1) / largest));
    }
    const Density upwards = density_of_formula("y > 0 ? 1 : 0.5", 1, 1);
    EXPECT_EQ(upwards.at(0.3, 0.4), full_weight / 2);
    EXPECT_EQ(upwards.at(0.3, 0.6), full_weight);
}

TEST(DensityFormula, KnowsThatOfTheDissertation)
{
    const Density density = density_of_formula("gauss-and-waves", 1, 1);
    const auto value = [](double x, double y) {
        const double pi = 3.14159265358979323846;
        return std::exp(-20 * (x * x + y * y)) + 0.05 * std::pow(std::sin(pi * x) * std::sin(pi * y), 2);
    };
    const auto middle = [](std::size_t i) { return (2 * static_cast<double>(i) + 1) / formula_pixels - 1; };
    const double largest = value(middle(512), middle(512));
    for (const std::size_t column : {0U, 300U, 512U, 900U})
        for (const std::size_t row : {20U, 511U, 800U})
            EXPECT_NEAR(static_cast<double>(density.weights[row * formula_pixels + column]),
                        value(middle(column), middle(row)) / largest * 1099511627776.0, 2);
}

TEST(DensityFormula, IsRefusedInOneLine)
{
    EXPECT_THAT(refusal_of([] { density_of_formula("sin(x", 1, 1); }), HasSubstr("formula \"sin(x\": "));
    EXPECT_THAT(refusal_of([] { density_of_formula("z", 1, 1); }), HasSubstr("formula \"z\": "));
    EXPECT_THAT(refusal_of([] { density_of_formula("", 1, 1); }), HasSubstr("formula \"\": "));
    EXPECT_THAT(refusal_of([] { density_of_formula("x", 1, 1); }), HasSubstr("density -0.999"));
    EXPECT_THAT(refusal_of([] { density_of_formula("1/(x*0)", 1, 1); }), HasSubstr("must be a number"));
    EXPECT_THAT(refusal_of([] { density_of_formula("0", 1, 1); }), HasSubstr("is 0 everywhere"));
    EXPECT_EQ(refusal_of([] { density_of_formula("x=3", 1, 1); }), "formula \"x=3\": has an assignment; == compares");
    EXPECT_EQ(
        refusal_of([] { density_of_formula("0,5+0*x, x>0", 1, 1); }),
        "formula \"0,5+0*x, x>0\": is 3 formulas with commas between them: must be one; the comma of \"0,5\" is no "
        "decimal point: must be 0.5");
    EXPECT_EQ(refusal_of([] { density_of_formula("x+2, y+2", 1, 1); }),
              "formula \"x+2, y+2\": is 2 formulas with commas between them: must be one");
    EXPECT_THAT(
        refusal_of([] { density_of_formula("exp(-0,5*x)", 1, 1); }),
        AllOf(HasSubstr("Too many parameters"), HasSubstr("the comma of \"0,5\" is no decimal point: must be 0.5")));
    EXPECT_EQ(refusal_of([] { density_of_formula("max(0, 0.5-x)+min(1,2)", 1, 1); }), "accepted");
    EXPECT_EQ(refusal_of([] { density_of_formula("x<=0 ? 1 : y==y ? 2 : 3", 1, 1); }), "accepted");
}

TEST(Constants, AreFormulasWithoutCoordinates)
{
    for (const auto& [text, value] : {std::pair{"0.5", 0.5},
                                      {".5", 0.5},
                                      {"+0.5", 0.5},
                                      {"5.", 5.0},
                                      {"1e3", 1000.0},
                                      {" 0.5 ", 0.5},
                                      {"1/2", 0.5},
                                      {"-2", -2.0},
                                      {"sqrt(4)", 2.0},
                                      {"max(1,2)", 2.0}})
        EXPECT_EQ(constant_of(text), std::optional(value)) << text;
    for (const char* text : {"", "x", "0*x+1", "y>0", "0,5", "0x10", "0.5 mm", "1 2", "a.png", "x=3"})
        EXPECT_EQ(constant_of(text), std::nullopt) << text;
    // They are refused as numbers out of range, not as formulas with unknown names.
    EXPECT_THAT(constant_of("nan"), testing::Optional(testing::IsNan()));
    EXPECT_EQ(constant_of("-inf"), std::optional(-std::numeric_limits<double>::infinity()));
}

}
}
