#include "app/program.hpp"

#include "app/command_line.hpp"
#include "app/commands/command.hpp"
#include "base/crew/crew.hpp"
#include "base/crew/failure.hpp"
#include "base/errors/missing_module.hpp"
#include "base/files/standard_streams.hpp"
#include "base/programs/interrupt.hpp"

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <vector>

#include <malloc.h>
#include <unistd.h>

namespace poissonlab {
namespace {

constexpr int exit_other = 1;
constexpr int exit_device = 3;

/// Says what is wrong. Returns the status.
int fail(int status, const std::string& message)
{
    if (is_crew_follower()) return status; // the process that leads says it
    std::fflush(stdout);
    // fmt would throw where standard error is closed, too.
    std::fputs(("poissonlab: error: " + message + "\n").c_str(), stderr);
    return status;
}

/// Returns the status, unless some of the output is lost.
int flushed(int status)
{
    const bool is_lost = std::fflush(stdout) != 0 || std::ferror(stdout) != 0;
    return is_lost ? fail(exit_other, "cannot write to standard output") : status;
}

/// Hands the command on to ./lab, which has started this program and says so by POISSONLAB_LAB: it adds the module and
/// starts the program anew, in this process. Returns where there is no such script, and where it has just added this
/// module: to ask again would never end.
void call_for_module(const std::string& module, const char* const* argv)
{
    const char* const lab = std::getenv("POISSONLAB_LAB");
    const char* const added = std::getenv("POISSONLAB_ADDED");
    if (!lab || is_crew_follower() || (added && module == added)) return;
    ::setenv("POISSONLAB_ADDED", module.c_str(), 1);
    std::fflush(stdout);
    std::vector<const char*> words{lab, "--with", module.c_str()};
    for (const char* const* word = argv + 1; *word; ++word) words.push_back(*word);
    words.push_back(nullptr);
    ::execv(lab, const_cast<char* const*>(words.data())); // comes back where it fails
}

/// Says what the exception being handled is. Returns the exit status.
int tell_of_exception()
{
    Failure failure;
    try {
        stop_if_interrupted(); // what fails after a signal, such as a program that got it as well, is no error
        throw;
    } catch (...) {
        failure = Failure::current();
    }
    switch (failure.kind) {
    case Failure::Kind::interrupted:
        std::fflush(stdout);
        tell_of_interruption();
        return exit_interrupted;
    case Failure::Kind::input:
        return fail(exit_wrong_input, failure.message);
    case Failure::Kind::device:
        return fail(exit_device, failure.message);
    default:
        return fail(exit_other, failure.message);
    }
}

/// Lets the process keep memory that it frees. An array of some megabytes would otherwise be given back, and the next
/// one would get pages that the system maps and clears one by one: half of the system's time in a run.
void keep_freed_memory()
{
#ifdef __GLIBC__
    mallopt(M_MMAP_THRESHOLD, 32 << 20); // the largest that the library allows
    mallopt(M_TRIM_THRESHOLD, 256 << 20);
#endif
}

}

int program_main(int argc, const char* const* argv)
{
    open_standard_streams();
    keep_freed_memory();
    try {
        const auto actions = actions_called_for(argc, argv);
        int status = 0;
        if (!actions.empty()) catch_interrupts();
        for (const Action& action : actions)
            if (status == 0) status = action();
        return flushed(status);
    } catch (const MissingModule& error) {
        call_for_module(error.module(), argv);
        return fail(exit_other, error.what());
    } catch (const std::exception&) {
        return tell_of_exception();
    }
}

}
