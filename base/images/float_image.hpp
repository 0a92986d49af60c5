// Square images of float32 with named channels and texts, as OpenEXR files. No other file knows OpenEXR.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace poissonlab {

struct FloatImage
{
    int width = 0;
    int height = 0;
    std::map<std::string, std::vector<float>> channels; ///< each row after row, in the order of the file
    std::map<std::string, std::string> texts;           ///< attributes of the type "string"

    /// Throws std::runtime_error where there is no such text.
    const std::string& text(const std::string& name) const;
};

/// The prefix of metadata among the texts: such names never clash with those that mean something to OpenEXR
/// ("type").
inline constexpr const char* metadata_prefix = "poissonlab:meta:";

/// Writes an image, which need not be square, uncompressed: what the laboratory stores is noise. Writes to a temporary
/// name, then renames. Throws StorageError.
void write_float_image(const std::filesystem::path& path, const FloatImage& image);

/// Reads all channels of float32 of a square image whose corner is at (0, 0), and leaves out others. Throws
/// std::runtime_error, without the file's name, for files that are not such images: damaged ones take no more memory
/// than some times that of the file.
FloatImage read_float_image(const std::filesystem::path& path);

}
