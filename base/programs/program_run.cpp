#include "base/programs/program_run.hpp"

#include "base/errors/errors.hpp"
#include "base/files/leftovers.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <system_error>

extern char** environ;

namespace fs = std::filesystem;

namespace poissonlab {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t most_output = 4096; ///< bytes that are kept
constexpr int milliseconds_between_checks = 20;

std::string error_text(int code) { return std::generic_category().message(code); }

/// A pipe whose ends close when it goes.
class Pipe
{
public:
    Pipe()
    {
        std::array<int, 2> ends{};
        if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw StorageError("cannot make a pipe: " + error_text(errno));
        read_ = ends[0];
        write_ = ends[1];
    }
    ~Pipe()
    {
        close_end(read_);
        close_end(write_);
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;

    int read_end() const { return read_; }
    int write_end() const { return write_; }
    bool is_readable() const { return read_ >= 0; }
    void close_read_end() { close_end(read_); }
    void close_write_end() { close_end(write_); }

private:
    static void close_end(int& end)
    {
        if (end >= 0) ::close(end);
        end = -1;
    }

    int read_ = -1;
    int write_ = -1;
};

/// Pointers to the texts and a null pointer at the end, which is the form that exec() wants.
std::vector<char*> pointers_to(const std::vector<std::string>& texts)
{
    std::vector<char*> pointers;
    for (const std::string& text : texts) pointers.push_back(const_cast<char*>(text.c_str()));
    pointers.push_back(nullptr);
    return pointers;
}

/// The folder, streams, process group and signals that a program is started with.
class SpawnSettings
{
public:
    SpawnSettings(const fs::path& folder, int output)
    {
        ::posix_spawn_file_actions_init(&actions_);
        ::posix_spawnattr_init(&attributes_);
        if (!folder.empty()) ::posix_spawn_file_actions_addchdir_np(&actions_, folder.c_str());
        ::posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
        ::posix_spawn_file_actions_adddup2(&actions_, output, STDOUT_FILENO);
        ::posix_spawn_file_actions_adddup2(&actions_, output, STDERR_FILENO);
        // This process ignores SIGPIPE; others do not expect that.
        sigset_t signals;
        ::sigemptyset(&signals);
        ::sigaddset(&signals, SIGPIPE);
        ::posix_spawnattr_setsigdefault(&attributes_, &signals);
        ::posix_spawnattr_setpgroup(&attributes_, 0);
        ::posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF);
    }
    ~SpawnSettings()
    {
        ::posix_spawn_file_actions_destroy(&actions_);
        ::posix_spawnattr_destroy(&attributes_);
    }
    SpawnSettings(const SpawnSettings&) = delete;
    SpawnSettings& operator=(const SpawnSettings&) = delete;

    pid_t spawn(const std::vector<std::string>& words, const std::optional<std::vector<std::string>>& environment) const
    {
        const auto arguments = pointers_to(words);
        const auto variables = environment ? pointers_to(*environment) : std::vector<char*>();
        pid_t process = 0;
        const int error = ::posix_spawnp(&process, arguments[0], &actions_, &attributes_, arguments.data(),
                                         environment ? variables.data() : environ);
        if (error != 0) throw InputError("cannot start " + words[0] + ": " + error_text(error));
        return process;
    }

private:
    posix_spawn_file_actions_t actions_{};
    posix_spawnattr_t attributes_{};
};

/// A running program that does not outlive this, nor the process if that ends all at once.
class RunningProgram
{
public:
    explicit RunningProgram(pid_t process) : process_(process) { list_leftover(process_); }
    ~RunningProgram() { end(); }
    RunningProgram(const RunningProgram&) = delete;
    RunningProgram& operator=(const RunningProgram&) = delete;

    /// True when it has ended; it keeps its number, and with it that of its group.
    bool has_ended() const
    {
        siginfo_t info{};
        return ::waitid(P_PID, static_cast<id_t>(process_), &info, WEXITED | WNOHANG | WNOWAIT) == 0 &&
               info.si_pid == process_;
    }

    /// Kills what is left of the group. Returns the status as waitpid() has it.
    int end()
    {
        if (process_ == 0) return status_;
        ::kill(-process_, SIGKILL);
        forget_leftover(process_);
        while (::waitpid(process_, &status_, 0) < 0 && errno == EINTR) continue;
        process_ = 0;
        return status_;
    }

private:
    pid_t process_;
    int status_ = 0;
};

/// Waits a moment for output and takes what there is; keeps the end of it.
void read_output(Pipe& pipe, std::string& output)
{
    pollfd waiting{pipe.read_end(), POLLIN, 0};
    // Without a pipe to wait for, the end is near: look again soon.
    if (::poll(&waiting, pipe.is_readable() ? 1 : 0, pipe.is_readable() ? milliseconds_between_checks : 1) <= 0) return;
    std::array<char, most_output> buffer{};
    const ssize_t count = ::read(pipe.read_end(), buffer.data(), buffer.size());
    if (count > 0) output.append(buffer.data(), static_cast<std::size_t>(count));
    if (output.size() > most_output) output.erase(0, output.size() - most_output);
    if (count == 0) pipe.close_read_end();
}

/// Takes what is in the pipe already; others may still hold its other end.
void drain_output(Pipe& pipe, std::string& output)
{
    for (pollfd ready{pipe.read_end(), POLLIN, 0}; pipe.is_readable() && ::poll(&ready, 1, 0) > 0;)
        read_output(pipe, output);
}

}

std::optional<fs::path> find_program(const std::string& name, const fs::path& folder)
{
    const auto is_executable = [](const fs::path& file) {
        std::error_code error;
        return fs::is_regular_file(file, error) && ::access(file.c_str(), X_OK) == 0;
    };
    if (name.find('/') != std::string::npos)
        return is_executable(folder / name) ? std::optional(folder / name) : std::nullopt;
    const char* variable = std::getenv("PATH");
    const std::string path = variable ? variable : default_path;
    for (std::size_t begin = 0; begin <= path.size();) {
        const std::size_t end = std::min(path.find(':', begin), path.size());
        const fs::path file = folder / path.substr(begin, end - begin) / name;
        if (is_executable(file)) return file;
        begin = end + 1;
    }
    return std::nullopt;
}

ProgramOutcome run_program(const std::vector<std::string>& words, const fs::path& folder, double limit_seconds,
                           const std::function<void()>& check,
                           const std::optional<std::vector<std::string>>& environment)
{
    Pipe pipe;
    ProgramOutcome outcome;
    const auto begin = Clock::now();
    RunningProgram program(SpawnSettings(folder, pipe.write_end()).spawn(words, environment));
    pipe.close_write_end();
    while (!program.has_ended() && outcome.is_in_time) {
        check();
        read_output(pipe, outcome.output);
        outcome.is_in_time = std::chrono::duration<double>(Clock::now() - begin).count() <= limit_seconds;
    }
    const int status = program.end();
    drain_output(pipe, outcome.output);
    if (WIFSIGNALED(status)) outcome.signal = WTERMSIG(status);
    if (WIFEXITED(status)) outcome.status = WEXITSTATUS(status);
    return outcome;
}

}
