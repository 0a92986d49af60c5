#include "base/files/file_lock.hpp"

#include "base/errors/errors.hpp"

#include <fmt/format.h>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

namespace poissonlab {
namespace {

[[noreturn]] void fail(const std::filesystem::path& file)
{
    throw StorageError(fmt::format("{}: cannot be locked: {}", file.string(), std::generic_category().message(errno)));
}

int opened(const std::filesystem::path& file)
{
    int descriptor = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (descriptor < 0 && errno == EACCES) // another user made it: a lock needs no right to write
        descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) fail(file);
    return descriptor;
}

/// False where another process has the lock and `operation` does not wait.
bool lock(int descriptor, int operation, const std::filesystem::path& file)
{
    while (::flock(descriptor, operation) != 0) {
        if (errno == EINTR) continue;
        const bool taken = errno == EWOULDBLOCK;
        const int reason = errno;
        ::close(descriptor);
        errno = reason;
        if (!taken) fail(file);
        return false;
    }
    return true;
}

}

FileLock::FileLock(const std::filesystem::path& file) : descriptor_(opened(file)) { lock(descriptor_, LOCK_EX, file); }

std::optional<FileLock> FileLock::try_lock(const std::filesystem::path& file)
{
    const int descriptor = opened(file);
    if (!lock(descriptor, LOCK_EX | LOCK_NB, file)) return std::nullopt;
    return FileLock(descriptor);
}

FileLock::FileLock(FileLock&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}

FileLock& FileLock::operator=(FileLock&& other) noexcept
{
    std::swap(descriptor_, other.descriptor_);
    return *this;
}

FileLock::~FileLock()
{
    if (descriptor_ >= 0) ::close(descriptor_);
}

}
