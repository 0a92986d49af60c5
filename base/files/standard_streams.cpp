#include "base/files/standard_streams.hpp"

#include <fcntl.h>
#include <unistd.h>

namespace poissonlab {

void open_standard_streams()
{
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (::fcntl(stream, F_GETFD) != -1) continue;
        // open() takes the lowest free number, which is this stream's. It is opened for reading where the program
        // writes, and for writing where it reads: both fail.
        [[maybe_unused]] const int opened = ::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
    }
}

}
