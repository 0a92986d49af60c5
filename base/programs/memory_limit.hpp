// The memory that a process may have.
#pragma once

#include <cstdint>

namespace poissonlab {

/// Bytes: those of the machine, or of the control group or the limit on addresses (ulimit -v) where these are less.
std::uint64_t memory_limit();

}
