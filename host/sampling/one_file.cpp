#include "host/sampling/one_file.hpp"

#include "base/files/file_glob.hpp"

#include <fmt/format.h>

namespace poissonlab {

std::filesystem::path one_file(const Parameters& given, const std::string& key)
{
    const std::string& entry = given.texts(key).front();
    const auto folder = std::filesystem::path(given.location(key).file).parent_path();
    const auto files = named_files(folder, entry);
    const auto refused = [&](const std::string& why) {
        return invalid_value(given.location(key), key, fmt::format("\"{}\"", entry), why);
    };
    if (files.empty()) throw refused(no_such_file(folder, entry));
    if (files.size() > 1 || given.texts(key).size() > 1) throw refused("must be one file; several match");
    return files.front();
}

}
