// Tile sets and tilings of an experiment: their tiles as text, and how random the colours of a tiling are.
#pragma once

#include "analysis/color_statistics.hpp"
#include "experiment/tiling_table.hpp"

#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

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
    std::uint64_t samples = 0; ///< every second tile along x and y: these share no corners and no edges
    std::optional<FrequencyTest>
        tiles; ///< of the tiles of the set; not where fewer than ten of each are expected
    std::vector<ColorStatistics> colors;
};

inline constexpr std::uint64_t statistics_size = 1024;
inline constexpr int statistics_lags = 320; ///< beyond the 256 after which the shortest hash function repeats

/// The file of an autocorrelation, for example "corners-autocorrelation.exr".
std::string autocorrelation_file(const ColorStatistics& colors);

/// The text of tiles.txt: indices separated by blanks, a row a line, north first; of cubes, layers from the
/// bottom, an empty line between them; of a set, all tiles in one line.
std::string tiles_text(const TilingConfig& config);

/// Of a tiling that does not close after a period; tilings that do repeat because they are asked to.
TilingStatistics tiling_statistics(const TilingConfig& config);

}
