#include "analysis/square_header.hpp"

#include "errors/errors.hpp"
#include "io/byte_order.hpp"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfCompression.h>

#include <cerrno>
#include <cstdint>
#include <fstream>
#include <map>
#include <stdexcept>
#include <system_error>

namespace poissonlab {
namespace {

constexpr int max_size = 1 << 15; // a larger picture is a damaged header

/// Bytes of pixels for each byte of the file, at most: what deflate, the best of the usual ones, makes of zeros.
constexpr std::uintmax_t largest_ratio = 1032;

/// Reads a header, attribute by attribute: https://openexr.com/en/latest/OpenEXRFileLayout.html.
class HeaderWalk
{
public:
    explicit HeaderWalk(const std::filesystem::path& file)
    {
        std::error_code error;
        size_ = std::filesystem::file_size(file, error); // an error for what is no file: a pipe would not open
        if (!error) {
            file_.open(file, std::ios::binary);
            if (!file_) error = {errno, std::generic_category()};
        }
        if (error) throw std::runtime_error("cannot be read: " + error.message());
    }

    void check()
    {
        constexpr std::uint32_t magic = 20000630, version = 2, long_names = 0x400;
        if (word() != magic) throw std::runtime_error("is no OpenEXR file");
        if ((word() & ~long_names) != version) throw std::runtime_error("has tiles, deep pixels or several parts");
        for (std::string name = text(); !name.empty(); name = text()) check_attribute(name);
    }

private:
    std::uint32_t word()
    {
        std::string bytes(sizeof(std::uint32_t), '\0');
        if (!file_.read(bytes.data(), static_cast<std::streamsize>(bytes.size()))) fail();
        return load<std::uint32_t>(bytes, std::endian::little);
    }

    /// A text, which ends with a zero.
    std::string text()
    {
        std::string text;
        if (!std::getline(file_, text, '\0')) fail();
        return text;
    }

    std::uintmax_t place() { return static_cast<std::uintmax_t>(file_.tellg()); }

    void skip(std::uintmax_t bytes)
    {
        if (place() > size_ || bytes > size_ - place()) fail();
        file_.seekg(static_cast<std::streamoff>(bytes), std::ios::cur);
    }

    /// OpenEXR reads values of most types without a look at how long they are said to be, so that these must be right.
    void check_attribute(const std::string& name)
    {
        static const std::map<std::string, std::uint32_t> sizes{
            {"box2i", 16}, {"box2f", 16}, {"compression", 1}, {"double", 8}, {"float", 4}, {"int", 4},
            {"lineOrder", 1}, {"v2f", 8}, {"v2i", 8}, {"v3f", 12}, {"v3i", 12}, {"chromaticities", 32}};
        const std::string type = text();
        const std::uint32_t bytes = word();
        const std::uintmax_t end = place() + bytes;
        if (type == "chlist") {
            while (place() < end && !text().empty()) skip(channel_size);
        } else if (const auto fixed = sizes.find(type); fixed != sizes.end()) {
            skip(fixed->second);
        } else if (type == "string") {
            skip(bytes);
        } else {
            throw std::runtime_error("its attribute " + shortened(name) + " has the type " + shortened(type) +
                                     ", which is none of those of such images");
        }
        if (place() != end)
            throw std::runtime_error("its attribute " + shortened(name) + " has another length than it says");
    }

    static constexpr std::uint32_t channel_size = 16; ///< of the description of a channel, after its name

    [[noreturn]] static void fail() { throw std::runtime_error("its header is longer than the file"); }

    std::ifstream file_;
    std::uintmax_t size_ = 0;
};

std::size_t float_channels(const Imf::Header& header)
{
    std::size_t count = 0;
    for (auto it = header.channels().begin(); it != header.channels().end(); ++it)
        if (has_float_channel(header, it.name())) ++count;
    return count;
}

}

void check_header_fits(const std::filesystem::path& file) { HeaderWalk(file).check(); }

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
        throw std::runtime_error("its " + std::to_string(bytes) + " bytes are too few for its " +
                                 std::to_string(width) + " x " + std::to_string(height) + " pixels");
    return width;
}

}
