// An 8-bit grey image and its PNG file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace poissonlab {

/// Row-major, row 0 at the top.
struct GreyImage
{
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> pixels;

    GreyImage(int w, int h, std::uint8_t grey)
        : width(w), height(h), pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), grey)
    {}

    std::uint8_t& at(int column, int row)
    {
        return pixels[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(column)];
    }
};

/// Writes a PNG whose bytes depend on the pixels only (no date, no program name). Throws StorageError.
void write_png(const std::filesystem::path& path, const GreyImage& image);

}
