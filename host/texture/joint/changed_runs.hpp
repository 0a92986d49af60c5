// Pixels that a move changes, in little room: many moves are looked for before one is made.
#pragma once

#include "host/texture/joint/assembly.hpp"

#include <vector>

namespace poissonlab {

/// Changed pixels beside each other in a row of a tile, whose sources are beside each other as well.
struct ChangedRun
{
    ChangedPixel first;
    int length = 0;
};

std::vector<ChangedRun> runs_of(const std::vector<ChangedPixel>& pixels);

/// The pixels again, in their order.
std::vector<ChangedPixel> pixels_of(const std::vector<ChangedRun>& runs);

}
