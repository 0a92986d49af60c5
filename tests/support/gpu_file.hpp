// DDS and KTX2 files taken apart as their specifications say, apart from the code that writes them.
#pragma once

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

namespace poissonlab::test {

/// The contents of a file: its format's number, and the texels of each level of each layer.
struct GpuFile
{
    std::uint32_t format = 0, width = 0, height = 0, layers = 0;
    std::vector<std::vector<std::string>> levels; ///< by level, then by layer

    std::size_t level_bytes(std::size_t level, std::size_t texel) const
    {
        const auto side = [&](std::uint32_t whole) { return std::max<std::size_t>(1, whole >> level); };
        return side(width) * side(height) * texel;
    }
};

inline std::uint32_t word_at(const std::string& bytes, std::size_t at)
{
    std::uint32_t word = 0;
    for (std::size_t i = 0; i < 4; ++i) word |= std::uint32_t{static_cast<unsigned char>(bytes.at(at + i))} << 8 * i;
    return word;
}

inline void demand(bool is_so, const char* what)
{
    if (!is_so) throw std::runtime_error(what);
}

/// `texel`: the bytes that a texel of the file should have. Layers follow each other, each with all its levels.
inline GpuFile read_dds(const std::string& bytes, std::size_t texel)
{
    demand(bytes.starts_with("DDS ") && word_at(bytes, 4) == 124 && word_at(bytes, 76) == 32, "sizes of headers");
    demand((word_at(bytes, 8) & 0x21007) == 0x21007 && (word_at(bytes, 80) & 4) != 0, "flags");
    demand(bytes.substr(84, 4) == "DX10" && word_at(bytes, 132) == 3, "a two-dimensional DX10 texture");
    GpuFile file{word_at(bytes, 128), word_at(bytes, 16), word_at(bytes, 12), word_at(bytes, 140), {}};
    demand(word_at(bytes, 20) == file.width * texel, "pitch");
    file.levels.resize(word_at(bytes, 28));
    demand((word_at(bytes, 108) & 0x1000) != 0 && ((word_at(bytes, 108) & 0x400000) != 0) == (file.levels.size() > 1),
           "capabilities");
    std::size_t at = 148;
    for (std::uint32_t layer = 0; layer < file.layers; ++layer)
        for (std::size_t level = 0; level < file.levels.size(); ++level) {
            const std::size_t size = file.level_bytes(level, texel);
            file.levels[level].push_back(bytes.substr(at, size));
            at += size;
        }
    demand(at == bytes.size(), "the file's length");
    return file;
}

/// Levels are found by their table; layers lie side by side within them.
inline GpuFile read_ktx2(const std::string& bytes, std::size_t texel)
{
    const unsigned char identifier[12] = {0xAB, 'K', 'T', 'X', ' ', '2', '0', 0xBB, '\r', '\n', 0x1A, '\n'};
    demand(std::memcmp(bytes.data(), identifier, 12) == 0, "identifier");
    GpuFile file{word_at(bytes, 12), word_at(bytes, 20), word_at(bytes, 24), word_at(bytes, 32), {}};
    demand(word_at(bytes, 28) == 0 && word_at(bytes, 36) == 1 && word_at(bytes, 44) == 0, "depth, faces, compression");
    const std::uint32_t levels = word_at(bytes, 40), format = word_at(bytes, 48), pairs = word_at(bytes, 56);
    demand(format == 80 + 24 * levels && word_at(bytes, format) == word_at(bytes, 52), "the data format's place");
    demand(word_at(bytes, format + 8) >> 16 == word_at(bytes, 52) - 4, "the basic block's length");
    demand((word_at(bytes, format + 20) & 255) == texel, "bytes of a texel");
    demand(pairs == format + word_at(bytes, 52), "the place of keys");
    for (std::size_t level = 0; level < levels; ++level) {
        const std::size_t entry = 80 + 24 * level, at = word_at(bytes, entry), length = word_at(bytes, entry + 8),
                          layers = std::max<std::size_t>(1, file.layers), size = file.level_bytes(level, texel);
        demand(at % std::max<std::size_t>(4, texel) == 0 && length == word_at(bytes, entry + 16), "a level's place");
        demand(length == size * layers && at + length <= bytes.size(), "a level's length");
        auto& all = file.levels.emplace_back();
        for (std::size_t layer = 0; layer < layers; ++layer) all.push_back(bytes.substr(at + layer * size, size));
    }
    demand(word_at(bytes, 80) + word_at(bytes, 88) == bytes.size(), "level 0 comes last");
    file.layers = std::max(1U, file.layers);
    return file;
}

}
