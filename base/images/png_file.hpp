// PNG files of 8-bit and 16-bit channels.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

namespace poissonlab {

/// Channels side by side, row by row from the top.
struct PngPixels
{
    int width = 0;
    int height = 0;
    int channels = 1;
    std::vector<std::uint8_t> values;

    std::size_t at(int column, int row, int channel) const
    {
        return (static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column)) *
                   static_cast<std::size_t>(channels) +
               static_cast<std::size_t>(channel);
    }
};

/// The channels of a PNG file, and how hard libpng tries to make it small.
struct PngLayout
{
    int width = 0;
    int height = 0;
    int channels = 1;
    int compression = -1; ///< zlib's level from 0 to 9; -1: the default
    bool filters = true;  ///< whether rows are predicted from their neighbours
    int rows_at_once = 0; ///< that are asked for at a time; 0: all
};

/// The pixels of `count` rows from row `first` on; valid until the next call.
using PngRows = std::function<const std::uint8_t*(int first, int count)>;

/// Writes a PNG whose bytes depend on the arguments only (no date, no program name). Throws StorageError.
void write_png(const std::filesystem::path& path, const PngLayout& layout, const PngRows& rows);

/// Writes a whole picture as a PNG, as above.
void write_png(const std::filesystem::path& path, const PngPixels& pixels);

/// Reads a PNG as 8-bit channels. Throws StorageError.
PngPixels read_png(const std::filesystem::path& path);

/// Pixels with 16 bits a channel.
struct DeepPixels
{
    int width = 0;
    int height = 0;
    int channels = 1;
    std::vector<std::uint16_t> values;
};

/// Writes a PNG as write_png() does. Throws StorageError.
void write_deep_png(const std::filesystem::path& path, const DeepPixels& pixels);

/// Reads a PNG as 16-bit channels. Throws StorageError.
DeepPixels read_deep_png(const std::filesystem::path& path);

/// Pictures that are read may have this many values: more is a header that lies.
inline constexpr std::size_t most_png_values = std::size_t{1} << 30;

}
