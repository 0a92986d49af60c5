// Runs other programs: without a shell, in a process group of their own, for a limited time.
//
// Boost.Process (1.74) waits with a limit in a way that is not safe in threads, and cannot kill a whole group.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

/// The end of a program: its exit status or signal, and its output.
struct ProgramOutcome
{
    bool is_in_time = true;
    int status = 0;     ///< exit status, unless a signal ended it
    int signal = 0;     ///< the signal that ended it; 0: none
    std::string output; ///< the end of standard output and standard error, as they came

    bool succeeded() const { return is_in_time && status == 0 && signal == 0; }
};

/// The folders in which programs are looked for when there is no PATH.
inline constexpr const char* default_path = "/bin:/usr/bin";

/// The program that `name` starts: a path relative to `folder`, or a file in the folders of PATH. Nothing: there is
/// none.
std::optional<std::filesystem::path> find_program(const std::string& name, const std::filesystem::path& folder);

/// Runs the program words[0] with the rest as its arguments, in `folder`, with nothing on standard input, and waits for
/// it. `check` is called again and again meanwhile; what it throws ends the program. When it ends, is late or is ended,
/// all processes of its group are killed. Throws InputError where it cannot be started.
///
/// `environment`: NAME=VALUE, instead of that of this process.
ProgramOutcome run_program(const std::vector<std::string>& words, const std::filesystem::path& folder,
                           double limit_seconds, const std::function<void()>& check,
                           const std::optional<std::vector<std::string>>& environment = std::nullopt);

}
