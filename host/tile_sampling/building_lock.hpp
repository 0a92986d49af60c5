// Tile sets that several processes want: one builds, the others wait.
#pragma once

#include "host/store/file_lock.hpp"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace poissonlab {

/// Lets one process build the set of a file while others wait, and say so. Nothing where there is no folder that could
/// be written.
std::optional<FileLock> building_lock(const std::filesystem::path& file,
                                      const std::function<void(const std::string& what)>& on_step);

}
