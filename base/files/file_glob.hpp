// Files that a config names by a path or a glob.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace poissonlab {

/// The files that `entry`, relative to `folder`, stands for: the file of just that name, so that names with brackets
/// need no escapes; else those that it matches as a glob, sorted by the bytes of their names (not by the rules of a
/// locale). Empty: none.
std::vector<std::filesystem::path> named_files(const std::filesystem::path& folder, const std::string& entry);

/// The words of messages about a file that is missing: "no such file in /data, the folder of the config" for a path
/// relative to `folder`, or "no such file" for an absolute one.
std::string no_such_file(const std::filesystem::path& folder, const std::string& entry);

}
