#include "base/images/gpu_texture.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <string_view>

namespace poissonlab {
namespace {

/// A format's numbers in both kinds of files.
struct FormatNumbers
{
    std::uint32_t dxgi, vulkan;
    std::uint32_t channels, bits; ///< bits of a channel
    bool is_real, is_srgb;
};

FormatNumbers numbers_of(GpuFormat format)
{
    switch (format) {
    case GpuFormat::r8:
        return {61, 9, 1, 8, false, false};
    case GpuFormat::rgba8:
        return {28, 37, 4, 8, false, false};
    case GpuFormat::rgba8_srgb:
        return {29, 43, 4, 8, false, true};
    case GpuFormat::r16:
        return {56, 70, 1, 16, false, false};
    case GpuFormat::rgba16:
        return {11, 91, 4, 16, false, false};
    case GpuFormat::r32f:
        return {41, 100, 1, 32, true, false};
    case GpuFormat::rgba32f:
        break;
    }
    return {2, 109, 4, 32, true, false};
}

/// Numbers of 32 and 64 bits, lowest byte first.
class LittleEndian
{
public:
    LittleEndian& words(std::initializer_list<std::uint32_t> all)
    {
        for (const std::uint32_t word : all)
            for (int byte = 0; byte < 4; ++byte) text_ += static_cast<char>(word >> (8 * byte) & 255U);
        return *this;
    }
    LittleEndian& zeros(int count)
    {
        for (int i = 0; i < count; ++i) words({0});
        return *this;
    }
    LittleEndian& wide(std::uint64_t value)
    {
        return words({static_cast<std::uint32_t>(value), static_cast<std::uint32_t>(value >> 32)});
    }
    LittleEndian& bytes(std::string_view all)
    {
        text_ += all;
        return *this;
    }
    LittleEndian& aligned(std::size_t to)
    {
        text_.resize((text_.size() + to - 1) / to * to);
        return *this;
    }
    std::size_t size() const { return text_.size(); }
    std::string text() && { return std::move(text_); }

private:
    std::string text_;
};

/// Tells readers what the channels are (Khronos Data Format 1.3, section 5): 24 bytes and 16 a channel, after the size.
std::string data_format(const FormatNumbers& f)
{
    const std::uint32_t size = 24 + 16 * f.channels;
    const std::uint32_t color_model = 1, primaries = 1, transfer = f.is_srgb ? 2 : 1; // RGBSDA, BT.709, sRGB or linear
    LittleEndian block;
    block.words(
        {4 + size, 0, 2U | size << 16, color_model | primaries << 8 | transfer << 16, 0, f.channels * f.bits / 8, 0});
    constexpr std::uint32_t alpha = 15, is_linear = 0x10, is_signed = 0x40, is_float = 0x80;
    for (std::uint32_t channel = 0; channel < f.channels; ++channel) {
        std::uint32_t type = channel == 3 ? alpha : channel;
        if (f.is_srgb && channel == 3) type |= is_linear;
        if (f.is_real) type |= is_float | is_signed;
        const std::uint32_t lower = f.is_real ? std::bit_cast<std::uint32_t>(-1.0f) : 0,
                            upper = f.is_real ? std::bit_cast<std::uint32_t>(1.0f) : (1U << f.bits) - 1;
        block.words({channel * f.bits | (f.bits - 1) << 16 | type << 24, 0, lower, upper});
    }
    return std::move(block).text();
}

/// Names and values, sorted by names: rows go down, and who wrote the file.
std::string key_values()
{
    LittleEndian entries;
    for (const std::string_view entry :
         {std::string_view("KTXorientation\0rd\0", 18), std::string_view("KTXwriter\0poissonlab\0", 21)})
        entries.words({static_cast<std::uint32_t>(entry.size())}).bytes(entry).aligned(4);
    return std::move(entries).text();
}

}

std::size_t texel_bytes(GpuFormat format)
{
    const FormatNumbers f = numbers_of(format);
    return f.channels * f.bits / 8;
}

std::string dds_file(const GpuTexture& texture)
{
    const FormatNumbers f = numbers_of(texture.format);
    const auto width = static_cast<std::uint32_t>(texture.width), height = static_cast<std::uint32_t>(texture.height),
               layers = static_cast<std::uint32_t>(texture.layers),
               levels = static_cast<std::uint32_t>(texture.levels.size());
    // The header has capabilities, height, width, pitch, format and levels; capabilities: a texture, with levels or
    // layers.
    constexpr std::uint32_t has_all = 0x1 | 0x2 | 0x4 | 0x8 | 0x1000 | 0x20000;
    const std::uint32_t capabilities = 0x1000U | (levels > 1 ? 0x400008U : 0) | (texture.is_array ? 0x8U : 0);
    constexpr std::uint32_t two_dimensional = 3, has_code = 4;
    LittleEndian file;
    file.bytes("DDS ").words({124, has_all, height, width, width * f.channels * f.bits / 8, 0, levels}).zeros(11);
    file.words({32, has_code}).bytes("DX10").zeros(5).words({capabilities}).zeros(4);
    file.words({f.dxgi, two_dimensional, 0, layers, 0});
    for (std::size_t layer = 0; layer < layers; ++layer)
        for (const std::string& level : texture.levels) {
            const std::size_t size = level.size() / layers;
            file.bytes(std::string_view(level).substr(layer * size, size));
        }
    return std::move(file).text();
}

std::string ktx2_file(const GpuTexture& texture)
{
    const FormatNumbers f = numbers_of(texture.format);
    const auto levels = static_cast<std::uint32_t>(texture.levels.size());
    const std::string format = data_format(f), entries = key_values();
    const std::uint32_t format_at = 80 + 24 * levels, // behind the header and the places of levels
        entries_at = format_at + static_cast<std::uint32_t>(format.size());
    // Levels lie from the smallest to the largest, at multiples of a texel's bytes.
    const std::size_t step = std::max<std::size_t>(4, texel_bytes(texture.format));
    std::vector<std::size_t> places(levels);
    std::size_t end = entries_at + entries.size();
    for (std::size_t level = levels; level-- > 0;) {
        places[level] = (end + step - 1) / step * step;
        end = places[level] + texture.levels[level].size();
    }
    LittleEndian file;
    file.bytes(std::string_view("\xABKTX 20\xBB\r\n\x1A\n", 12));
    file.words({f.vulkan, f.bits / 8, static_cast<std::uint32_t>(texture.width),
                static_cast<std::uint32_t>(texture.height), 0,
                texture.is_array ? static_cast<std::uint32_t>(texture.layers) : 0, 1, levels, 0});
    file.words(
        {format_at, static_cast<std::uint32_t>(format.size()), entries_at, static_cast<std::uint32_t>(entries.size())});
    file.wide(0).wide(0); // nothing is compressed
    for (std::size_t level = 0; level < levels; ++level)
        file.wide(places[level]).wide(texture.levels[level].size()).wide(texture.levels[level].size());
    file.bytes(format).bytes(entries);
    for (std::size_t level = levels; level-- > 0;) file.aligned(step).bytes(texture.levels[level]);
    return std::move(file).text();
}

}
