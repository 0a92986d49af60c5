// Ctrl-C and `kill`: stop at the next opportunity, or within a second without one.
#pragma once

#include <stdexcept>
#include <string>

namespace poissonlab {

/// The exit status of a process that was asked to stop.
inline constexpr int exit_interrupted = 130;

/// The user asked the program to stop.
class Interrupted : public std::runtime_error
{
public:
    Interrupted() : std::runtime_error("interrupted") {}
};

/// Catches interrupts from now on: the first SIGINT, SIGTERM or SIGHUP is remembered, and ends the process after 0.7 s
/// if it still runs then; the unfinished work is lost, which is all that a kernel or a triangulation could save by
/// going on. The second one ends the process at once. A closed pipe no longer ends it.
void catch_interrupts();

/// Sets the advice on how to go on that the user reads when the process stops; with "", only "interrupted" is said.
void say_when_interrupted(const std::string& advice);

/// Leaves the message to another process of the crew.
void say_nothing_when_interrupted();

/// Says that the process was interrupted, once. Empties the line of a terminal that is being updated.
void tell_of_interruption() noexcept;

/// Throws Interrupted when a signal has come.
void stop_if_interrupted();

}
