#include "reports/pages/relative_link.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <string_view>

namespace poissonlab {

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
