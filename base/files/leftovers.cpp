#include "base/files/leftovers.hpp"

#include <chrono>
#include <csignal>
#include <exception>
#include <mutex>
#include <set>
#include <system_error>
#include <thread>

#include <sys/wait.h>

namespace poissonlab {
namespace {

struct Leftovers
{
    std::mutex mutex;
    std::set<std::filesystem::path> paths;
    std::set<pid_t> programs;
};

/// Never destroyed: a thread that ends the process may come late.
Leftovers& all = *new Leftovers;

void remove_from_disk(const std::filesystem::path& path)
{
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
}

/// Waits until a killed program writes no more, but not for long: one that hangs on a disk may never end. Leaves it to
/// whoever started it to take its status.
void wait_for_end(pid_t program)
{
    constexpr int tries = 100;
    for (int i = 0; i < tries; ++i) {
        siginfo_t info{};
        const int error = ::waitid(P_PID, static_cast<id_t>(program), &info, WEXITED | WNOHANG | WNOWAIT);
        if (error != 0 || info.si_pid == program) return;
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
}

}

void list_leftover(const std::filesystem::path& path)
{
    const std::lock_guard lock(all.mutex);
    all.paths.insert(path);
}

void remove_leftover(const std::filesystem::path& path)
{
    remove_from_disk(path);
    const std::lock_guard lock(all.mutex);
    all.paths.erase(path);
}

void list_leftover(pid_t program)
{
    const std::lock_guard lock(all.mutex);
    all.programs.insert(program);
}

void forget_leftover(pid_t program)
{
    const std::lock_guard lock(all.mutex);
    all.programs.erase(program);
}

void remove_all_leftovers() noexcept
{
    try {
        const std::lock_guard lock(all.mutex);
        for (const pid_t program : all.programs) ::kill(-program, SIGKILL);
        for (const pid_t program : all.programs) wait_for_end(program);
        for (const auto& path : all.paths) remove_from_disk(path);
    } catch (const std::exception&) {
        // There is nobody left to tell.
    }
}

}
