// Ctrl-C and `kill`: stop between two realizations and clean up, instead of leaving half a result.
#pragma once

#include <stdexcept>

namespace poissonlab {

/// The user asked the program to stop.
class Interrupted : public std::runtime_error
{
public:
    Interrupted() : std::runtime_error("interrupted") {}
};

/// From now on the first SIGINT, SIGTERM or SIGHUP is remembered; the second ends the process at once. A
/// closed pipe no longer ends it.
void catch_interrupts();

/// Throws Interrupted when a signal has come.
void stop_if_interrupted();

}
