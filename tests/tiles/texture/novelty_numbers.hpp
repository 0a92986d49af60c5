// Printed by novelty.py.
#pragma once

namespace poissonlab {

/// For one channel and three: the threshold, the part of the patches in halves of the exemplar above it, then shares
/// of new patches in plain repetition, in another picture by the same law, and in blocks in another order.
inline constexpr double novelty_numbers[2][5] = {
    {417457.69, 0.10021552, 0, 0.01010101, 0.13468013},
    {1298825, 0.10021552, 0, 0.015151515, 0.075757576},
};

}
