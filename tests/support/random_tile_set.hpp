// Tile sets of any kind with arbitrary points, and their files: for tests of look-ups, to which distances do
// not matter.
#pragma once

#include "tiles/poisson/poisson_tile_set.hpp"

#include <algorithm>
#include <bit>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <random>
#include <string>
#include <vector>

namespace poissonlab {

/// `tiles`: of template tiles; other kinds have as many as their colours give.
inline PoissonTileSet random_tile_set(PoissonTileKind kind, int dimension, std::uint32_t colors,
                                      std::uint32_t points_per_tile, std::uint32_t tiles = 1)
{
    PoissonTileSet set;
    PoissonTileParameters& p = set.parameters;
    p.kind = kind;
    p.dimension = dimension;
    p.colors = colors;
    p.tiles = kind == PoissonTileKind::frame ? tiles : tile_count(kind, dimension, colors);
    p.points_per_tile = points_per_tile;
    p.relative_radius = 0.3;
    std::mt19937_64 random(colors * 1000 + points_per_tile);
    set.points.resize(std::size_t{p.tiles} * points_per_tile * static_cast<std::size_t>(dimension));
    for (std::uint16_t& coordinate : set.points) coordinate = static_cast<std::uint16_t>(random());
    return set;
}

/// A set whose points lie up to half a tile outside of their squares, as those of chains may.
inline PoissonTileSet random_chain_set(std::uint32_t colors, std::uint32_t points_per_tile)
{
    PoissonTileSet set = random_tile_set(PoissonTileKind::corner, 2, colors, points_per_tile);
    set_border(set.parameters, TileBorder::chain);
    set.chain_lengths.resize(std::size_t{2} * colors * colors);
    return set;
}

/// Corner tiles whose points have classes, so many of each in a tile.
inline PoissonTileSet random_class_set(std::uint32_t colors, const std::vector<std::uint32_t>& class_points)
{
    const TileClasses classes = classes_of_radius(class_points, 0.2, 2);
    PoissonTileSet set = random_tile_set(PoissonTileKind::corner, 2, colors, classes.all_points());
    set_classes(set.parameters, classes);
    set.class_squared_distances.resize(class_pair_count(classes.count()));
    return set;
}

/// The set with an arbitrary order of the points of each tile.
inline PoissonTileSet with_random_ranks(PoissonTileSet set)
{
    const std::uint32_t n = set.parameters.points_per_tile;
    set.parameters.ranked = true;
    set.ranks.resize(std::size_t{set.parameters.tiles} * n);
    std::mt19937_64 random(n);
    for (auto first = set.ranks.begin(); first != set.ranks.end(); first += n) {
        std::iota(first, first + n, std::uint16_t{0});
        std::shuffle(first, first + n, random);
    }
    return set;
}

/// The file that docs/tile-set-file.md describes, but for the checksum and parameters that nothing depends on, which
/// are 0.
inline std::string tile_set_file_bytes(const PoissonTileSet& set)
{
    std::string bytes = "PTILES\r\n";
    const auto put = [&](std::uint64_t value, int size) {
        for (int byte = 0; byte < size; ++byte) bytes.push_back(static_cast<char>(value >> 8 * byte));
    };
    const PoissonTileParameters& p = set.parameters;
    const bool has_chains = p.border == TileBorder::chain;
    const auto classes = static_cast<std::uint32_t>(p.classes.count());
    for (const std::uint32_t word : {classes > 0              ? 3u
                                     : has_chains || p.ranked ? 2u
                                                              : 1u,
                                     128u, static_cast<std::uint32_t>(p.kind), static_cast<std::uint32_t>(p.dimension),
                                     p.colors, p.tiles, p.points_per_tile, classes})
        put(word, 4);
    put(set.squared_min_distance, 8);
    put(std::bit_cast<std::uint64_t>(p.relative_radius), 8);
    put(p.seed, 8);
    bytes.resize(128);
    if (has_chains) {
        bytes[88] = 1;
        const auto [low, high] = std::minmax_element(set.points.begin(), set.points.end());
        const int below = std::max(0, 32768 - 2 * *low), above = std::max(0, 2 * *high - 98304);
        for (std::size_t byte = 0; byte < 4; ++byte) {
            bytes[100 + byte] = static_cast<char>(below >> 8 * byte);
            bytes[104 + byte] = static_cast<char>(above >> 8 * byte);
        }
    }
    bytes[108] = p.ranked ? 1 : 0;
    for (const std::uint16_t coordinate : set.points) put(coordinate, 2);
    for (const std::uint16_t length : set.chain_lengths) put(length, 2);
    for (const std::uint16_t rank : set.ranks) put(rank, 2);
    for (const std::uint32_t points : p.classes.points) put(points, 4);
    for (std::uint32_t high = 0; high < classes; ++high)
        for (std::uint32_t low = 0; low <= high; ++low)
            put(std::bit_cast<std::uint64_t>(p.classes.distances.at(low, high)), 8);
    for (const std::uint64_t squared : set.class_squared_distances) put(squared, 8);
    return bytes;
}

inline void write_tile_set_file(const std::filesystem::path& path, const PoissonTileSet& set)
{
    const std::string bytes = tile_set_file_bytes(set);
    std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

}
