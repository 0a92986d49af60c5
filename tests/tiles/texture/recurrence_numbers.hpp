// Printed by recurrence.py.
#pragma once

namespace poissonlab {

/// For one channel and three: what recurs with each tile, and with 3 x 2 tiles.
inline constexpr double recurrence_numbers[2][2] = {
    {0.214536933735014, 0.249716416699925},
    {0.35058982217783, 0.384485144054093},
};

}
