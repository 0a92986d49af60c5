#include "base/files/file_kind.hpp"

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

}
