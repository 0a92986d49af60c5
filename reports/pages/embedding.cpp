#include "reports/pages/embedding.hpp"

#include "base/files/whole_file.hpp"

#include <fmt/format.h>

#include <cstdint>

namespace poissonlab {

std::string base64(std::string_view bytes)
{
    constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t group = 0;
        for (std::size_t j = 0; j < 3; ++j)
            group = group << 8 | (i + j < bytes.size() ? static_cast<std::uint8_t>(bytes[i + j]) : 0U);
        for (std::size_t j = 0; j < 4; ++j) text += i + j <= bytes.size() ? alphabet[group >> (18 - 6 * j) & 63U] : '=';
    }
    return text;
}

std::string data_uri(const std::filesystem::path& picture)
{
    const auto type = picture.extension() == ".svg" ? "svg+xml" : "png";
    return fmt::format("data:image/{};base64,{}", type, base64(read_whole_file(picture)));
}

std::string relative_link(const std::filesystem::path& from_folder, const std::filesystem::path& file)
{
    namespace fs = std::filesystem;
    const auto path = fs::weakly_canonical(file).lexically_relative(fs::weakly_canonical(from_folder)).generic_string();
    std::string link;
    for (const char c : path) {
        const bool plain = (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ||
                           std::string_view("-._~/").find(c) != std::string_view::npos;
        link += plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<std::uint8_t>(c));
    }
    return link;
}

}
