// The member "tilings" of results.json: tile sets and tilings, and how random the colours of tilings are.
#pragma once

#include "base/files/stored_object.hpp"
#include "tiles/tilings/tile_set.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

/// Pearson's test of equal frequencies.
struct StoredFrequencies
{
    double chi_square = 0;
    double p_value = 1;
};

/// The colours of corners or of edges.
struct StoredColors
{
    std::string name;
    std::size_t count = 0; ///< number of colours
    StoredFrequencies frequencies;
    std::string autocorrelation_file;
    int lags = 0;
    double largest = 0;
    std::array<double, 2> largest_at{};
    double bound = 0;
};

struct StoredTilingStatistics
{
    std::size_t size = 0; ///< tiles along each axis
    std::size_t samples = 0;
    std::optional<StoredFrequencies> tiles;
    std::vector<StoredColors> colors;
};

struct TilingResult
{
    std::string name; ///< its folder
    std::string label;
    TileKind kind = TileKind::corner;
    Color colors = 2;
    std::size_t tiles = 0; ///< in the set
    std::string file;      ///< tile indices, relative to the result folder
    double regions = 0;    ///< Poisson disk radius of the regions that are drawn; 0: tiles are
    std::string set;       ///< of a tile set: which; empty: a tiling, with all that follows
    std::string algorithm;
    std::string hash; ///< empty: scanlines have none
    std::vector<double> hash_period;
    std::vector<double> period;
    std::array<std::int64_t, 3> origin{};
    std::array<std::size_t, 3> size{1, 1, 1}; ///< of the window, in tiles
    std::optional<StoredTilingStatistics> statistics;

    /// The number of tiles in the file.
    std::size_t shown() const { return set.empty() ? size[0] * size[1] * size[2] : tiles; }
};

/// Throws InputError for members of another kind.
std::vector<TilingResult> read_tilings(const StoredObject& root);

/// The tile indices that a tiling's file holds, as many as shown(), row after row as they are stored. Throws
/// InputError for another number of them, and for indices that no tile has.
std::vector<TileIndex> read_tiles(const std::filesystem::path& folder, const TilingResult& tiling);

}
