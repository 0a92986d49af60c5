// The kind of a file that a user named, by its name or by what stands in its place.
#pragma once

#include <filesystem>
#include <string>

namespace poissonlab {

/// The words for a path that is not that of a file: "no such file", "is a folder, no file", "is a device, no file", "is
/// a pipe, no file". Empty for a file.
std::string lack_of_file(const std::filesystem::path& path);

/// True where the text is the name of a file.
bool is_file_name(const std::string& text);

/// True if the name ends as those of pictures do, in small letters or capitals: ".png", ".gif" and so on.
bool has_picture_name(const std::filesystem::path& path);

}
