#include "tests/support/program_nursery.hpp"

#include "tests/support/places.hpp"

#include <dlfcn.h>
#include <fcntl.h>
#include <link.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <sstream>
#include <stdexcept>

extern char** environ;

namespace fs = std::filesystem;

namespace poissonlab {
namespace {

using Strings = std::vector<std::string>;

struct Request
{
    Strings places; ///< the folder to run in, and that of the streams
    Strings arguments;
    Strings environment;
};

void write_all(int file, const void* data, std::size_t size)
{
    for (const char* next = static_cast<const char*>(data); size > 0;) {
        const ssize_t written = ::write(file, next, size);
        if (written <= 0) throw std::runtime_error("a nursery of programs has ended");
        next += written;
        size -= static_cast<std::size_t>(written);
    }
}

/// Returns false where the other side has ended.
bool read_all(int file, void* data, std::size_t size)
{
    for (char* next = static_cast<char*>(data); size > 0;) {
        const ssize_t got = ::read(file, next, size);
        if (got <= 0) return false;
        next += got;
        size -= static_cast<std::size_t>(got);
    }
    return true;
}

void send(int file, const Strings& strings)
{
    const std::uint64_t count = strings.size();
    write_all(file, &count, sizeof count);
    for (const std::string& string : strings) {
        const std::uint64_t size = string.size();
        write_all(file, &size, sizeof size);
        write_all(file, string.data(), string.size());
    }
}

bool receive(int file, Strings& strings)
{
    std::uint64_t count = 0;
    if (!read_all(file, &count, sizeof count)) return false;
    strings.resize(count);
    for (std::string& string : strings) {
        std::uint64_t size = 0;
        if (!read_all(file, &size, sizeof size)) return false;
        string.resize(size);
        if (!read_all(file, string.data(), size)) return false;
    }
    return true;
}

std::vector<char*> pointers_to(Strings& strings)
{
    std::vector<char*> pointers;
    for (std::string& string : strings) pointers.push_back(string.data());
    pointers.push_back(nullptr);
    return pointers;
}

void redirect(int stream, const fs::path& file, int flags)
{
    const int opened = ::open(file.c_str(), flags, 0600);
    ::dup2(opened, stream);
    ::close(opened);
}

/// Writes the files of the libraries of this process that take long to load, a line each.
void tell_slow_libraries(int pipe)
{
    const auto tell = [](dl_phdr_info* info, std::size_t /*size*/, void* to) {
        const std::string line = std::string(info->dlpi_name) + "\n";
        const std::string name = fs::path(info->dlpi_name).filename();
        if (name.starts_with("libpoissonlab_") || name.starts_with("libpocl.so"))
            write_all(*static_cast<int*>(to), line.data(), line.size());
        return 0;
    };
    ::dl_iterate_phdr(tell, &pipe);
}

/// Does the work of a child, which ends without what the nursery and the tests do at their own ends.
[[noreturn]] void be_program(ProgramMain program, Request& request, int pipe)
{
    ::on_exit(
        [](int status, void* /*unused*/) {
            std::fflush(nullptr);
            ::_exit(status);
        },
        nullptr);
    fs::current_path(request.places[0]);
    redirect(STDIN_FILENO, "/dev/null", O_RDONLY);
    redirect(STDOUT_FILENO, request.places[1] + "/out", O_WRONLY | O_CREAT);
    redirect(STDERR_FILENO, request.places[1] + "/error", O_WRONLY | O_CREAT);
    std::vector<char*> environment = pointers_to(request.environment);
    environ = environment.data();
    request.arguments.insert(request.arguments.begin(), program_file());
    const std::vector<char*> words = pointers_to(request.arguments);
    const int status = program(static_cast<int>(request.arguments.size()), words.data());
    tell_slow_libraries(pipe);
    std::exit(status);
}

std::string all_from(int pipe)
{
    std::string text;
    std::array<char, 4096> part{};
    for (ssize_t got = 0; (got = ::read(pipe, part.data(), part.size())) > 0;)
        text.append(part.data(), static_cast<std::size_t>(got));
    return text;
}

/// Returns the status of waitpid().
int run_child(ProgramMain program, Request& request)
{
    std::array<int, 2> pipe{};
    if (::pipe2(pipe.data(), O_CLOEXEC) != 0) return -1;
    const pid_t child = ::fork();
    if (child < 0) return -1;
    if (child == 0) {
        try {
            be_program(program, request, pipe[1]);
        } catch (...) {
            std::terminate(); // which is what main does with exceptions
        }
    }
    ::close(pipe[1]);
    std::istringstream libraries(all_from(pipe[0]));
    ::close(pipe[0]);
    int status = -1;
    ::waitpid(child, &status, 0);
    for (std::string file; std::getline(libraries, file);) ::dlopen(file.c_str(), RTLD_LAZY | RTLD_LOCAL);
    return status;
}

void serve(ProgramMain program, int requests)
{
    Request request;
    while (receive(requests, request.places) && receive(requests, request.arguments) &&
           receive(requests, request.environment)) {
        const int status = run_child(program, request);
        write_all(requests, &status, sizeof status);
    }
}

}

ProgramNursery::ProgramNursery(ProgramMain program)
{
    std::array<int, 2> ends{};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) throw std::runtime_error("no sockets");
    std::fflush(nullptr);
    const pid_t nursery = ::fork();
    if (nursery < 0) throw std::runtime_error("no processes");
    if (nursery == 0) {
        ::close(ends[0]);
        try {
            serve(program, ends[1]);
        } catch (const std::exception&) { // the tests have ended
        }
        ::_exit(0);
    }
    ::close(ends[1]);
    requests_ = ends[0];
    nursery_ = nursery;
}

ProgramNursery::~ProgramNursery()
{
    ::close(requests_);
    ::waitpid(nursery_, nullptr, 0);
}

int ProgramNursery::run(const fs::path& folder, const Strings& arguments, const fs::path& streams)
{
    Strings environment;
    for (char** variable = environ; *variable; ++variable) environment.emplace_back(*variable);
    send(requests_, {folder.string(), streams.string()});
    send(requests_, arguments);
    send(requests_, environment);
    int status = -1;
    if (!read_all(requests_, &status, sizeof status)) throw std::runtime_error("a nursery of programs has ended");
    return status;
}

}
