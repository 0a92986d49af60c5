#include "io/whole_file.hpp"

#include "errors/errors.hpp"
#include "io/leftovers.hpp"

#include <fmt/format.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <exception>
#include <memory>
#include <system_error>

#include <unistd.h>

namespace poissonlab {

namespace {

using FileHandle = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

std::string last_system_error() { return std::generic_category().message(errno); }

constexpr std::string_view temporary_mark = ".tmp";

/// Whether a name is one of temporary_beside().
bool is_temporary(const std::filesystem::path& file)
{
    const std::string name = file.filename().string();
    return name.starts_with(".") && (file.extension() == temporary_mark || file.stem().extension() == temporary_mark);
}

/// A name beside `path` that no other thread or process uses, hidden, with the same extension.
std::filesystem::path temporary_beside(const std::filesystem::path& path)
{
    static std::atomic<unsigned> counter = 0;
    const std::string name = fmt::format(".{}.{}-{}{}{}", path.stem().string(), ::getpid(), ++counter,
                                         temporary_mark, path.extension().string());
    return path.parent_path() / name;
}

/// Removes the temporary file at the end of the scope, unless it was renamed by then.
class TemporaryFile
{
public:
    explicit TemporaryFile(const std::filesystem::path& target) : path_(temporary_beside(target))
    {
        Leftovers::instance().add(path_);
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    ~TemporaryFile() { Leftovers::instance().remove(path_); }

    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

/// Throws StorageError. Names `target`, the file that the user knows of, not `file`.
void write_content(const std::filesystem::path& file, const std::filesystem::path& target,
                   const std::function<void(const FileSink& sink)>& write)
{
    const auto fail = [&target] {
        throw StorageError(fmt::format("{}: cannot be written: {}", target.string(), last_system_error()));
    };
    FileHandle handle(std::fopen(file.c_str(), "wb"), &std::fclose);
    if (!handle) fail();
    write([&](std::string_view bytes) {
        if (std::fwrite(bytes.data(), 1, bytes.size(), handle.get()) != bytes.size()) fail();
    });
    // What is still buffered is written here, so a full disk may show up only now.
    if (std::fclose(handle.release()) != 0) fail();
}

}

void write_whole_file(const std::filesystem::path& path, std::string_view content)
{
    write_whole_file_in_pieces(path, [&](const FileSink& sink) { sink(content); });
}

void write_whole_file_in_pieces(const std::filesystem::path& path,
                                const std::function<void(const FileSink& sink)>& write)
{
    write_whole_file(path,
                     [&](const std::filesystem::path& temporary) { write_content(temporary, path, write); });
}

void write_whole_file(const std::filesystem::path& path,
                      const std::function<void(const std::filesystem::path& temporary)>& write)
{
    const TemporaryFile temporary(path);
    write(temporary.path());

    std::error_code error;
    std::filesystem::rename(temporary.path(), path, error);
    if (error) throw StorageError(fmt::format("{}: cannot be written: {}", path.string(), error.message()));
}

void remove_temporary_files() noexcept
{
    try {
        Leftovers::instance().clear();
    } catch (const std::exception&) {
        // What stays is removed by the next run.
    }
}

void remove_stale_temporary_files(const std::filesystem::path& folder, std::chrono::seconds age,
                                  const std::filesystem::path& except) noexcept
{
    namespace fs = std::filesystem;
    try {
        const auto oldest = fs::file_time_type::clock::now() - age;
        std::error_code error;
        for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
            if (entry->path().filename() == except) entry.disable_recursion_pending();
            std::error_code unknown;
            if (is_temporary(entry->path()) && entry->last_write_time(unknown) <= oldest && !unknown)
                fs::remove(entry->path(), unknown);
        }
    } catch (const std::exception&) {
        // They cost space only.
    }
}

std::string read_whole_file(const std::filesystem::path& path)
{
    const auto fail = [&path] {
        throw InputError(fmt::format("{}: cannot be read: {}", path.string(), last_system_error()));
    };
    const FileHandle handle(std::fopen(path.c_str(), "rb"), &std::fclose);
    if (!handle) fail();

    // The size is a hint only: pipes have none, and a file may grow while it is read.
    std::error_code no_size;
    const std::uintmax_t size = std::filesystem::file_size(path, no_size);
    constexpr std::size_t chunk = 1 << 16;
    std::string content;
    if (!no_size) content.reserve(size + chunk);
    for (bool more = true; more;) {
        const std::size_t end = content.size();
        content.resize(end + chunk);
        const std::size_t got = std::fread(content.data() + end, 1, chunk, handle.get());
        content.resize(end + got);
        more = got == chunk;
    }
    if (std::ferror(handle.get()) != 0) fail();
    return content;
}

}
