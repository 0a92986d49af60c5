// Links from pages to files beside them.
#pragma once

#include <filesystem>
#include <string>

namespace poissonlab {

/// The relative link from a folder to a file, with everything but unreserved characters percent-encoded.
std::string relative_link(const std::filesystem::path& from_folder, const std::filesystem::path& file);

}
