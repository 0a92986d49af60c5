// Companions of texture sets and exemplars of more than 8 bits, from the command line. The oracle reads every file by
// itself: PNG files by libpng, EXR files byte by byte, texture.json by its members.
#include "base/images/float_image.hpp"
#include "tests/support/command_test.hpp"
#include "tests/support/raw_png.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>
#include <map>
#include <random>

namespace poissonlab {
namespace {

using test::RawPng;
using testing::HasSubstr;

constexpr int wide = 60, high = 54; // of exemplars

/// A picture's samples as whole numbers: those of PNG files, the bits of those of EXR files.
struct Samples
{
    int width = 0;
    int height = 0;
    std::size_t channels = 0;
    std::vector<std::uint32_t> values;

    std::vector<std::uint32_t> at(int column, int row) const
    {
        const auto first =
            values.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(row * width + column) * channels);
        return {first, first + static_cast<std::ptrdiff_t>(channels)};
    }
};

/// Takes an uncompressed EXR file of float32 apart (OpenEXR File Layout): attributes, a table of places, and for each
/// row its number, its length, and the numbers of each channel in turn.
class ExrBytes
{
public:
    explicit ExrBytes(std::string bytes) : bytes_(std::move(bytes)) {}

    Samples samples()
    {
        place_ = 8; // behind the magic number and the version
        Samples s;
        for (std::string name = text(); !name.empty(); name = text()) {
            text(); // the type
            const auto end = place_ + 4 + number<std::uint32_t>(place_);
            place_ += 4;
            if (name == "channels") s.channels = channel_count();
            if (name == "compression" && bytes_[place_] != 0) ADD_FAILURE() << "compressed";
            if (name == "dataWindow") {
                s.width = number<std::int32_t>(place_ + 8) + 1;
                s.height = number<std::int32_t>(place_ + 12) + 1;
            }
            place_ = end;
        }
        const auto width = static_cast<std::size_t>(s.width);
        for (int row = 0; row < s.height; ++row) {
            const auto begin = number<std::uint64_t>(place_ + 8 * static_cast<std::size_t>(row)) + 8;
            for (std::size_t x = 0; x < width; ++x)
                for (std::size_t c = 0; c < s.channels; ++c)
                    s.values.push_back(number<std::uint32_t>(begin + 4 * (c * width + x)));
        }
        return s;
    }

private:
    template <class Number>
    Number number(std::size_t at) const
    {
        Number value{};
        std::memcpy(&value, &bytes_.at(at), sizeof(value));
        return value;
    }

    std::string text()
    {
        const std::string found = bytes_.c_str() + place_;
        place_ += found.size() + 1;
        return found;
    }

    std::size_t channel_count()
    {
        std::size_t count = 0;
        for (std::string name = text(); !name.empty(); name = text(), ++count) {
            EXPECT_EQ(number<std::int32_t>(place_), 2) << "float32";
            place_ += 16;
        }
        return count;
    }

    std::string bytes_;
    std::size_t place_ = 0;
};

Samples samples_of(const std::filesystem::path& file)
{
    if (file.extension() == ".exr") return ExrBytes(content_of(file)).samples();
    const RawPng png = test::read_raw_png(file);
    return {png.width, png.height, static_cast<std::size_t>(png.channels), {png.samples.begin(), png.samples.end()}};
}

RawPng noise(int channels, int bits, unsigned seed, int width = wide, int height = high)
{
    RawPng picture{width, height, channels, bits, {}};
    std::mt19937 random(seed);
    for (int i = 0; i < width * height * channels; ++i)
        picture.samples.push_back(static_cast<std::uint16_t>(random() % (bits == 8 ? 256 : 65536)));
    return picture;
}

/// Numbers of every size and sign.
FloatImage float_noise(const std::vector<std::string>& channels, unsigned seed, float least = -1e6F)
{
    FloatImage image;
    image.width = wide;
    image.height = high;
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> exponent(-20, 10);
    for (const std::string& channel : channels)
        for (int i = 0; i < wide * high; ++i)
            image.channels[channel].push_back(
                std::max(least, (random() % 4 == 0 ? -1.0F : 1.0F) * std::exp2(exponent(random))));
    return image;
}

class TextureCompanions : public test::CommandTest
{
protected:
    TextureCompanions() : CommandTest("texture")
    {
        test::write_raw_png(file("noise.png"), noise(3, 8, 3));
        test::write_raw_png(file("normal.png"), noise(4, 8, 4)); // alpha must leave colours alone
        test::write_raw_png(file("rough.png"), noise(1, 16, 5));
        FloatImage heights = float_noise({"B", "height"}, 6);
        for (const auto& [place, bits] : std::map<std::size_t, std::uint32_t>{
                 {7, 0x7fc12345u}, {8, 0xff800000u}, {9, 0x80000000u}, {10, 1u}}) // NaN, infinite, -0, denormal
            heights.channels["height"][place] = std::bit_cast<float>(bits);
        write_float_image(file("height.exr"), heights);
    }

    std::filesystem::path file(const std::string& name) const { return folder_.path() / name; }

    /// Compares each pixel of an atlas with the picture at the source that sources.png says; there is nothing
    /// elsewhere.
    void expect_cut(const std::string& set, const std::string& atlas_name, const std::string& picture_name) const
    {
        const auto json = nlohmann::json::parse(content_of(file(set + "/texture.json")));
        const RawPng sources = test::read_raw_png(file(set + "/sources.png"));
        const Samples atlas = samples_of(file(set + "/" + atlas_name)), picture = samples_of(file(picture_name));
        const int size = json["tile_size"];
        ASSERT_EQ(atlas.width, json["atlas_columns"].get<int>() * size) << atlas_name;
        ASSERT_EQ(atlas.height, json["atlas_rows"].get<int>() * size);
        ASSERT_EQ(atlas.channels, picture.channels);
        std::vector<bool> is_tile(static_cast<std::size_t>(atlas.width * atlas.height));
        for (const auto& tile : json["tiles"])
            for (int i = 0; i < size * size; ++i) {
                const int x = tile["column"].get<int>() * size + i % size, y = tile["row"].get<int>() * size + i / size;
                const std::uint16_t* const source = sources.pixel(x, y);
                ASSERT_EQ(atlas.at(x, y), picture.at(source[0], source[1])) << atlas_name << " " << x << " " << y;
                is_tile[static_cast<std::size_t>(y * atlas.width + x)] = true;
            }
        for (int i = 0; i < atlas.width * atlas.height; ++i)
            if (!is_tile[static_cast<std::size_t>(i)]) {
                ASSERT_EQ(atlas.at(i % atlas.width, i / atlas.width), std::vector<std::uint32_t>(atlas.channels, 0));
            }
    }

    const std::string small_ = " --size 16 --attempts 2 --candidates 1 ";
};

TEST_F(TextureCompanions, AreCutByTheSourcesOfTheExemplar)
{
    const std::map<std::string, std::string> kinds{
        {"corner", "corner --colors 2"}, {"wang", "wang --colors 2"}, {"compact", "wang --colors 2 --tiles compact"}};
    for (const auto& [set, kind] : kinds) {
        EXPECT_THAT(printed("build " + kind + small_ + "--exemplar noise.png --out " + set +
                            " --also normal.png --also rough.png --also height.exr"),
                    HasSubstr("\natlas-normal.png: a companion, 4 channels of 8 bits, at the same sources\n"
                              "atlas-rough.png: a companion, a channel of 16 bits, at the same sources\n"
                              "atlas-height.exr: a companion, 2 channels of floating point, at the same sources\n"));
        for (const char* name : {"normal.png", "rough.png", "height.exr"})
            expect_cut(set, std::string("atlas-") + name, name);
        expect_cut(set, "atlas.png", "noise.png"); // sources are those of the tiles
        EXPECT_EQ(test::read_raw_png(file(set + "/atlas-rough.png")).bits, 16);
        EXPECT_EQ(test::read_raw_png(file(set + "/atlas-normal.png")).bits, 8);
        const auto proof = nlohmann::json::parse(printed("verify " + set + " --json"));
        const std::size_t pixels = (set == "compact" ? 8 : 16) * 16 * 16;
        EXPECT_EQ(proof["companions"]["atlas-height.exr"], pixels);
        EXPECT_THAT(printed("verify " + set), HasSubstr("atlas-rough.png: all " + std::to_string(pixels) +
                                                        " pixels have the bits of their sources"));
    }
}

TEST_F(TextureCompanions, AreProvenPixelByPixel)
{
    printed("build corner --colors 2 --exemplar noise.png --also rough.png --also height.exr --quiet --out set" +
            small_);
    const RawPng atlas = test::read_raw_png(file("set/atlas-rough.png"));
    RawPng other = atlas;
    other.samples[static_cast<std::size_t>(9 * other.width + 33)] ^= 1;
    test::write_raw_png(file("set/atlas-rough.png"), other);
    const RawPng sources = test::read_raw_png(file("set/sources.png"));
    const std::string place =
        "column " + std::to_string(sources.pixel(33, 9)[0]) + ", row " + std::to_string(sources.pixel(33, 9)[1]);
    expect_error("verify set",
                 "set/atlas-rough.png: the pixel in column 33, row 9 is not that of exemplar-rough.png in " + place);
    test::write_raw_png(file("set/atlas-rough.png"), atlas);
    printed("verify set");
    std::filesystem::copy_file(file("noise.png"), file("set/exemplar-rough.png"),
                               std::filesystem::copy_options::overwrite_existing);
    expect_error("verify set", "set/atlas-rough.png: 1 channels of 16 bits: must be 3 of 8 bits, as those of "
                               "exemplar-rough.png");
    std::filesystem::remove(file("set/exemplar-rough.png"));
    expect_error("verify set", "set/texture.json: companions[0].picture = \"exemplar-rough.png\": "
                               "set/exemplar-rough.png is missing");
}

/// Companions that an earlier set left would be cut by other sources.
TEST_F(TextureCompanions, DoNotOutliveTheirSet)
{
    const std::string build = "build corner --colors 2 --exemplar noise.png --quiet --out set" + small_;
    printed(build + "--also rough.png --also normal.png");
    folder_.write("set/atlas-mine.png", "of somebody else");
    printed(build + "--seed 2 --also normal.png");
    EXPECT_FALSE(std::filesystem::exists(file("set/atlas-rough.png")));
    EXPECT_FALSE(std::filesystem::exists(file("set/exemplar-rough.png")));
    EXPECT_TRUE(std::filesystem::exists(file("set/atlas-mine.png")));
    expect_cut("set", "atlas-normal.png", "normal.png");
}

TEST_F(TextureCompanions, WrongOnesAreSaidBeforeTheWork)
{
    test::write_raw_png(file("small.png"), noise(3, 8, 1, 50, 54));
    std::filesystem::create_directory(file("maps"));
    test::write_raw_png(file("maps/normal.png"), noise(3, 8, 1));
    folder_.write("text.png", "no picture");
    const std::string build =
        "build corner --colors 2 --exemplar noise.png --out o --size 16 --also normal.png --also ";
    const std::string begin = "texture build: --also ";
    expect_error(build + "none.png", begin + "normal.png none.png: none.png: no such file: must be a picture's file");
    expect_error(build + "small.png",
                 "texture build: --also: small.png: 50 x 54 pixels: must have 60 x 54, as noise.png has");
    expect_error(build + "maps/normal.png",
                 "texture build: --also: maps/normal.png: is called as normal.png is: both would be atlas-normal");
    EXPECT_EQ(run(build + "text.png").status, 2);
    expect_error(build + "rough.png --marked-exemplar noise.png",
                 begin + "normal.png rough.png: cannot be combined with --marked-exemplar");
    EXPECT_FALSE(std::filesystem::exists(file("o")));
}

TEST_F(TextureCompanions, ExemplarsOfMoreThan8BitsStayWhatTheyAre)
{
    test::write_raw_png(file("deep.png"), noise(3, 16, 7));
    printed("build corner --colors 2 --exemplar deep.png --quiet --out deep --also rough.png" + small_);
    expect_cut("deep", "atlas-deep.png", "deep.png");
    expect_cut("deep", "atlas-rough.png", "rough.png");
    const auto json = nlohmann::json::parse(content_of(file("deep/texture.json")));
    EXPECT_EQ(json["companions"][0]["original"], true);
    EXPECT_FALSE(json["companions"][1].contains("original"));
    expect_error("build corner --colors 2 --exemplar deep.png --out o --also maps/deep.png" + small_,
                 "texture build: --also maps/deep.png: no such file: must be a picture's file");
    // Light of an EXR file is tone-mapped where tiles are chosen, and nowhere else; alpha stays.
    write_float_image(file("light.exr"), float_noise({"A", "B", "G", "R"}, 8));
    const Outcome made = run("build wang --colors 2 --tiles compact --exemplar light.exr --out light" + small_);
    EXPECT_EQ(made.status, 0);
    EXPECT_THAT(made.error, HasSubstr("poissonlab: note: light.exr: light up to "));
    EXPECT_THAT(made.error, HasSubstr(" is tone-mapped and negative numbers, down to "));
    EXPECT_THAT(made.out, HasSubstr("atlas-light.exr: the exemplar's own numbers, 4 channels of floating point"));
    expect_cut("light", "atlas-light.exr", "light.exr");
    EXPECT_THAT(printed("verify light"), HasSubstr("atlas-light.exr: all 2048 pixels have the bits of their sources"));
    // Pictures whose numbers all lie in 0 to 1 need no note.
    FloatImage dim = float_noise({"Y"}, 9, 0);
    for (float& value : dim.channels["Y"]) value = std::min(value, 1.0F);
    write_float_image(file("dim.exr"), dim);
    printed("build corner --colors 2 --exemplar dim.exr --quiet --out dim" + small_);
    expect_cut("dim", "atlas-dim.exr", "dim.exr");
}

/// Two originals lie side by side where both have the same numbers; else tiles have 8 bits, and that is said.
TEST_F(TextureCompanions, MarkedExemplarsKeepTheirNumbersTogether)
{
    test::write_raw_png(file("plain.png"), noise(3, 16, 11));
    test::write_raw_png(file("marked.png"), noise(3, 16, 12));
    printed("build corner --colors 2 --exemplar plain.png --marked-exemplar marked.png --quiet --out both" + small_);
    expect_cut("both", "atlas-plain.png", "both/exemplar-plain.png");
    const RawPng both = test::read_raw_png(file("both/exemplar-plain.png"));
    ASSERT_EQ(both.width, 2 * wide);
    EXPECT_TRUE(std::ranges::equal(std::span(both.pixel(wide, 20), 3 * wide),
                                   std::span(test::read_raw_png(file("marked.png")).pixel(0, 20), 3 * wide)));
    EXPECT_THAT(
        run("build corner --colors 2 --exemplar plain.png --marked-exemplar noise.png --out one" + small_).error,
        HasSubstr("plain.png and noise.png have different numbers or channels: tiles have 8 bits"));
}

}
}
