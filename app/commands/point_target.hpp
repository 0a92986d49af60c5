// The file that a command writes points to.
#pragma once

#include <filesystem>
#include <string>

namespace poissonlab {

/// Throws InputError where the folder of a file --out is not there, and where the file is a folder. `command` is
/// "distribute warp" and so on.
void check_target_folder(const std::string& command, const std::filesystem::path& file);

/// The same, and where the file has the name of a picture: any other name makes a point file. `or_pictures` are words
/// for the pictures that the command writes as well.
void check_point_target(const std::string& command, const std::filesystem::path& file,
                        const std::string& or_pictures = "");

}
