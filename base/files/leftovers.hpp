// A misfortune: the process ends all at once, by a signal that it can no longer wait for. What it would leave behind is
// listed here, so that its last act can be to clean up: temporary files and folders, and programs that it has started.
//
// The list is safe in any thread.
#pragma once

#include <filesystem>

#include <sys/types.h>

namespace poissonlab {

/// Lists a file or a folder.
void list_leftover(const std::filesystem::path& path);

/// Removes a file, or a folder with all that is in it, and takes it off the list.
void remove_leftover(const std::filesystem::path& path);

/// Lists a program that leads a process group of its own.
void list_leftover(pid_t program);

/// Takes a program off the list. To be called before waitpid() is: from then on another process may have its number.
void forget_leftover(pid_t program);

/// Ends the programs and removes the files and folders, for a process that ends without waiting for its threads. What
/// cannot be removed is left to the next run, see remove_stale_temporary_files().
void remove_all_leftovers() noexcept;

}
