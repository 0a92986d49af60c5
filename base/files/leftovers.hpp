// Files and folders made for a while, and programs that are running: a process that ends all at once would leave these.
#pragma once

#include <filesystem>
#include <mutex>
#include <set>

#include <sys/types.h>

namespace poissonlab {

/// The list of these. Safe in any thread.
class Leftovers
{
public:
    /// This process's list. It is never destroyed, because the thread that ends the process may come late.
    static Leftovers& instance();

    void add(const std::filesystem::path& path);

    /// Removes a file, or a folder with all that is in it, and takes it off the list.
    void remove(const std::filesystem::path& path);

    /// Adds a program that leads a process group of its own.
    void add_program(pid_t program);

    /// Must be called before waitpid(): from then on another process may have the same number.
    void forget_program(pid_t program);

    /// Ends the programs and removes the files and folders.
    void clear();

private:
    std::mutex mutex_;
    std::set<std::filesystem::path> paths_;
    std::set<pid_t> programs_;
};

}
