#include "host/device/device_needs.hpp"

#include "base/files/scratch_folder.hpp"
#include "base/programs/program_run.hpp"
#include "host/device/device.hpp"
#include "host/device/device_memory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <system_error>

#include <sys/stat.h>
#include <unistd.h>

namespace poissonlab {
namespace {

namespace fs = std::filesystem;

constexpr const char* variable = "POCL_CACHE_DIR";

/// The folder for compiled kernels that PoCL (3.1) would choose.
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

/// Names another folder to PoCL where it cannot use its own. Returns what to say where there is none.
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

bool ends_loops_early(const std::string& device_name) { return device_name.starts_with("llvmpipe"); }

std::string why_loops_are_unreliable(const std::string& device_name)
{
    if (!ends_loops_early(device_name) || std::getenv("POISSONLAB_SHORT_LOOPS")) return {};
    return "its driver ends the loops of a work-item after 65,535 iterations, so that sets would be wrong "
           "(POISSONLAB_SHORT_LOOPS=1 uses it all the same)";
}

std::string lacking(const KernelNeeds& needs, const DeviceInfo& device)
{
    if (needs.double_precision && !device.has_double_precision) return "double precision";
    if (needs.local_bytes > device.local_memory_bytes) return bytes_text(needs.local_bytes) + " of local memory";
    return {};
}

bool can_run(const KernelNeeds& needs, const DeviceInfo& device)
{
    return device.unusable.empty() && lacking(needs, device).empty();
}

DeviceError lack_error(const std::string& what, const KernelNeeds& needs, const DeviceInfo& device,
                       const std::vector<DeviceInfo>& devices)
{
    const auto other = std::ranges::find_if(devices, [&](const DeviceInfo& d) { return can_run(needs, d); });
    const std::string advice = other == devices.end()
                                   ? "no OpenCL device here has it, and the reference engine needs none"
                                   : fmt::format("--device {} ({}) has it", other - devices.begin(), other->name);
    return DeviceError(
        fmt::format("{} needs {}, which {} has not; {}", what, lacking(needs, device), device.name, advice));
}

void check_needs(const std::string& what, const KernelNeeds& needs, const DeviceInfo& device)
{
    if (!lacking(needs, device).empty()) throw lack_error(what, needs, device, list_devices());
}

}
