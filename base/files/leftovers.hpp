// What a process that ends all at once would leave behind: files and folders made for a while, programs it has started.
#pragma once

#include <filesystem>
#include <mutex>
#include <set>

#include <sys/types.h>

namespace poissonlab {

/// The list of them. Safe in any thread.
class Leftovers
{
public:
    /// Of this process. Never destroyed: a thread that ends the process may come late.
    static Leftovers& instance();

    void add(const std::filesystem::path& path);

    /// Removes a file, or a folder with all that is in it, and takes it off the list.
    void remove(const std::filesystem::path& path);

    /// A program that leads a process group of its own.
    void add_program(pid_t program);

    /// To be called before waitpid() is: from then on the number may be that of another process.
    void forget_program(pid_t program);

    /// Ends the programs and removes the files and folders.
    void clear();

private:
    std::mutex mutex_;
    std::set<std::filesystem::path> paths_;
    std::set<pid_t> programs_;
};

}
