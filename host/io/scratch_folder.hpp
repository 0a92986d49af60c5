// A new folder for what is needed for a while, removed with all that is in it at the end of the scope.
#pragma once

#include <filesystem>

namespace poissonlab {

class ScratchFolder
{
public:
    /// In $TMPDIR, or in /tmp where that is no folder. Throws StorageError.
    ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;
    ~ScratchFolder();

    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

}
