#include "base/images/square_header.hpp"

#include "base/errors/errors.hpp"
#include "base/files/byte_order.hpp"

#include <OpenEXR/ImfChannelList.h>

#include <algorithm>
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
constexpr double largest_ratio = 1032;

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
        check_pixels();
    }

private:
    std::uint32_t word()
    {
        std::string bytes(sizeof(std::uint32_t), '\0');
        if (!file_.read(bytes.data(), static_cast<std::streamsize>(bytes.size()))) fail();
        return load<std::uint32_t>(bytes, std::endian::little);
    }

    std::int32_t number() { return static_cast<std::int32_t>(word()); }

    char byte()
    {
        char byte = 0;
        if (!file_.get(byte)) fail();
        return byte;
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
            {"box2i", 16},    {"box2f", 16}, {"compression", 1}, {"double", 8}, {"float", 4}, {"int", 4},
            {"lineOrder", 1}, {"v2f", 8},    {"v2i", 8},         {"v3f", 12},   {"v3i", 12},  {"chromaticities", 32}};
        const std::string type = text();
        const std::uint32_t bytes = word();
        const std::uintmax_t end = place() + bytes;
        if (type == "chlist") {
            while (!text().empty()) read_channel(); // OpenEXR, too, goes on to the empty name
        } else if (name == "dataWindow" && type == "box2i") {
            read_window();
        } else if (name == "compression" && type == "compression") {
            is_compressed_ = byte() != 0;
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

    /// The description of a channel, after its name.
    void read_channel()
    {
        constexpr std::uint32_t half = 1;
        const double bytes = word() == half ? 2 : 4;
        skip(4);
        const double x_sampling = std::max(1, number());
        const double y_sampling = std::max(1, number());
        bytes_per_pixel_ += bytes / (x_sampling * y_sampling);
    }

    void read_window()
    {
        const std::int64_t left = number();
        const std::int64_t bottom = number();
        width_ = number() - left + 1;
        height_ = number() - bottom + 1;
    }

    /// OpenEXR takes memory for some rows when it opens a file, however short that is. Windows of less than one pixel
    /// it refuses by itself.
    void check_pixels() const
    {
        if (width_ < 1 || height_ < 1) return;
        const double most = static_cast<double>(size_) * (is_compressed_ ? largest_ratio : 1);
        if (bytes_per_pixel_ * static_cast<double>(width_) * static_cast<double>(height_) > most)
            throw std::runtime_error("its " + std::to_string(size_) + " bytes are too few for its " +
                                     std::to_string(width_) + " x " + std::to_string(height_) + " pixels");
    }

    [[noreturn]] static void fail() { throw std::runtime_error("its header is longer than the file"); }

    std::ifstream file_;
    std::uintmax_t size_ = 0; ///< of the file, in bytes
    std::int64_t width_ = 0;
    std::int64_t height_ = 0;
    double bytes_per_pixel_ = 0; ///< of all channels
    bool is_compressed_ = false;
};

}

void check_header_fits(const std::filesystem::path& file) { HeaderWalk(file).check(); }

bool has_float_channel(const Imf::Header& header, const std::string& name)
{
    const Imf::Channel* channel = header.channels().findChannel(name);
    return channel && channel->type == Imf::FLOAT && channel->xSampling == 1 && channel->ySampling == 1;
}

int checked_square_size(const Imf::Header& header)
{
    const auto& window = header.dataWindow();
    const int width = window.max.x - window.min.x + 1;
    const int height = window.max.y - window.min.y + 1;
    if (window.min.x != 0 || window.min.y != 0 || width != height)
        throw std::runtime_error("it must be a square with its corner at (0, 0)");
    if (width > max_size)
        throw std::runtime_error("it has " + std::to_string(width) + " pixels along each axis; must have at most " +
                                 std::to_string(max_size));
    return width;
}

}
