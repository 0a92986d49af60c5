// Files that are there whole or not at all: written beside the target, then renamed. For links see output_place.hpp.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace poissonlab {

/// Writes `content` to `path`, replacing the file that is there or that a link leads to; a device or a pipe takes it.
/// Throws StorageError and leaves nothing behind on failure.
void write_whole_file(const std::filesystem::path& path, std::string_view content);

/// Puts bytes at the end of a file.
using FileSink = std::function<void(std::string_view bytes)>;

/// Writes content that comes in pieces: calls `write` with a sink that takes them.
void write_whole_file_in_pieces(const std::filesystem::path& path,
                                const std::function<void(const FileSink& sink)>& write);

/// Serves libraries that write files themselves: calls `write` with a temporary path that has the extension of `path`,
/// then renames, or copies into a device or a pipe. Removes the temporary file when `write` throws.
void write_whole_file(const std::filesystem::path& path,
                      const std::function<void(const std::filesystem::path& temporary)>& write);

/// Removes temporary files of processes that were killed while they wrote, below a folder but not in folders of the
/// name `except`: those older than `age`, whose process is not running on this machine. Nothing but regular files whose
/// names write_whole_file() makes.
void remove_stale_temporary_files(const std::filesystem::path& folder, std::chrono::seconds age,
                                  const std::filesystem::path& except = {}) noexcept;

/// The content of a file, of a pipe until its end, or of what is typed. Throws InputError when it cannot be read, such
/// as one that does not fit in memory or has no end.
std::string read_whole_file(const std::filesystem::path& path);

/// True for a pipe, a device or the like, which cannot be read twice; false where nothing has this name.
bool is_no_lasting_file(const std::filesystem::path& path);

}
