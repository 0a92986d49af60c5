// The settings of [[distribution]] kind = "cells": see tiles/cells/cell_map.hpp.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>

namespace poissonlab {

struct CellSettings
{
    std::filesystem::path alphabet;
    std::array<std::int64_t, 4> window{0, 0, 48, 27}; ///< X, Y, width and height, in cells
};

}
