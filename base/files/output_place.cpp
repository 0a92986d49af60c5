#include "base/files/output_place.hpp"

#include "base/errors/errors.hpp"
#include "base/files/scratch_folder.hpp"
#include "base/files/standard_streams.hpp"

#include <fmt/format.h>

#include <charconv>
#include <optional>
#include <string>
#include <system_error>

#include <unistd.h>

namespace poissonlab {
namespace {

namespace fs = std::filesystem;

/// Linux follows so many links.
constexpr int most_links = 40;

/// The open file of this process that is meant, such as by /proc/self/fd/1, to which /dev/stdout leads.
std::optional<int> descriptor_named_by(const fs::path& path)
{
    std::error_code unknown;
    const fs::path folder = fs::canonical(path.parent_path(), unknown);
    if (unknown || folder != fs::canonical("/proc/self/fd", unknown) || unknown) return {};
    const std::string name = path.filename();
    int number = 0;
    const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), number);
    if (error != std::errc() || end != name.data() + name.size()) return {};
    return number;
}

fs::path name_for_copies(const fs::path& path) { return folder_for_temporaries() / path.filename(); }

OutputPlace open_file(const fs::path& path, int descriptor)
{
    if (descriptor == STDOUT_FILENO && kept_standard_output() >= 0) descriptor = kept_standard_output();
    return {name_for_copies(path), true, descriptor, {}};
}

}

bool names_standard_output(const fs::path& path)
{
    const std::string& name = path.native();
    return name == "-" || (name.starts_with("-.") && name.find('/') == std::string::npos);
}

OutputPlace output_place(const fs::path& path)
{
    if (names_standard_output(path) && kept_standard_output() >= 0) return open_file(path, STDOUT_FILENO);
    fs::path target = path;
    for (int links = 0;; ++links) {
        std::error_code error;
        if (!fs::is_symlink(fs::symlink_status(target, error))) break;
        if (const auto descriptor = descriptor_named_by(target)) return open_file(path, *descriptor);
        const fs::path next = fs::read_symlink(target, error);
        if (error || links == most_links)
            throw StorageError(fmt::format("{}: cannot be written: {}", printable(path.string()),
                                           error ? error.message() : "its links lead in a circle"));
        target = target.parent_path() / next;
    }
    std::error_code unknown;
    if (fs::is_other(fs::status(target, unknown))) return {name_for_copies(path), true, -1, target};
    return {std::move(target), false, -1, {}};
}

}
