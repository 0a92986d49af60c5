// The memory that a process may have.
#pragma once

#include <cstdint>

namespace poissonlab {

/// Bytes: a share of the machine's or the control group's, which so many processes divide, or those of the limit on
/// addresses (ulimit -v), which each of them has, where these are less.
std::uint64_t memory_limit(std::uint64_t processes = 1);

}
