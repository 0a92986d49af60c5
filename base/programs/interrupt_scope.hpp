// Ctrl-C while the laboratory works for a program of others, such as a Python interpreter, which must go on.
#pragma once

#include <csignal>

namespace poissonlab {

/// While an InterruptScope lives, SIGINT is remembered, stop_if_interrupted() throws then, and nothing ends the
/// process. The handler that was there before comes back at its end. Only one may live at a time.
class InterruptScope
{
public:
    InterruptScope();
    ~InterruptScope();
    InterruptScope(const InterruptScope&) = delete;
    InterruptScope& operator=(const InterruptScope&) = delete;

private:
    struct sigaction before_ = {};
};

}
