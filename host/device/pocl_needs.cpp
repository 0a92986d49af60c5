#include "host/device/pocl_needs.hpp"

#include "base/files/scratch_folder.hpp"
#include "base/programs/program_run.hpp"
#include "host/device/device_memory.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <system_error>

#include <sys/stat.h>
#include <unistd.h>

namespace fs = std::filesystem;

namespace poissonlab {
namespace {

constexpr const char* variable = "POCL_CACHE_DIR";

/// The folder for compiled kernels that PoCL (3.1) chooses.
fs::path chosen_by_pocl()
{
    const auto value_of = [](const char* name) {
        const char* value = std::getenv(name);
        return fs::path(value ? value : "");
    };
    if (const fs::path folder = value_of(variable); !folder.empty()) return folder;
    if (const fs::path folder = value_of("XDG_CACHE_HOME"); !folder.empty()) return folder / "pocl/kcache";
    if (const fs::path folder = value_of("HOME"); !folder.empty()) return folder / ".cache/pocl/kcache";
    return "/tmp/pocl/kcache";
}

/// PoCL ends the program where the disk is full while it compiles. Kernels take some hundred KiB each.
constexpr std::uintmax_t needed_bytes = std::uintmax_t{64} << 20;

bool can_be_used(const fs::path& folder)
{
    std::error_code error;
    fs::create_directories(folder, error);
    if (::access(folder.c_str(), R_OK | W_OK | X_OK) != 0) return false;
    const fs::space_info space = fs::space(folder, error);
    return error || space.available >= needed_bytes;
}

/// Kernels are programs: a folder that others could put some into is not taken.
bool is_of_this_user_alone(const fs::path& folder)
{
    struct stat info
    {
    };
    return ::lstat(folder.c_str(), &info) == 0 && S_ISDIR(info.st_mode) && info.st_uid == ::geteuid() &&
           (info.st_mode & (S_IRWXG | S_IRWXO)) == 0;
}

/// Returns what to say where there is none.
std::string provide_kernel_cache()
{
    const fs::path chosen = chosen_by_pocl();
    if (can_be_used(chosen)) return {};
    const fs::path other = folder_for_temporaries() / fmt::format("poissonlab-kernels-{}", ::geteuid());
    ::mkdir(other.c_str(), S_IRWXU); // may be there
    if (is_of_this_user_alone(other) && can_be_used(other)) {
        ::setenv(variable, other.c_str(), 1);
        return {};
    }
    return fmt::format("PoCL needs a folder for compiled kernels with {} free, and can use neither {} nor {}; the "
                       "environment variable {} can name another",
                       bytes_text(needed_bytes), chosen.string(), other.string(), variable);
}

}

bool is_pocl(const std::string& platform) { return platform == "Portable Computing Language"; }

std::string provide_pocl_needs()
{
    ::setenv("PATH", default_path, 0); // for PoCL; one that is there stays
    if (!find_program("ld", {})) return "PoCL needs the linker ld (Debian: binutils), which no folder of PATH has";
    return provide_kernel_cache();
}

}
