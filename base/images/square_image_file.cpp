#include "base/images/square_image_file.hpp"

#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"
#include "base/images/square_header.hpp"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfCompression.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <algorithm>
#include <stdexcept>

namespace poissonlab {

namespace {

const std::string metadata_prefix = "poissonlab:meta:"; // as in spectra

Imf::FrameBuffer frame_buffer(std::vector<float>& pixels, int size)
{
    Imf::FrameBuffer frame;
    frame.insert("Y", Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(pixels.data()), sizeof(float),
                                 sizeof(float) * static_cast<std::size_t>(size)));
    return frame;
}

/// Rows from the highest to the lowest y instead of the other way round, or back.
template <class From, class To>
void turn_over(const std::vector<From>& from, std::vector<To>& to, int size)
{
    const auto width = static_cast<std::size_t>(size);
    to.resize(from.size());
    for (std::size_t row = 0; row < width; ++row)
        std::transform(from.begin() + static_cast<std::ptrdiff_t>(row * width),
                       from.begin() + static_cast<std::ptrdiff_t>((row + 1) * width),
                       to.begin() + static_cast<std::ptrdiff_t>((width - 1 - row) * width),
                       [](From value) { return static_cast<To>(value); });
}

int checked_size(const Imf::Header& header)
{
    if (!has_float_channel(header, "Y")) throw std::runtime_error("there is no float32 channel \"Y\"");
    return checked_square_size(header);
}

}

void write_square_image(const std::filesystem::path& path, const SquareImage& image,
                        const std::map<std::string, std::string>& metadata)
{
    std::vector<float> pixels;
    turn_over(image.pixels, pixels, image.size);
    write_whole_file(path, [&](const std::filesystem::path& temporary) {
        try {
            Imf::Header header(image.size, image.size);
            header.channels().insert("Y", Imf::Channel(Imf::FLOAT));
            header.compression() = Imf::NO_COMPRESSION; // mostly noise
            for (const auto& [name, value] : metadata)
                header.insert(metadata_prefix + name, Imf::StringAttribute(value));
            Imf::OutputFile file(temporary.c_str(), header);
            file.setFrameBuffer(frame_buffer(pixels, image.size));
            file.writePixels(image.size);
        } catch (const std::exception& error) {
            throw StorageError(path.string() + ": cannot be written: " + error.what());
        }
    });
}

SquareImage read_square_image(const std::filesystem::path& path)
{
    try {
        check_header_fits(path);
        Imf::InputFile file(path.c_str());
        SquareImage image{checked_size(file.header()), {}};
        std::vector<float> pixels(static_cast<std::size_t>(image.size) * static_cast<std::size_t>(image.size));
        file.setFrameBuffer(frame_buffer(pixels, image.size));
        file.readPixels(0, image.size - 1);
        turn_over(pixels, image.pixels, image.size);
        return image;
    } catch (const std::exception& error) {
        throw InputError(path.string() + ": not a square image: " + error.what());
    }
}

}
