// How random the colours of a tiling are.
#pragma once

#include "analysis/tilings/color_statistics.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

inline constexpr std::uint64_t statistics_size = 1024;

/// The colours of one kind of place of a tiling.
struct ColorStatistics
{
    std::string name; ///< "corners", "horizontal edges" or "vertical edges"
    std::vector<std::uint64_t> counts;
    FrequencyTest frequencies;
    ColorAutocorrelation autocorrelation;
};

/// Of statistics_size x statistics_size tiles from the lower left of the window, of cubes of its lowest
/// layer.
struct TilingStatistics
{
    std::uint64_t samples = 0;          ///< every second tile along x and y: these share no corners and no edges
    std::optional<FrequencyTest> tiles; ///< of the tiles of the set; not where fewer than ten of each are expected
    std::vector<ColorStatistics> colors;
};

/// The file of an autocorrelation, for example "corners-autocorrelation.exr".
std::string autocorrelation_file(const ColorStatistics& colors);

}
