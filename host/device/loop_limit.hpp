// Drivers that end loops early, without a word, are not used.
#pragma once

#include <string>

namespace poissonlab {

/// Mesa's driver for processors, llvmpipe, counts the iterations of all loops of a work-item together. After 65,535 of
/// them it lets each loop end with the iteration that it is in, whatever its condition is (LP_MAX_TGSI_LOOP_ITERATIONS
/// in Mesa 22.3). Points come out wrong then, or darts are never settled. Lanes of its vectors that have no work-item,
/// as in work-groups of one, run loops as well: they read zeros, and their iterations count.
bool ends_loops_early(const std::string& device_name);

/// Why a device of this name is not used; empty: it is. POISSONLAB_SHORT_LOOPS in the environment lets tests of small
/// sets use it.
std::string why_loops_are_unreliable(const std::string& device_name);

}
