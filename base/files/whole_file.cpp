#include "base/files/whole_file.hpp"

#include "base/errors/errors.hpp"
#include "base/files/leftovers.hpp"
#include "base/files/output_place.hpp"

#include <fmt/format.h>

#include <atomic>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <exception>
#include <memory>
#include <new>
#include <stdexcept>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace poissonlab {

namespace {

using FileHandle = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

std::string last_system_error() { return std::generic_category().message(errno); }

constexpr std::string_view temporary_mark = ".tmp-";

/// A name in `folder` that no other thread or process uses, hidden, with the extension of `name`:
/// ".tmp-PROCESS-NUMBER-NAME".
std::filesystem::path temporary_in(const std::filesystem::path& folder, const std::filesystem::path& name)
{
    static std::atomic<unsigned> counter = 0;
    return folder / fmt::format("{}{}-{}-{}", temporary_mark, ::getpid(), ++counter, name.filename().string());
}

/// The process that has made up this name in temporary_in(); 0: it is no such name.
pid_t maker_of(const std::filesystem::path& file)
{
    const std::string name = file.filename().string();
    if (!name.starts_with(temporary_mark)) return 0;
    const char* const end = name.data() + name.size(); // a zero, as behind every string
    pid_t process = 0;
    unsigned number = 0;
    const auto [stop, error] = std::from_chars(name.data() + temporary_mark.size(), end, process);
    if (error != std::errc() || process <= 0 || *stop != '-') return 0;
    const auto [last, number_error] = std::from_chars(stop + 1, end, number);
    return number_error == std::errc() && *last == '-' ? process : 0;
}

/// True if the process runs on this machine, as any user.
bool is_running(pid_t process) { return ::kill(process, 0) == 0 || errno != ESRCH; }

bool is_stale(const std::filesystem::directory_entry& entry, std::filesystem::file_time_type oldest)
{
    std::error_code unknown;
    const pid_t maker = maker_of(entry.path());
    return maker != 0 && entry.symlink_status(unknown).type() == std::filesystem::file_type::regular &&
           entry.last_write_time(unknown) <= oldest && !unknown && !is_running(maker);
}

/// Removes the temporary file at the end of the scope, unless it was renamed by then.
class TemporaryFile
{
public:
    /// Places the temporary file beside the file that it becomes or is copied into: links may lead to other folders. It
    /// has the ending of the name that the user gave, which says the format.
    TemporaryFile(const OutputPlace& place, const std::filesystem::path& named)
        : path_(temporary_in(place.file.parent_path(), named))
    {
        list_leftover(path_);
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    ~TemporaryFile() { remove_leftover(path_); }

    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

[[noreturn]] void fail_to_write(const std::filesystem::path& path, const std::string& why)
{
    throw StorageError(fmt::format("{}: cannot be written: {}", path.string(), why));
}

/// Writes all that `write` hands over, and closes the file. Throws StorageError, which names `target`, the file that
/// the user knows of.
void write_content(FileHandle handle, const std::filesystem::path& target,
                   const std::function<void(const FileSink& sink)>& write)
{
    if (!handle) fail_to_write(target, last_system_error());
    write([&](std::string_view bytes) {
        if (std::fwrite(bytes.data(), 1, bytes.size(), handle.get()) != bytes.size())
            fail_to_write(target, last_system_error());
    });
    // Closing writes the rest of the buffer, so a full disk may show up only now.
    if (std::fclose(handle.release()) != 0) fail_to_write(target, last_system_error());
}

FileHandle opened_to_write(const std::filesystem::path& file) { return {std::fopen(file.c_str(), "wb"), &std::fclose}; }

/// A device, a pipe or an open file, which is neither made nor emptied.
FileHandle opened_stream(const OutputPlace& place)
{
    const int file = place.descriptor >= 0 ? ::fcntl(place.descriptor, F_DUPFD_CLOEXEC, 0)
                                           : ::open(place.stream.c_str(), O_WRONLY | O_CLOEXEC);
    return {file < 0 ? nullptr : ::fdopen(file, "wb"), &std::fclose};
}

void copy_into_stream(const std::filesystem::path& file, const OutputPlace& place, const std::filesystem::path& target)
{
    const FileHandle made(std::fopen(file.c_str(), "rb"), &std::fclose);
    if (!made) fail_to_write(target, last_system_error());
    write_content(opened_stream(place), target, [&](const FileSink& sink) {
        std::string piece(1 << 16, '\0');
        while (const std::size_t got = std::fread(piece.data(), 1, piece.size(), made.get())) sink({piece.data(), got});
        if (std::ferror(made.get()) != 0) fail_to_write(target, last_system_error());
    });
}

/// Puts the temporary file in the place of the one that is there, whose permissions it gets. A file that may not be
/// written stays, although its folder would let it be replaced.
void put_in_place(const std::filesystem::path& temporary, const std::filesystem::path& file,
                  const std::filesystem::path& named)
{
    std::error_code error;
    const auto there = std::filesystem::status(file, error);
    if (std::filesystem::is_regular_file(there)) {
        if (::access(file.c_str(), W_OK) != 0) fail_to_write(named, last_system_error());
        std::filesystem::permissions(temporary, there.permissions(), error);
    }
    std::filesystem::rename(temporary, file, error);
    if (error) fail_to_write(named, error.message());
}

[[noreturn]] void fail_to_read(const std::filesystem::path& path, const std::string& why)
{
    throw InputError::at({path.string()}, fmt::format("cannot be read: {}", why));
}

/// Devices such as /dev/zero never end; what is typed in a terminal does.
void check_that_it_ends(const std::filesystem::path& path, const struct stat& info, std::FILE* handle)
{
    const bool is_device = S_ISBLK(info.st_mode) || (S_ISCHR(info.st_mode) && ::isatty(::fileno(handle)) == 0);
    if (is_device) throw InputError::at({path.string()}, "is a device, not a file");
}

/// The rest of an open file. The size is a hint only: pipes have none, and a file may grow while it is read; but not
/// without end.
std::string content_of(const std::filesystem::path& path, const struct stat& info, std::FILE* handle)
{
    constexpr std::size_t chunk = 1 << 16;
    constexpr std::size_t most_growth = std::size_t{4} << 30;
    const auto size = S_ISREG(info.st_mode) ? static_cast<std::size_t>(info.st_size) : 0;
    std::string content;
    content.reserve(size + chunk);
    for (bool more = true; more;) {
        const std::size_t end = content.size();
        if (end > size && end - size > most_growth)
            throw InputError::at(
                {path.string()},
                fmt::format("gives more than {} GiB, and no end: only a file may have more", most_growth >> 30));
        content.resize(end + chunk);
        const std::size_t got = std::fread(content.data() + end, 1, chunk, handle);
        content.resize(end + got);
        more = got == chunk;
    }
    if (std::ferror(handle) != 0) fail_to_read(path, last_system_error());
    return content;
}

}

void write_whole_file(const std::filesystem::path& path, std::string_view content)
{
    write_whole_file_in_pieces(path, [&](const FileSink& sink) { sink(content); });
}

void write_whole_file_in_pieces(const std::filesystem::path& path,
                                const std::function<void(const FileSink& sink)>& write)
{
    const OutputPlace place = output_place(path);
    if (place.is_stream) return write_content(opened_stream(place), path, write);
    write_whole_file(
        path, [&](const std::filesystem::path& temporary) { write_content(opened_to_write(temporary), path, write); });
}

void write_whole_file(const std::filesystem::path& path,
                      const std::function<void(const std::filesystem::path& temporary)>& write)
{
    const OutputPlace place = output_place(path);
    const TemporaryFile temporary(place, path);
    write(temporary.path());
    if (place.is_stream)
        copy_into_stream(temporary.path(), place, path);
    else
        put_in_place(temporary.path(), place.file, path);
}

void remove_stale_temporary_files(const std::filesystem::path& folder, std::chrono::seconds age,
                                  const std::filesystem::path& except) noexcept
{
    namespace fs = std::filesystem;
    try {
        const auto oldest = fs::file_time_type::clock::now() - age;
        std::error_code error;
        constexpr auto options = fs::directory_options::skip_permission_denied; // links to folders are not followed
        for (fs::recursive_directory_iterator entry(folder, options, error), end; !error && entry != end;
             entry.increment(error)) {
            if (entry->path().filename() == except) entry.disable_recursion_pending();
            std::error_code ignored;
            if (is_stale(*entry, oldest)) fs::remove(entry->path(), ignored);
        }
    } catch (const std::exception&) {
        // They cost space only.
    }
}

std::string read_whole_file(const std::filesystem::path& path)
{
    const FileHandle handle(std::fopen(path.c_str(), "rb"), &std::fclose);
    struct stat info
    {
    };
    if (!handle || ::fstat(::fileno(handle.get()), &info) != 0) fail_to_read(path, last_system_error());
    check_that_it_ends(path, info, handle.get());
    try {
        return content_of(path, info, handle.get());
    } catch (const std::bad_alloc&) {
        throw InputError::at({path.string()}, fmt::format("does not fit in memory: has {} bytes", info.st_size));
    } catch (const std::length_error&) { // of a size that no text can have
        throw InputError::at({path.string()}, fmt::format("does not fit in memory: has {} bytes", info.st_size));
    }
}

bool is_no_lasting_file(const std::filesystem::path& path)
{
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    return !error && std::filesystem::is_other(status);
}

}
