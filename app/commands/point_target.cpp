#include "app/commands/point_target.hpp"

#include "base/errors/errors.hpp"
#include "base/files/file_kind.hpp"

#include <fmt/format.h>

#include <system_error>

namespace poissonlab {

void check_target_folder(const std::string& command, const std::filesystem::path& file)
{
    const std::string begin = fmt::format("{}: --out {}: ", command, printable(file.string()));
    const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
    std::error_code unknown;
    if (!std::filesystem::is_directory(folder, unknown))
        throw InputError(begin + "there is no folder " + printable(folder.string()));
    if (std::filesystem::is_directory(file, unknown)) throw InputError(begin + "is a folder");
}

void check_point_target(const std::string& command, const std::filesystem::path& file, const std::string& or_pictures)
{
    if (has_picture_name(file))
        throw InputError(fmt::format("{}: --out {}: is the name of a picture; must be a point file, such as .txt, "
                                     ".csv, .npy, .h5, .ply, .usda{}",
                                     command, printable(file.string()), or_pictures));
    check_target_folder(command, file);
}

}
