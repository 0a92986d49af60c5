// Between png_file.cpp and the module that holds OpenImageIO.
#pragma once

#include "base/images/png_file.hpp"

#include <filesystem>
#include <string>

namespace poissonlab {

/// Reads and writes PNG files. Both return what went wrong, empty where all went well.
class PngCodec
{
public:
    virtual ~PngCodec() = default;
    virtual std::string write(const std::filesystem::path& path, const PngLayout& layout,
                              const PngRows& rows) const = 0;
    virtual std::string read(const std::filesystem::path& path, PngPixels& pixels) const = 0;
};

/// The function of the module that returns its codec, which lives as long as the module.
using PngCodecFunction = const PngCodec* (*)();
inline constexpr const char* png_codec_function = "poissonlab_png_codec";

}
