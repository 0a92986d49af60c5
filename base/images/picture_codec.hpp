// The functions by which this room calls the module with OpenImageIO, the library of every picture file: PNG files are
// written and read, pictures of any kind are read as light or as they are.
#pragma once

#include "base/images/linear_picture.hpp"
#include "base/images/png_file.hpp"
#include "base/images/raw_picture.hpp"

#include <filesystem>
#include <string>

namespace poissonlab {

/// Reads and writes picture files. All functions return what went wrong, empty where all went well.
class PictureCodec
{
public:
    virtual ~PictureCodec() = default;
    virtual std::string write(const std::filesystem::path& path, const PngLayout& layout,
                              const PngRows& rows) const = 0;
    virtual std::string read(const std::filesystem::path& path, PngPixels& pixels) const = 0;
    virtual std::string write_deep(const std::filesystem::path& path, const DeepPixels& pixels) const = 0;
    virtual std::string read_deep(const std::filesystem::path& path, DeepPixels& pixels) const = 0;
    virtual std::string read_linear(const std::filesystem::path& path, AlphaUse use, LinearPicture& picture) const = 0;
    virtual std::string read_header(const std::filesystem::path& path, PictureHeader& header) const = 0;
    virtual std::string read_raw(const std::filesystem::path& path, RawPicture& picture) const = 0;
    virtual std::string write_raw(const std::filesystem::path& path, const RawPicture& picture) const = 0;
};

/// The function of the module that returns its codec, which lives as long as the module.
using PictureCodecFunction = const PictureCodec* (*)();
inline constexpr const char* picture_codec_function = "poissonlab_picture_codec";

}
