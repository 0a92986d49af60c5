#include "reports/images/picture_store.hpp"

#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"
#include "base/files/xxh64_bytes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <sstream>

namespace poissonlab {

namespace fs = std::filesystem;

namespace {

/// Another build may draw other pictures.
std::string program_hash()
{
    try {
        return fmt::format("{:016x}", xxh64_bytes(read_whole_file("/proc/self/exe")));
    } catch (const InputError&) {
        return {};
    }
}

std::map<std::string, std::string> read_keys(const fs::path& list)
{
    std::map<std::string, std::string> keys;
    std::error_code error;
    if (!fs::exists(list, error)) return keys;
    std::istringstream lines(read_whole_file(list));
    for (std::string line; std::getline(lines, line);)
        if (const auto blank = line.find(' '); blank != std::string::npos)
            keys[line.substr(blank + 1)] = line.substr(0, blank);
    return keys;
}

}

PictureStore::PictureStore(fs::path folder, fs::path list)
    : folder_(std::move(folder)), list_(std::move(list)), program_(program_hash()), known_(read_keys(list_))
{}

std::string PictureStore::name_of(const fs::path& file) const
{
    return file.lexically_relative(folder_).generic_string();
}

bool PictureStore::is_current(const std::vector<fs::path>& files, std::string_view input) const
{
    if (program_.empty()) return false;
    const auto key = fmt::format("{:016x}", xxh64_bytes(input)) + program_;
    return std::ranges::all_of(files, [&](const fs::path& file) {
        const auto found = known_.find(name_of(file));
        std::error_code error;
        return found != known_.end() && found->second == key && fs::is_regular_file(file, error);
    });
}

void PictureStore::note(const std::vector<fs::path>& files, std::string_view input)
{
    const auto key = fmt::format("{:016x}", xxh64_bytes(input)) + program_;
    const std::lock_guard lock(mutex_);
    for (const auto& file : files) noted_[name_of(file)] = key;
}

void PictureStore::save() const
{
    std::string text;
    for (const auto& [name, key] : noted_)
        if (name.find('\n') == std::string::npos) fmt::format_to(std::back_inserter(text), "{} {}\n", key, name);
    write_whole_file(list_, text);
}

}
