#include "base/files/standard_streams.hpp"

#include "base/errors/errors.hpp"

#include <cerrno>
#include <cstdio>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

namespace poissonlab {
namespace {

int kept_output = -1;

}

void open_standard_streams()
{
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (::fcntl(stream, F_GETFD) != -1) continue;
        // open() takes the lowest free number, which is this stream's. It is opened for reading where the program
        // writes, and for writing where it reads: both fail.
        [[maybe_unused]] const int opened = ::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
    }
}

void keep_standard_output()
{
    if (kept_output >= 0) return;
    std::fflush(stdout);
    const int kept = ::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
    if (kept < 0 || ::dup2(STDERR_FILENO, STDOUT_FILENO) < 0)
        throw StorageError("standard output cannot be written: " + std::generic_category().message(errno));
    kept_output = kept;
}

int kept_standard_output() { return kept_output; }

}
