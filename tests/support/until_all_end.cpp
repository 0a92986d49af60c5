// until_all_end PROGRAM [ARGUMENT...]: runs a program, and ends when all processes have ended that came of it, whatever
// groups and sessions they are in.
//
// Chromium is a dozen processes. Those that it leaves behind when it ends, or when it is killed, go on writing into its
// profile for a while: whoever removes that folder meanwhile finds that it is not empty. So tests start Chromium by
// this. When the program ends, the others are killed, and waited for; SIGTERM, SIGINT and the end of the test kill all
// of them. Descriptors are handed on. The exit status is that of the program, or 1.
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>

#include <spawn.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace {

/// The parent of a process; 0: there is no such process any more. Its name, in brackets, can hold any letters.
pid_t parent_of(const std::string& process)
{
    std::ifstream file("/proc/" + process + "/stat");
    std::string text;
    std::getline(file, text, '\0');
    const std::size_t end_of_name = text.rfind(')');
    char state = 0;
    int parent = 0;
    if (end_of_name == std::string::npos || std::sscanf(text.c_str() + end_of_name + 1, " %c %d", &state, &parent) != 2)
        return 0;
    return parent;
}

/// Kills all children of this process. Processes whose parents have ended are among them: see PR_SET_CHILD_SUBREAPER.
void kill_children()
{
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator("/proc", ignored)) {
        const std::string name = entry.path().filename();
        if (name.find_first_not_of("0123456789") == std::string::npos && parent_of(name) == ::getpid())
            ::kill(static_cast<pid_t>(std::stol(name)), SIGKILL);
    }
}

/// Kills children until there are none: each that ends may leave its own behind.
void end_all()
{
    while (true) {
        kill_children();
        pid_t ended = 0;
        while ((ended = ::waitpid(-1, nullptr, WNOHANG)) > 0) {
        }
        if (ended < 0) return;
        ::usleep(2000);
    }
}

/// Takes the status of all that have ended. True where the program is among them.
bool has_ended(pid_t program, int& status)
{
    int of_one = 0;
    for (pid_t ended = 0; (ended = ::waitpid(-1, &of_one, WNOHANG)) > 0;)
        if (ended == program) {
            status = WIFEXITED(of_one) ? WEXITSTATUS(of_one) : 1;
            return true;
        }
    return false;
}

pid_t started(char** words)
{
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    sigset_t none;
    sigemptyset(&none);
    posix_spawnattr_setsigmask(&attributes, &none);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
    pid_t program = 0;
    const int error = ::posix_spawnp(&program, words[0], nullptr, &attributes, words, environ);
    if (error == 0) return program;
    std::fprintf(stderr, "%s cannot be started: %s\n", words[0], std::strerror(error));
    std::exit(1);
}

}

int main(int argc, char** argv)
{
    if (argc < 2) return 1;
    const pid_t parent = ::getppid();
    sigset_t waited;
    sigemptyset(&waited);
    for (const int signal : {SIGCHLD, SIGTERM, SIGINT, SIGHUP}) sigaddset(&waited, signal);
    sigprocmask(SIG_BLOCK, &waited, nullptr); // they are taken by sigwaitinfo()
    ::prctl(PR_SET_CHILD_SUBREAPER, 1);
    ::prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (::getppid() != parent) return 1; // which has ended before that

    const pid_t program = started(argv + 1);
    int status = 1;
    for (bool goes_on = true; goes_on;) {
        const int signal = sigwaitinfo(&waited, nullptr);
        goes_on = signal == SIGCHLD ? !has_ended(program, status) : signal < 0 && errno == EINTR;
    }
    end_all();
    return status;
}
