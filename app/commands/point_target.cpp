#include "app/commands/point_target.hpp"

#include "base/errors/errors.hpp"
#include "base/files/file_kind.hpp"

#include <fmt/format.h>

namespace poissonlab {

void check_point_target(const std::string& command, const std::filesystem::path& file, const std::string& or_pictures)
{
    if (has_picture_name(file))
        throw InputError(fmt::format("{}: --out {}: is the name of a picture; must be a point file, such as .txt, "
                                     ".csv, .npy, .h5, .ply, .usda{}",
                                     command, printable(file.string()), or_pictures));
}

}
