#include "base/images/raw_picture.hpp"

#include "base/errors/errors.hpp"
#include "base/files/file_kind.hpp"
#include "base/files/whole_file.hpp"
#include "base/images/float_image.hpp"
#include "base/images/loaded_codec.hpp"
#include "base/images/png_damage.hpp"

#include <fmt/format.h>

#include <cstring>
#include <functional>

namespace poissonlab {
namespace {

constexpr int most_png_channels = 4;

/// Lets a function of the codec read a file in which `damage` finds nothing wrong; each returns what went wrong.
void read_by_codec(const std::filesystem::path& path, std::string (*damage)(const std::filesystem::path&),
                   const std::function<std::string()>& read)
{
    std::string problem = lack_of_file(path);
    if (problem.empty()) problem = damage(path);
    if (problem.empty()) problem = read();
    if (!problem.empty()) throw InputError(fmt::format("{}: cannot read the picture: {}", path.string(), problem));
}

FloatImage float_image_of(const RawPicture& picture)
{
    FloatImage image;
    image.width = picture.width;
    image.height = picture.height;
    const std::size_t pixels = static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
    for (std::size_t channel = 0; channel < picture.channels.size(); ++channel) {
        std::vector<float>& values = image.channels[picture.channels[channel]];
        values.resize(pixels);
        for (std::size_t i = 0; i < pixels; ++i) // copied, not converted: NaNs keep their bits
            std::memcpy(&values[i], &picture.bytes[(i * picture.channels.size() + channel) * sizeof(float)],
                        sizeof(float));
    }
    return image;
}

}

PictureHeader read_picture_header(const std::filesystem::path& path)
{
    PictureHeader header;
    read_by_codec(path, png_damage, [&] { return loaded_codec().read_header(path, header); });
    return header;
}

bool is_kept_raw(const PictureHeader& header)
{
    return header.type && (*header.type == SampleType::real || header.channels <= most_png_channels);
}

RawPicture read_raw_picture(const std::filesystem::path& path)
{
    PictureHeader header; // whose file is checked as a whole when its pixels are read
    read_by_codec(path, png_header_damage, [&] { return loaded_codec().read_header(path, header); });
    if (!is_kept_raw(header))
        throw InputError(fmt::format("{}: must have numbers of 8 or 16 bits in at most {} channels, or of float16 or "
                                     "float32",
                                     path.string(), most_png_channels));
    RawPicture picture;
    read_by_codec(path, png_damage, [&] { return loaded_codec().read_raw(path, picture); });
    return picture;
}

const char* raw_ending(SampleType type) { return type == SampleType::real ? ".exr" : ".png"; }

void write_raw_picture(const std::filesystem::path& path, const RawPicture& picture)
{
    if (picture.type == SampleType::real) return write_float_image(path, float_image_of(picture));
    write_whole_file(path, [&](const std::filesystem::path& temporary) {
        const std::string problem = loaded_codec().write_raw(temporary, picture);
        if (!problem.empty()) throw StorageError(path.string() + ": cannot write the picture: " + problem);
    });
}

}
