#include "base/files/file_glob.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include <glob.h>

namespace poissonlab {
namespace {

/// `text` as a glob that matches only itself.
std::string escaped_for_glob(const std::string& text)
{
    std::string result;
    for (const char c : text) {
        if (std::string_view("*?[\\").find(c) != std::string_view::npos) result += '\\';
        result += c;
    }
    return result;
}

std::vector<std::filesystem::path> matches(const std::string& pattern)
{
    glob_t found{};
    std::vector<std::filesystem::path> files;
    if (::glob(pattern.c_str(), GLOB_NOSORT, nullptr, &found) == 0) {
        files.assign(found.gl_pathv, found.gl_pathv + found.gl_pathc);
    }
    ::globfree(&found);
    std::ranges::sort(files, {}, &std::filesystem::path::native);
    return files;
}

}

std::vector<std::filesystem::path> named_files(const std::filesystem::path& folder, const std::string& entry)
{
    const std::filesystem::path literal = folder / entry;
    std::error_code none; // a name that is too long is that of no file
    if (std::filesystem::exists(literal, none)) return {literal};
    if (std::filesystem::path(entry).is_absolute()) return matches(entry);
    return matches((escaped_for_glob(folder.string()) / std::filesystem::path(entry)).string());
}

std::string no_such_file(const std::filesystem::path& folder, const std::string& entry)
{
    if (std::filesystem::path(entry).is_absolute()) return "no such file";
    // The folder of a config that is named without one is "": absolute() takes that for no path at all.
    const auto whole = folder.empty() ? std::filesystem::current_path() : std::filesystem::absolute(folder);
    return fmt::format("no such file in {}, the folder of the config", whole.lexically_normal().string());
}

}
