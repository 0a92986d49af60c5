// poissonlab texture export: files for engines, taken apart apart from the code that writes them; levels by sums in
// double precision, normals by windows of tilings, texels by libpng and by OpenImageIO.
#include "base/files/whole_file.hpp"
#include "base/images/raw_picture.hpp"
#include "tests/support/command_test.hpp"
#include "tests/support/gpu_file.hpp"
#include "tests/support/raw_png.hpp"
#include "tiles/texture/endless_texture.hpp"
#include "tiles/texture/texture_tiling.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace poissonlab {
namespace {

using test::GpuFile;
using test::RawPng;
using testing::HasSubstr;

constexpr int tile = 16, colors = 2, side = colors * colors;

class TextureExport : public test::CommandTest
{
protected:
    TextureExport() : CommandTest("texture")
    {
        write_noise("noise.png", 3, 8, 1);
        write_noise("height.png", 1, 16, 2);
    }

    void write_noise(const std::string& name, int channels, int bits, unsigned seed)
    {
        RawPng picture{60, 54, channels, bits, {}};
        std::mt19937 random(seed);
        for (int i = 0; i < 60 * 54 * channels; ++i)
            picture.samples.push_back(static_cast<std::uint16_t>(random() % (bits == 8 ? 256 : 65536)));
        test::write_raw_png(folder_.path() / name, picture);
    }

    void build(const std::string& kind, const std::string& out)
    {
        printed("build " + kind + " --exemplar noise.png --also height.png --size 16 --attempts 3 --quiet --out " +
                out);
    }

    std::filesystem::path at(const std::string& name) const { return folder_.path() / name; }
    GpuFile dds(const std::string& name, std::size_t texel) const
    {
        return test::read_dds(read_whole_file(at(name)), texel);
    }
};

/// The texel of the atlas that a layer shows: places count from the lower left.
std::pair<int, int> atlas_texel(int layer, int column, int row)
{
    return {layer % side * tile + column, (side - 1 - layer / side) * tile + row};
}

double light(double value)
{
    const double v = value / 255;
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

/// The mean of the texels of a tile that one texel of a level covers: as a byte of sRGB, or of numbers.
double mean_below(const RawPng& atlas, int layer, int level, int column, int row, int channel)
{
    const int block = 1 << level;
    double sum = 0;
    for (int j = 0; j < block; ++j)
        for (int i = 0; i < block; ++i) {
            const auto [x, y] = atlas_texel(layer, column * block + i, row * block + j);
            const double value =
                atlas.samples[static_cast<std::size_t>((y * atlas.width + x) * atlas.channels + channel)];
            sum += atlas.bits == 8 ? light(value) : value;
        }
    sum /= block * block;
    if (atlas.bits == 16) return sum;
    return 255 * (sum <= 0.0031308 ? 12.92 * sum : 1.055 * std::pow(sum, 1 / 2.4) - 0.055);
}

double sample(const std::string& texels, std::size_t number, int bits)
{
    if (bits == 8) return static_cast<unsigned char>(texels.at(number));
    return static_cast<unsigned char>(texels.at(2 * number)) +
           256 * static_cast<unsigned char>(texels.at(2 * number + 1));
}

/// Every level of every tile is made of the tile's own texels alone.
void expect_means(const GpuFile& layers, const RawPng& atlas, std::size_t channels)
{
    ASSERT_EQ(layers.levels.size(), 5);
    ASSERT_EQ(layers.layers, side * side);
    for (int level = 0; level < 5; ++level)
        for (int layer = 0; layer < side * side; ++layer)
            for (int i = 0; i < tile * tile >> 2 * level; ++i)
                for (int c = 0; c < atlas.channels; ++c) {
                    const int width = tile >> level;
                    // Light of bytes is in whole 65535ths: near black, the curve makes 0.1 of a byte of half of one.
                    ASSERT_NEAR(sample(layers.levels[static_cast<std::size_t>(level)][static_cast<std::size_t>(layer)],
                                       static_cast<std::size_t>(i) * channels + static_cast<std::size_t>(c),
                                       atlas.bits),
                                mean_below(atlas, layer, level, i % width, i / width, c), level == 0 ? 1e-9 : 0.6)
                        << level << " " << layer << " " << i;
                }
}

TEST_F(TextureExport, MakesLevelsOfTilesAlone)
{
    build("corner --colors 2", "set");
    EXPECT_THAT(printed("export set --out engine"),
                HasSubstr("engine: 2 maps of 16 tiles of 16 x 16 texels, 5 levels"));
    const RawPng atlas = test::read_raw_png(at("set/atlas.png")),
                 heights = test::read_raw_png(at("set/atlas-height.png"));
    expect_means(dds("engine/tiles.dds", 4), atlas, 4);
    expect_means(dds("engine/tiles-height.dds", 2), heights, 1);
    // The packed atlas has the same texels, and KTX2 files those of DDS files.
    for (const std::string& map : std::vector<std::string>{"", "-height"}) {
        const std::size_t texel = map.empty() ? 4 : 2;
        const GpuFile layers = dds("engine/tiles" + map + ".dds", texel),
                      packed = dds("engine/atlas" + map + ".dds", texel);
        ASSERT_EQ(packed.layers, 1);
        for (std::size_t level = 0; level < 5; ++level)
            for (int layer = 0; layer < side * side; ++layer) {
                const int width = tile >> level;
                for (int row = 0; row < width; ++row) {
                    const int x = layer % side * width, y = (side - 1 - layer / side) * width + row;
                    const auto from = static_cast<std::size_t>(y * side * width + x) * texel,
                               bytes = static_cast<std::size_t>(width) * texel;
                    ASSERT_EQ(packed.levels[level][0].substr(from, bytes),
                              layers.levels[level][static_cast<std::size_t>(layer)].substr(
                                  static_cast<std::size_t>(row) * bytes, bytes));
                }
            }
        for (const std::string& name : {"engine/tiles" + map, "engine/atlas" + map})
            EXPECT_EQ(test::read_ktx2(read_whole_file(at(name + ".ktx2")), texel).levels,
                      dds(name + ".dds", texel).levels);
    }
    for (int layer : {0, 7, 15}) {
        const RawPng picture = test::read_raw_png(
            at("engine/tiles" + std::string(layer < 10 ? "/0000" : "/000") + std::to_string(layer) + ".png"));
        for (int i = 0; i < tile * tile * 3; ++i) {
            const auto [x, y] = atlas_texel(layer, i / 3 % tile, i / 3 / tile);
            ASSERT_EQ(picture.samples[static_cast<std::size_t>(i)],
                      atlas.samples[static_cast<std::size_t>((y * atlas.width + x) * 3 + i % 3)]);
        }
    }
}

/// OpenImageIO 2.4 knows no DX10 header without compression: with the older one in its place it reads the same texels.
TEST_F(TextureExport, HasTheTexelsThatOpenImageIoReads)
{
    build("corner --colors 2", "set");
    printed("export set --formats dds --quiet --out engine");
    std::string bytes = read_whole_file(at("engine/atlas.dds"));
    const auto put = [&](std::size_t place, std::uint32_t word) {
        for (std::size_t i = 0; i < 4; ++i) bytes[place + i] = static_cast<char>(word >> 8 * i & 255);
    };
    put(80, 0x41); // colours and alpha by masks
    put(84, 0);
    put(88, 32);
    for (std::size_t i = 0; i < 4; ++i) put(92 + 4 * i, 0xFFU << 8 * i);
    bytes.erase(128, 20);
    write_whole_file(at("old.dds"), bytes);
    const RawPicture read = read_raw_picture(at("old.dds"));
    const RawPng atlas = test::read_raw_png(at("set/atlas.png"));
    ASSERT_EQ(read.channels.size(), 4);
    ASSERT_EQ(read.width, atlas.width);
    for (std::size_t i = 0; i < read.bytes.size(); ++i)
        ASSERT_EQ(read.bytes[i], i % 4 == 3 ? 255 : atlas.samples[i / 4 * 3 + i % 4]);
    EXPECT_FALSE(exists(at("engine/atlas.ktx2")));
    EXPECT_FALSE(exists(at("engine/tiles")));
}

/// The heights of a window of a tiling, the layer and texel of each, and the pixel of the exemplar that it shows.
struct HeightWindow
{
    int width = 0;
    std::vector<double> heights;
    std::vector<int> layers, texels;
    std::vector<std::pair<int, int>> shown;

    HeightWindow(const TextureSet& set, const RawPng& atlas, const RawPng& sources, int tiles)
        : width(tiles * tile), heights(static_cast<std::size_t>(width * width)), layers(heights.size()),
          texels(heights.size()), shown(heights.size())
    {
        const bool is_wang = set.kind == TextureKind::wang;
        for (int y = 0; y < width; ++y)
            for (int x = 0; x < width; ++x) {
                const auto layer = static_cast<int>(endless_place(is_wang ? TileKind::wang : TileKind::corner, 3,
                                                                  colors, static_cast<std::uint32_t>(x / tile),
                                                                  static_cast<std::uint32_t>(tiles - 1 - y / tile)));
                const auto [column, row] = atlas_texel(layer, x % tile, y % tile);
                const auto i = static_cast<std::size_t>(y * width + x);
                heights[i] = atlas.samples[static_cast<std::size_t>(row * atlas.width + column)] / 65535.0;
                const auto source = static_cast<std::size_t>((row * sources.width + column) * sources.channels);
                shown[i] = {sources.samples[source], sources.samples[source + 1]};
                layers[i] = layer;
                texels[i] = y % tile * tile + x % tile;
            }
    }
    std::size_t index(int x, int y) const { return static_cast<std::size_t>(y * width + x); }

    /// The slope in a direction by what is beside a texel in the exemplar too: by both neighbours, one, or none.
    double slope(int x, int y, int dx, int dy) const
    {
        std::vector<double> found;
        for (const int side : {-1, 1}) {
            const auto from = index(x, y), to = index(x + side * dx, y + side * dy);
            const bool is_beside =
                shown[to].first == shown[from].first + side * dx && shown[to].second == shown[from].second + side * dy;
            if (is_beside) found.push_back((heights[to] - heights[from]) / side);
        }
        return found.empty() ? 0 : (found.front() + found.back()) / 2;
    }
};

/// Differences in any tiling are those of the exported normals, across borders as well, and cuts make no ridges.
TEST_F(TextureExport, HasTheNormalsOfEveryTiling)
{
    for (const std::string& kind : std::vector<std::string>{"corner", "wang"}) {
        SCOPED_TRACE(kind);
        build(kind + " --colors 2", kind);
        printed("export " + kind + " --normals height --relief 5 --quiet --out engine");
        const GpuFile normals = dds("engine/tiles-height-normals.dds", 8);
        const HeightWindow window(read_texture_set(at(kind)), test::read_raw_png(at(kind + "/atlas-height.png")),
                                  test::read_raw_png(at(kind + "/sources.png")), 9);
        int compared = 0;
        for (int y = 1; y + 1 < window.width; ++y)
            for (int x = 1; x + 1 < window.width; ++x) {
                const bool is_corner =
                    (x % tile == 0 || x % tile == tile - 1) && (y % tile == 0 || y % tile == tile - 1);
                if (kind == "wang" && is_corner) continue;
                const double east = 5 * window.slope(x, y, 1, 0), north = 5 * window.slope(x, y, 0, -1),
                             length = std::sqrt(east * east + north * north + 1);
                const double expected[]{-east / length, -north / length, 1 / length, 1};
                const auto i = static_cast<std::size_t>(y * window.width + x);
                for (std::size_t c = 0; c < 4; ++c)
                    ASSERT_NEAR(sample(normals.levels[0][static_cast<std::size_t>(window.layers[i])],
                                       static_cast<std::size_t>(window.texels[i]) * 4 + c, 16),
                                (expected[c] + 1) / 2 * 65535, 0.501)
                        << x << " " << y << " " << c;
                ++compared;
            }
        EXPECT_GT(compared, 18'000);
    }
}

/// tests/runtime holds that these texts compile, and find the right tiles. MaterialX hands the inputs of a node to its
/// function in their order, the output last.
TEST_F(TextureExport, HasLookUpsWithTheNumbersOfTheSet)
{
    build("wang --colors 2", "set");
    printed("export set --formats glsl --formats hlsl --formats wgsl --formats mtlx --quiet --out engine");
    const std::string numbers = "#define TTILES_COLORS 2u\n#define TTILES_SIZE 16\n#define TTILES_LEVELS 5\n"
                                "#define TTILES_WANG 1\n";
    EXPECT_THAT(read_whole_file(at("engine/look_up.glsl")), HasSubstr("#define TTILES_GLSL\n" + numbers));
    EXPECT_THAT(read_whole_file(at("engine/look_up.hlsl")), HasSubstr("#define TTILES_HLSL\n" + numbers));
    EXPECT_THAT(read_whole_file(at("engine/look_up.wgsl")),
                HasSubstr("const ttiles_colors = 2u;\nconst ttiles_size = 16;\nconst ttiles_levels = 5;\n"
                          "const ttiles_wang = true;\n"));
    EXPECT_EQ(test::read_raw_png(at("engine/atlas.png")).samples, test::read_raw_png(at("set/atlas.png")).samples);
    const std::string document = read_whole_file(at("engine/texture_tiles.mtlx"));
    EXPECT_THAT(document, HasSubstr("16 wang tiles of 16 x 16 texels"));
    EXPECT_THAT(document, HasSubstr("file=\"texture_tiles.glsl\" function=\"ttiles_color3\""));
    EXPECT_THAT(document, HasSubstr("type=\"filename\" value=\"atlas.png\" colorspace=\"srgb_texture\""));
    std::size_t place = document.find("<nodedef");
    for (const char* input : {"name=\"file\" type=\"filename\"", "name=\"texcoord\" type=\"vector2\"",
                              "name=\"seed\" type=\"integer\"", "name=\"out\" type=\"color3\"", "</nodedef>"}) {
        place = document.find(input, place);
        ASSERT_NE(place, std::string::npos) << input;
    }
    EXPECT_THAT(read_whole_file(at("engine/texture_tiles.glsl")),
                AllOf(HasSubstr(numbers), HasSubstr("void ttiles_color3(sampler2D atlas, vec2 texcoord, int seed, "
                                                    "out vec3 result)\n")));
}

TEST_F(TextureExport, SaysWhatIsWrong)
{
    build("corner --colors 2", "set");
    expect_error("export set --formats tga --out e",
                 "texture export: --formats tga: must be one of \"dds\", \"ktx2\", \"png\", \"glsl\", \"hlsl\", "
                 "\"wgsl\", \"mtlx\", \"page\"");
    expect_error("export set --normals bumps --out e",
                 "texture export: normals of bumps: there is no such companion; there are: height");
    expect_error("export set --normals height --relief 0 --out e",
                 "texture export: --relief 0: must be a number greater than 0 and at most 10000");
    expect_error("export set --out noise.png", "texture export: --out noise.png: is a file; a folder is needed");
    build("omega --colors 4", "omega");
    expect_error(
        "export omega --normals height --out e",
        "texture export: normals of height: must be of a complete set of corner or Wang tiles, whose neighbours "
        "in the atlas have the texels of those in a tiling");
    expect_error(
        "export omega --formats page --out e",
        "texture export: --formats page: is for complete sets of corner or Wang tiles, which a hash lays; omega "
        "are laid in scanlines");
    EXPECT_FALSE(exists(at("e")));
    printed("export omega --formats dds --quiet --out scanned");
    EXPECT_FALSE(exists(at("scanned/atlas.dds")));
    EXPECT_EQ(dds("scanned/tiles.dds", 4).layers, 16);
}

}
}
