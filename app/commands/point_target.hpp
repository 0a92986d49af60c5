// The file that a command writes points to.
#pragma once

#include <filesystem>
#include <string>

namespace poissonlab {

/// Throws InputError where the file has the name of a picture: any other name makes a point file. `command` is
/// "distribute warp" and so on, `or_pictures` are words for the pictures that it writes as well.
void check_point_target(const std::string& command, const std::filesystem::path& file,
                        const std::string& or_pictures = "");

}
