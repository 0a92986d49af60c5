#include "base/files/scratch_folder.hpp"

#include "base/errors/errors.hpp"
#include "base/files/leftovers.hpp"

#include <cerrno>
#include <cstdlib>
#include <string>
#include <system_error>

namespace poissonlab {

std::filesystem::path folder_for_temporaries()
{
    std::error_code none;
    const auto folder = std::filesystem::temp_directory_path(none);
    return none ? std::filesystem::path("/tmp") : folder;
}

ScratchFolder::ScratchFolder()
{
    std::string name = (folder_for_temporaries() / "poissonlab-XXXXXX").string();
    if (!::mkdtemp(name.data()))
        throw StorageError("cannot make a temporary folder " + name + ": " + std::generic_category().message(errno) +
                           "; the environment variable TMPDIR can name another place");
    path_ = name;
    list_leftover(path_);
}

ScratchFolder::~ScratchFolder() { remove_leftover(path_); }

}
