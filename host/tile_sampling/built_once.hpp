// Files that keep what takes long to build, also where several processes want it: one builds, the others wait.
#pragma once

#include "base/errors/errors.hpp"
#include "base/files/file_lock.hpp"

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace poissonlab {

/// Lets one process build what a file will have while others wait, and say so. Nothing where there is no folder that
/// could be written.
std::optional<FileLock> building_lock(const std::filesystem::path& file,
                                      const std::function<void(const std::string& what)>& on_step);

/// A thing that was built now or before, and what getting it took.
template <class Built>
struct BuiltOnce
{
    Built built;
    bool cached = false;        ///< read, not built
    double waiting_seconds = 0; ///< for another process that was building it
};

/// Returns what `file` has, or else the result of build(), which write(file, built) puts there. read(file) returns
/// nothing where the file has something else; such files, missing ones and those that InputError refuses are replaced.
/// Where nothing can be written, what was built is not kept. An empty path: always built. `on_step` is told of waiting;
/// what it throws ends that.
template <class Read, class Build, class Write>
auto built_once(const std::filesystem::path& file, const std::function<void(const std::string& what)>& on_step,
                Read read, Build build, Write write) -> BuiltOnce<decltype(build())>
{
    if (file.empty()) return {build()};
    const auto stored = [&]() -> std::optional<decltype(build())> {
        std::error_code error;
        if (!std::filesystem::is_regular_file(file, error)) return std::nullopt;
        try {
            return read(file);
        } catch (const InputError&) {
            return std::nullopt;
        }
    };
    if (auto found = stored()) return {*std::move(found), true};
    const auto begin = std::chrono::steady_clock::now();
    const std::optional<FileLock> lock = building_lock(file, on_step);
    const double waiting = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    if (auto found = stored()) return {*std::move(found), true, waiting}; // another process built it meanwhile
    BuiltOnce<decltype(build())> result{build(), false, waiting};
    try {
        write(file, result.built);
    } catch (const std::filesystem::filesystem_error&) {
        // A cache that cannot be written is no reason to fail.
    } catch (const StorageError&) {
    }
    return result;
}

}
