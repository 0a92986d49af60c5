#include "base/programs/interrupt.hpp"

#include "base/files/leftovers.hpp"
#include "base/programs/interrupt_scope.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <chrono>
#include <csignal>
#include <string_view>
#include <thread>

namespace poissonlab {
namespace {

constexpr auto patience = std::chrono::milliseconds(700);

volatile std::sig_atomic_t signalled = 0;
std::array<int, 2> signal_pipe{-1, -1};
std::atomic<bool> is_told = false;
/// The message is never destroyed, because the watching thread outlives main.
std::string& message = *new std::string("poissonlab: interrupted\n");

void remember(int signal)
{
    signalled = 1;
    std::signal(signal, SIG_DFL);
    const char byte = 0;
    [[maybe_unused]] const auto written = ::write(signal_pipe[1], &byte, 1);
}

/// Waits for the first signal, and then for the rest of the process to end.
void watch()
{
    char byte = 0;
    if (::read(signal_pipe[0], &byte, 1) != 1) return;
    std::this_thread::sleep_for(patience);
    tell_of_interruption();
    remove_all_leftovers();
    ::_exit(exit_interrupted);
}

/// The watching thread must not be the one that gets signals: a handler may run in any thread that does not block them.
void start_watching()
{
    sigset_t all;
    sigset_t before;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    std::thread(watch).detach();
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

}

void catch_interrupts()
{
    // Output that nobody reads any more (`poissonlab run ... | head`) is no reason to leave half a result.
    std::signal(SIGPIPE, SIG_IGN);
    if (::pipe2(signal_pipe.data(), O_CLOEXEC) != 0) return; // without, a signal ends the process as it is
    start_watching();
    for (const int signal : {SIGINT, SIGTERM, SIGHUP})
        // A signal that the parent process had us ignore (nohup) stays ignored.
        if (std::signal(signal, remember) == SIG_IGN) std::signal(signal, SIG_IGN);
}

void say_when_interrupted(const std::string& advice)
{
    message = "poissonlab: interrupted" + (advice.empty() ? "" : "; " + advice) + "\n";
}

void say_nothing_when_interrupted() { message.clear(); }

void tell_of_interruption() noexcept
{
    if (is_told.exchange(true) || message.empty()) return;
    constexpr std::string_view emptied_line = "\r\033[K"; // of a bar that may be there
    if (::isatty(STDOUT_FILENO)) [[maybe_unused]]
        const auto emptied = ::write(STDOUT_FILENO, emptied_line.data(), emptied_line.size());
    [[maybe_unused]] const auto written = ::write(STDERR_FILENO, message.data(), message.size());
}

void stop_if_interrupted()
{
    if (signalled) throw Interrupted();
}

InterruptScope::InterruptScope()
{
    signalled = 0;
    struct sigaction remembering = {};
    remembering.sa_handler = [](int) { signalled = 1; };
    remembering.sa_flags = SA_RESTART;
    sigemptyset(&remembering.sa_mask);
    sigaction(SIGINT, nullptr, &before_);
    if (before_.sa_handler != SIG_IGN) sigaction(SIGINT, &remembering, nullptr);
}

InterruptScope::~InterruptScope()
{
    sigaction(SIGINT, &before_, nullptr);
    signalled = 0;
}

}
