#include "tests/support/program.hpp"
#include "tests/support/places.hpp"

#include <sys/wait.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

namespace fs = std::filesystem;

namespace poissonlab {

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
    const int status = std::system(line.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content_of(out), content_of(error)};
}

Outcome run_program(const fs::path& folder, const std::vector<std::string>& arguments, const std::string& environment)
{
    std::string command = environment + " " + quoted(program_file());
    for (const std::string& argument : arguments) command.append(" ").append(quoted(argument));
    return run_in_shell(folder, command);
}

std::map<std::string, std::string> files_below(const fs::path& folder)
{
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file() && entry.path().string().find("/.units/") == std::string::npos)
            files[entry.path().lexically_relative(folder).string()] = content_of(entry.path());
    return files;
}

}
