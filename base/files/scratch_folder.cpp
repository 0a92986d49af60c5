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

namespace {

/// Makes a folder whose name ends in another way than those of all others.
std::filesystem::path new_folder(const std::filesystem::path& begin_of_name, const std::string& advice)
{
    std::string name = begin_of_name.string() + "XXXXXX";
    if (!::mkdtemp(name.data()))
        throw StorageError("cannot make a temporary folder " + name + ": " + std::generic_category().message(errno) +
                           advice);
    list_leftover(name);
    return name;
}

}

ScratchFolder::ScratchFolder()
    : path_(new_folder(folder_for_temporaries() / "poissonlab-",
                       "; the environment variable TMPDIR can name another place"))
{}

ScratchFolder::ScratchFolder(const std::filesystem::path& beside)
    : path_(new_folder(beside.parent_path() / ("." + beside.filename().string() + "-parts-"), ""))
{}

ScratchFolder::~ScratchFolder()
{
    if (!path_.empty()) remove_leftover(path_);
}

}
