// A new folder for what is needed for a while, removed with all that is in it at the end of the scope.
#pragma once

#include <filesystem>
#include <utility>

namespace poissonlab {

/// $TMPDIR, or /tmp where that is no folder.
std::filesystem::path folder_for_temporaries();

class ScratchFolder
{
public:
    /// Makes the folder, in folder_for_temporaries(). Throws StorageError.
    ScratchFolder();

    /// Makes it beside a file that is to be written, hidden: for as much as the file itself will hold, and for other
    /// processes that share this file's folder. Throws StorageError.
    explicit ScratchFolder(const std::filesystem::path& beside);

    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;
    ScratchFolder(ScratchFolder&& other) noexcept : path_(std::exchange(other.path_, {})) {}
    ~ScratchFolder();

    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

}
