#include "host/tile_sampling/built_once.hpp"

namespace poissonlab {

std::optional<FileLock> building_lock(const std::filesystem::path& file,
                                      const std::function<void(const std::string& what)>& on_step)
{
    const std::string lock_file = file.string() + ".lock";
    try {
        std::filesystem::create_directories(file.parent_path());
        auto lock = FileLock::try_lock(lock_file);
        if (lock) return lock;
        if (on_step) on_step("waiting for another process that builds the tile set");
        return FileLock(lock_file);
    } catch (const std::filesystem::filesystem_error&) {
    } catch (const StorageError&) {
    }
    return std::nullopt;
}

}
