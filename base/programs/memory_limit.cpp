#include "base/programs/memory_limit.hpp"

#include <algorithm>
#include <fstream>

#include <sys/resource.h>
#include <unistd.h>

namespace poissonlab {

std::uint64_t memory_limit(std::uint64_t processes)
{
    std::uint64_t bytes =
        static_cast<std::uint64_t>(::sysconf(_SC_PHYS_PAGES)) * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
    std::uint64_t granted = 0;
    if (std::ifstream("/sys/fs/cgroup/memory.max") >> granted) bytes = std::min(bytes, granted); // "max": no number
    bytes /= processes;
    struct rlimit addresses = {};
    if (::getrlimit(RLIMIT_AS, &addresses) == 0 && addresses.rlim_cur != RLIM_INFINITY)
        bytes = std::min<std::uint64_t>(bytes, addresses.rlim_cur);
    return bytes;
}

}
