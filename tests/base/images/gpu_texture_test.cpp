// Textures of every format, written as DDS and KTX2 and taken apart by their specifications.
#include "base/images/gpu_texture.hpp"

#include "tests/support/gpu_file.hpp"

#include <gtest/gtest.h>

#include <random>

namespace poissonlab {
namespace {

/// Numbers of vulkan_core.h and dxgiformat.h, and what a texel is.
struct FormatCase
{
    GpuFormat format;
    std::uint32_t dxgi, vulkan;
    std::size_t texel, channels;
};
constexpr FormatCase format_cases[]{{GpuFormat::r8, 61, 9, 1, 1},          {GpuFormat::rgba8, 28, 37, 4, 4},
                                    {GpuFormat::rgba8_srgb, 29, 43, 4, 4}, {GpuFormat::r16, 56, 70, 2, 1},
                                    {GpuFormat::rgba16, 11, 91, 8, 4},     {GpuFormat::r32f, 41, 100, 4, 1},
                                    {GpuFormat::rgba32f, 2, 109, 16, 4}};

GpuTexture random_texture(GpuFormat format, int width, int height, int layers, bool is_array)
{
    GpuTexture texture{format, width, height, layers, is_array, {}};
    std::mt19937 random(5);
    for (int level = 0; width >> level > 0 || height >> level > 0; ++level) {
        const auto texels = std::max(1, width >> level) * std::max(1, height >> level) * layers;
        std::string& bytes = texture.levels.emplace_back();
        for (std::size_t i = 0; i < static_cast<std::size_t>(texels) * texel_bytes(format); ++i)
            bytes += static_cast<char>(random());
    }
    return texture;
}

void expect_same_texels(const GpuTexture& texture, const test::GpuFile& file)
{
    EXPECT_EQ(file.width, texture.width);
    EXPECT_EQ(file.height, texture.height);
    EXPECT_EQ(file.layers, texture.layers);
    ASSERT_EQ(file.levels.size(), texture.levels.size());
    for (std::size_t level = 0; level < file.levels.size(); ++level) {
        std::string together;
        for (const std::string& layer : file.levels[level]) together += layer;
        EXPECT_EQ(together, texture.levels[level]) << "level " << level;
    }
}

TEST(GpuTexture, IsReadFromDdsAndKtx2)
{
    for (const FormatCase& c : format_cases) {
        SCOPED_TRACE(gpu_formats[c.format]);
        EXPECT_EQ(texel_bytes(c.format), c.texel);
        for (const bool is_array : {false, true}) {
            const GpuTexture texture = random_texture(c.format, 12, 6, is_array ? 5 : 1, is_array);
            const test::GpuFile dds = test::read_dds(dds_file(texture), c.texel),
                                ktx2 = test::read_ktx2(ktx2_file(texture), c.texel);
            EXPECT_EQ(dds.format, c.dxgi);
            EXPECT_EQ(ktx2.format, c.vulkan);
            expect_same_texels(texture, dds);
            expect_same_texels(texture, ktx2);
        }
    }
}

/// Channels, their bits and curves: Khronos Data Format 1.3, section 5, and the table of sRGB and float samples.
TEST(GpuTexture, DescribesItsChannelsInKtx2)
{
    for (const FormatCase& c : format_cases) {
        SCOPED_TRACE(gpu_formats[c.format]);
        const std::string file = ktx2_file(random_texture(c.format, 4, 4, 1, false));
        const std::size_t block = test::word_at(file, 48) + 4, size = test::word_at(file, block + 4) >> 16;
        EXPECT_EQ(size, 24 + 16 * c.channels);
        const bool is_srgb = c.format == GpuFormat::rgba8_srgb, is_real = c.dxgi == 41 || c.dxgi == 2;
        EXPECT_EQ(test::word_at(file, block + 8), is_srgb ? 0x020101U : 0x010101U);
        const auto bits = static_cast<std::uint32_t>(8 * c.texel / c.channels);
        EXPECT_EQ(test::word_at(file, 16), bits / 8);
        const std::uint32_t kinds[]{0, 1, 2, 15};
        for (std::uint32_t i = 0; i < c.channels; ++i) {
            const std::uint32_t kind = kinds[i] | (is_real ? 0xC0U : 0) | (is_srgb && i == 3 ? 0x10U : 0);
            EXPECT_EQ(test::word_at(file, block + 24 + 16 * i), i * bits | (bits - 1) << 16 | kind << 24);
            EXPECT_EQ(test::word_at(file, block + 32 + 16 * i), is_real ? 0xBF800000U : 0U);
            EXPECT_EQ(test::word_at(file, block + 36 + 16 * i), is_real ? 0x3F800000U : bits == 8 ? 255U : 65535U);
        }
        EXPECT_NE(file.find(std::string("KTXorientation\0rd\0", 18)), std::string::npos);
    }
}

}
}
