#include "tests/support/program.hpp"
#include "base/programs/shell_words.hpp"
#include "tests/support/places.hpp"

#include <sys/wait.h>

#include <cstdlib>
#include <fstream>
#include <memory>
#include <sstream>

namespace fs = std::filesystem;

namespace poissonlab {
namespace {

std::unique_ptr<ProgramNursery> nursery;

/// Reads what a command left in the files "out" and "error" of `streams`, and how it ended, by waitpid().
Outcome outcome_of(int status, const fs::path& streams)
{
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content_of(streams / "out"), content_of(streams / "error")};
}

}

std::string content_of(const fs::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

std::string quoted(const std::string& argument)
{
    std::string result = "'";
    for (const char c : argument) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return result + "'";
}

Outcome run_in_shell(const fs::path& folder, const std::string& command)
{
    const TemporaryFolder streams;
    const fs::path out = streams.path() / "out";
    const fs::path error = streams.path() / "error";
    // Braces hold the command together, which may be a list with parts that run in the background.
    const std::string line = "cd " + quoted(folder.string()) + " && {\n" + command + "\n} > " + quoted(out.string()) +
                             " 2> " + quoted(error.string()) + " < /dev/null";
    return outcome_of(std::system(line.c_str()), streams.path());
}

Outcome run_program(const fs::path& folder, const std::vector<std::string>& arguments, const std::string& environment)
{
    if (nursery && environment.empty()) {
        const TemporaryFolder streams;
        return outcome_of(nursery->run(folder, arguments, streams.path()), streams.path());
    }
    std::string command = environment + " " + quoted(program_file());
    for (const std::string& argument : arguments) command.append(" ").append(quoted(argument));
    return run_in_shell(folder, command);
}

Outcome run_program_line(const fs::path& folder, const std::string& line)
{
    return run_program(folder, split_shell_words(line).value());
}

void run_programs_in_nursery(ProgramMain program) { nursery = std::make_unique<ProgramNursery>(program); }

std::map<std::string, std::string> files_below(const fs::path& folder)
{
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file() && entry.path().string().find("/.units/") == std::string::npos)
            files[entry.path().lexically_relative(folder).string()] = content_of(entry.path());
    return files;
}

}
