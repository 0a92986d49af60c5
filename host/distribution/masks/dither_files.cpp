#include "host/distribution/masks/dither_files.hpp"

#include "base/files/npy_header.hpp"
#include "base/files/whole_file.hpp"
#include "base/images/png_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

namespace poissonlab {

void write_dither_mask(const std::filesystem::path& file, const DitherMask& mask)
{
    const auto side = static_cast<int>(mask.size);
    if (file.extension() == ".npy")
        return write_whole_file(file, npy_header_of(fmt::format("'{}u4'", npy_byte_order()),
                                                    fmt::format("({}, {})", mask.size, mask.size)) +
                                          std::string(reinterpret_cast<const char*>(mask.ranks.data()),
                                                      mask.ranks.size() * sizeof(std::uint32_t)));
    if (mask.levels > 256) {
        DeepPixels pixels{side, side, 1, {}};
        for (std::size_t i = 0; i < mask.pixels(); ++i)
            pixels.values.push_back(static_cast<std::uint16_t>(mask.threshold(i, 65'536)));
        return write_deep_png(file, pixels);
    }
    std::vector<std::uint8_t> pixels;
    for (std::size_t i = 0; i < mask.pixels(); ++i) pixels.push_back(static_cast<std::uint8_t>(mask.threshold(i, 256)));
    write_png(file, {side, side, 1},
              [&](int first, int) { return &pixels[static_cast<std::size_t>(first) * mask.size]; });
}

void write_threshold_strip(const std::filesystem::path& file, const DitherMask& mask)
{
    constexpr std::uint32_t shown = 4, gap = 8; // by as many
    const std::uint32_t part = std::min(mask.size, 128u), width = shown * part + (shown - 1) * gap;
    const std::uint32_t height = 2 * part + gap;
    std::vector<std::uint8_t> pixels(std::size_t{width} * height, 200);
    for (std::uint32_t i = 0; i < 2 * shown; ++i)
        for (std::uint32_t y = 0; y < part; ++y)
            for (std::uint32_t x = 0; x < part; ++x) {
                const bool is_below =
                    std::uint64_t{mask.ranks[std::size_t{y} * mask.size + x]} * 16 < std::uint64_t{i + 1} * mask.levels;
                pixels[std::size_t{y + i / shown * (part + gap)} * width + x + i % shown * (part + gap)] =
                    is_below ? 0 : 255;
            }
    write_png(file, {static_cast<int>(width), static_cast<int>(height), 1},
              [&](int first, int) { return &pixels[static_cast<std::size_t>(first) * width]; });
}

}
