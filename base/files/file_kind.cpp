#include "base/files/file_kind.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <system_error>

namespace poissonlab {

std::string lack_of_file(const std::filesystem::path& path)
{
    using Type = std::filesystem::file_type;
    std::error_code unknown;
    switch (std::filesystem::status(path, unknown).type()) {
    case Type::regular:
        return {};
    case Type::directory:
        return "is a folder, no file";
    case Type::character:
    case Type::block:
        return "is a device, no file";
    case Type::fifo:
    case Type::socket:
        return "is a pipe, no file";
    default:
        return "no such file";
    }
}

bool is_file_name(const std::string& text)
{
    std::error_code error;
    return std::filesystem::is_regular_file(text, error);
}

bool has_picture_name(const std::filesystem::path& path)
{
    constexpr std::array<std::string_view, 19> endings{".bmp", ".eps", ".exr",  ".gif", ".hdr", ".jp2", ".jpeg",
                                                       ".jpg", ".pbm", ".pdf",  ".pgm", ".png", ".pnm", ".ppm",
                                                       ".svg", ".tga", ".tiff", ".tif", ".webp"};
    std::string ending = path.extension().string();
    std::ranges::transform(ending, ending.begin(),
                           [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); });
    return std::ranges::find(endings, ending) != endings.end();
}

}
