// Runs the built program as a user does, and keeps what it says.
#pragma once

#include "tests/support/program_nursery.hpp"
#include "tests/support/temporary_folder.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace poissonlab {

struct Outcome
{
    int status = -1; ///< exit status; -1: ended by a signal
    std::string out; ///< standard output, a pipe or file to the program
    std::string error;
};

std::string content_of(const std::filesystem::path& file);

/// A word as the shell takes it for one.
std::string quoted(const std::string& argument);

/// Runs a command of the shell in `folder`.
Outcome run_in_shell(const std::filesystem::path& folder, const std::string& command);

/// Runs `poissonlab ARGUMENTS` in `folder`; `environment` is "NAME=value ...", in shell syntax.
Outcome run_program(const std::filesystem::path& folder, const std::vector<std::string>& arguments,
                    const std::string& environment = "");

/// Calls run_program() with the words of a line of the shell.
Outcome run_program_line(const std::filesystem::path& folder, const std::string& line);

/// From now on run_program() calls `program` in children of a nursery, but for calls with an environment, instead of
/// starting the program's file. It must be called before this process has threads.
void run_programs_in_nursery(ProgramMain program);

/// Every file below a folder: name relative to it, and content. Without stored units, whose records hold times.
std::map<std::string, std::string> files_below(const std::filesystem::path& folder);

}
