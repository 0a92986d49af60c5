// Words for what stands in the place of a file that a user named.
#pragma once

#include <filesystem>
#include <string>

namespace poissonlab {

/// The words for a path that is not that of a file: "no such file", "is a folder, no file", "is a device, no file", "is
/// a pipe, no file". Empty for a file.
std::string lack_of_file(const std::filesystem::path& path);

}
