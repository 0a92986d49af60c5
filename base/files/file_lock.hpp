// Locks between processes, of one machine or of several that share a file system.
#pragma once

#include <filesystem>
#include <optional>

namespace poissonlab {

/// An exclusive lock on a file (flock), for as long as it lives: the system releases it when the process ends, in
/// whatever way, so that no lock outlives a run that was killed.
class FileLock
{
public:
    /// Waits for the lock. The file is created where it is missing, and stays. Throws StorageError where it cannot be
    /// created or the file system has no locks.
    explicit FileLock(const std::filesystem::path& file);

    /// The lock, or nothing where another process has it. Throws as the constructor does.
    static std::optional<FileLock> try_lock(const std::filesystem::path& file);

    FileLock(FileLock&& other) noexcept;
    FileLock& operator=(FileLock&& other) noexcept;
    ~FileLock();

private:
    explicit FileLock(int descriptor) : descriptor_(descriptor) {}

    int descriptor_ = -1;
};

}
