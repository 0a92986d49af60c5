#include "analysis/square_header.hpp"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfCompression.h>

#include <stdexcept>

namespace poissonlab {
namespace {

constexpr int max_size = 1 << 15; // a larger picture is a damaged header

/// Bytes of pixels for each byte of the file, at most: what deflate, the best of the usual ones, makes of zeros.
constexpr std::uintmax_t largest_ratio = 1032;

std::size_t float_channels(const Imf::Header& header)
{
    std::size_t count = 0;
    for (auto it = header.channels().begin(); it != header.channels().end(); ++it)
        if (has_float_channel(header, it.name())) ++count;
    return count;
}

}

bool has_float_channel(const Imf::Header& header, const std::string& name)
{
    const Imf::Channel* channel = header.channels().findChannel(name);
    return channel && channel->type == Imf::FLOAT && channel->xSampling == 1 && channel->ySampling == 1;
}

int checked_square_size(const Imf::Header& header, const std::filesystem::path& file)
{
    const auto& window = header.dataWindow();
    const int width = window.max.x - window.min.x + 1;
    const int height = window.max.y - window.min.y + 1;
    if (window.min.x != 0 || window.min.y != 0 || width != height)
        throw std::runtime_error("it must be a square with its corner at (0, 0)");
    if (width > max_size)
        throw std::runtime_error("it has " + std::to_string(width) + " pixels along each axis; must have at most " +
                                 std::to_string(max_size));

    std::error_code unknown;
    const std::uintmax_t bytes = std::filesystem::file_size(file, unknown);
    const std::uintmax_t ratio = header.compression() == Imf::NO_COMPRESSION ? 1 : largest_ratio;
    const std::uintmax_t row = std::uintmax_t{4} * static_cast<unsigned>(width) * float_channels(header);
    if (!unknown && row * static_cast<unsigned>(height) / ratio > bytes)
        throw std::runtime_error("its " + std::to_string(bytes) + " bytes are too few for its " + std::to_string(width) +
                                 " x " + std::to_string(height) + " pixels");
    return width;
}

}
