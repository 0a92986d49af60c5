// Runs the built program as a user does, and keeps what it says.
#pragma once

#include "support/temporary_folder.hpp"

#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace poissonlab {

struct Outcome
{
    int status = -1; ///< exit status; -1: ended by a signal
    std::string out; ///< standard output, a pipe or file to the program
    std::string error;
};

inline std::string content_of(const std::filesystem::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

inline std::string quoted(const std::string& argument)
{
    std::string result = "'";
    for (const char c : argument) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return result + "'";
}

/// Runs `poissonlab ARGUMENTS` in `folder`; `environment` is "NAME=value ...", in shell syntax.
inline Outcome run_program(const std::filesystem::path& folder, const std::vector<std::string>& arguments,
                           const std::string& environment = "")
{
    const TemporaryFolder streams;
    const auto out = streams.path() / "out";
    const auto error = streams.path() / "error";
    std::string command =
        "cd " + quoted(folder.string()) + " && " + environment + " " + quoted(POISSONLAB_BINARY);
    for (const std::string& argument : arguments) command.append(" ").append(quoted(argument));
    command += " > " + quoted(out.string()) + " 2> " + quoted(error.string()) + " < /dev/null";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content_of(out), content_of(error)};
}

/// Every file below a folder: name relative to it, and content. Without stored units, whose records hold times.
inline std::map<std::string, std::string> files_below(const std::filesystem::path& folder)
{
    std::map<std::string, std::string> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
        if (entry.is_regular_file() && entry.path().string().find("/.units/") == std::string::npos)
            files[entry.path().lexically_relative(folder).string()] = content_of(entry.path());
    return files;
}

}
