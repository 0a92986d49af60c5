#include "experiment/interrupt.hpp"

#include <csignal>

namespace poissonlab {
namespace {

volatile std::sig_atomic_t signalled = 0;

void remember(int signal)
{
    signalled = 1;
    std::signal(signal, SIG_DFL);
}

}

void catch_interrupts()
{
    // Output that nobody reads any more (`poissonlab run ... | head`) is no reason to leave half a result.
    std::signal(SIGPIPE, SIG_IGN);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP})
        // What a parent process had us ignore (nohup) stays ignored.
        if (std::signal(signal, remember) == SIG_IGN) std::signal(signal, SIG_IGN);
}

void stop_if_interrupted()
{
    if (signalled) throw Interrupted();
}

}
