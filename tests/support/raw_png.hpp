// PNG files sample by sample, as libpng has them: no gamma, no alpha, no other depth.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace poissonlab::test {

struct RawPng
{
    int width = 0;
    int height = 0;
    int channels = 1;
    int bits = 8;                       ///< of a sample: 8 or 16
    std::vector<std::uint16_t> samples; ///< channels side by side, row by row from the top

    const std::uint16_t* pixel(int column, int row) const
    {
        return &samples[(static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                         static_cast<std::size_t>(column)) *
                        static_cast<std::size_t>(channels)];
    }
};

/// These functions throw std::runtime_error.
RawPng read_raw_png(const std::filesystem::path& path);
void write_raw_png(const std::filesystem::path& path, const RawPng& picture);

}
