// A tile set or tiling of a run: the member "tilings" of results.json, and how random the colours of tilings are.
#pragma once

#include "analysis/tilings/color_statistics.hpp"
#include "tiles/tilings/tile_set.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

class JsonMembers;

/// The colours of one kind of place of a tiling.
struct ColorStatistics
{
    std::string name; ///< "corners", "horizontal edges" or "vertical edges"; of Wang cubes also "top and bottom faces"
    std::vector<std::uint64_t> counts;
    FrequencyTest frequencies;
    std::string autocorrelation_file; ///< relative to the run's folder
    ColorAutocorrelation autocorrelation;

    bool operator==(const ColorStatistics&) const = default;
};

/// Statistics of size x size tiles from the lower left of the window, of cubes of its lowest layer.
struct TilingStatistics
{
    std::uint64_t size = 0;
    std::uint64_t samples = 0;          ///< every second tile along x and y: these share no corners and no edges
    std::optional<FrequencyTest> tiles; ///< of the tiles of the set; not where fewer than ten of each are expected
    std::vector<ColorStatistics> colors;

    bool operator==(const TilingStatistics&) const = default;
};

struct TilingResult
{
    std::string name; ///< its folder
    std::string label;
    TileKind kind = TileKind::corner;
    Color colors = 2;
    Color vertical_colors = 0; ///< of the vertical edges of Wang tiles; 0: as many as `colors`
    std::size_t tiles = 0;     ///< in the set
    std::string file;          ///< tile indices
    double regions = 0;        ///< Poisson disk radius of the regions that are drawn; 0: tiles are
    std::string set;           ///< of a tile set: which; empty: a tiling, with all that follows
    std::string algorithm;
    std::array<std::int64_t, 3> origin{}; ///< of the window, in tiles
    std::array<std::size_t, 3> size{1, 1, 1};
    std::string hash;                     ///< empty: scanlines have none
    std::vector<std::size_t> hash_period; ///< along x and y; 0: it never repeats
    std::vector<std::size_t> period;      ///< after how many tiles the tiling closes; 0: not
    std::optional<TilingStatistics> statistics;

    bool operator==(const TilingResult&) const = default;

    WangColors all_colors() const { return {colors, vertical_colors > 0 ? vertical_colors : colors}; }

    /// The number of tiles in the file.
    std::size_t shown() const { return set.empty() ? size[0] * size[1] * size[2] : tiles; }
};

/// The name of the file of an autocorrelation, for example "corners-autocorrelation.exr".
std::string autocorrelation_file(const ColorStatistics& colors);

void members(JsonMembers& m, const TilingResult& tiling);
void members(JsonMembers& m, TilingResult& tiling);

}
