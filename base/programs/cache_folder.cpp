#include "base/programs/cache_folder.hpp"

#include <cstdlib>

namespace poissonlab {

std::filesystem::path cache_folder()
{
    const auto folder_of = [](const char* variable) {
        const char* value = std::getenv(variable);
        return std::filesystem::path(value ? value : "");
    };
    if (const auto folder = folder_of("POISSONLAB_CACHE"); !folder.empty()) return folder;
    if (const auto folder = folder_of("XDG_CACHE_HOME"); !folder.empty()) return folder / "poissonlab";
    if (const auto folder = folder_of("HOME"); !folder.empty()) return folder / ".cache" / "poissonlab";
    return {};
}

}
