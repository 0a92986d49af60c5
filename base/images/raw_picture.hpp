// Pictures as their files have them: no colour becomes light, and nothing is multiplied by alpha.
#pragma once

#include "base/word_table.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

/// The numbers of a picture's channels.
enum class SampleType
{
    byte, ///< 8 bits
    word, ///< 16 bits
    real, ///< float32, which holds each float16 as well
};
inline constexpr WordTable<SampleType, 3> sample_types{
    {{{SampleType::byte, "8 bits"}, {SampleType::word, "16 bits"}, {SampleType::real, "floating point"}}}};

/// Pixels row by row from the top, channels side by side, each number in the order of this machine's bytes.
struct RawPicture
{
    int width = 0;
    int height = 0;
    SampleType type = SampleType::byte;
    std::vector<std::string> channels; ///< their names: "R", "G", "B", "A", "Y" or what the file says
    std::vector<std::uint8_t> bytes;

    std::size_t pixel_bytes() const
    {
        return channels.size() * (type == SampleType::byte ? 1 : type == SampleType::word ? 2 : 4);
    }
    std::size_t at(int column, int row) const ///< the first byte of a pixel
    {
        return (static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column)) *
               pixel_bytes();
    }
};

/// The head of a picture's file, before its pixels.
struct PictureHeader
{
    int width = 0; ///< upright, whichever way it was photographed
    int height = 0;
    int channels = 0;
    std::optional<SampleType> type; ///< nothing: numbers of another kind
};

/// Read the header of a picture file, and the picture. Throw InputError, one line with the file's name, for files that
/// are no pictures or damaged. Pixels are read of pictures with a type that have at most four channels, or are of
/// float32.
PictureHeader read_picture_header(const std::filesystem::path& path);
RawPicture read_raw_picture(const std::filesystem::path& path);

/// True if read_raw_picture() takes such a picture, and write_raw_picture() writes it.
bool is_kept_raw(const PictureHeader& header);

/// The ending of files with numbers of this type: ".png", or ".exr" of float32.
const char* raw_ending(SampleType type);

/// Writes PNG or OpenEXR, as the type has it. Throws StorageError.
void write_raw_picture(const std::filesystem::path& path, const RawPicture& picture);

}
