#include "base/files/leftovers.hpp"

#include <chrono>
#include <csignal>
#include <system_error>
#include <thread>

#include <sys/wait.h>

namespace poissonlab {
namespace {

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

Leftovers& Leftovers::instance()
{
    static auto& leftovers = *new Leftovers;
    return leftovers;
}

void Leftovers::add(const std::filesystem::path& path)
{
    const std::lock_guard lock(mutex_);
    paths_.insert(path);
}

void Leftovers::remove(const std::filesystem::path& path)
{
    remove_from_disk(path);
    const std::lock_guard lock(mutex_);
    paths_.erase(path);
}

void Leftovers::add_program(pid_t program)
{
    const std::lock_guard lock(mutex_);
    programs_.insert(program);
}

void Leftovers::forget_program(pid_t program)
{
    const std::lock_guard lock(mutex_);
    programs_.erase(program);
}

void Leftovers::clear()
{
    const std::lock_guard lock(mutex_);
    for (const pid_t program : programs_) ::kill(-program, SIGKILL);
    for (const pid_t program : programs_) wait_for_end(program);
    for (const auto& path : paths_) remove_from_disk(path);
}

}
