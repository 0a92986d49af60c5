// Random numbers as a function of what they are for: Philox4x32-10 of Random123, keyed and counted.
//
// No generator has state, so the order in which numbers are asked for, the number of threads and the number
// of processes change nothing. kernels/common/philox.clh is the same function on the device.
#pragma once

#include <array>
#include <cstdint>

namespace poissonlab {

/// The purposes that random numbers serve. Values are part of the results: never renumber, only append.
enum class Purpose : std::uint32_t
{
    random_points = 1,
    jittered_points = 2,
    dart_throwing = 3,
    relaxation_dart_throwing = 4,
    tile_filling = 5,
    chain_corners = 6,
    joint_tiling = 7,
    tile_ranking = 8,
    tiling_colors = 16,
    scanline_tiling = 17,
    tile_choice = 18,
    other_program = 19,
    digit_scrambling = 20,
    best_candidate = 21,
    bridson = 22,
    wang_darts = 23,
    wang_starts = 24,
    wang_surroundings = 25,
    wang_tilings = 26,
    sector_darts = 27,
    penrose_window = 28,
    polyomino_division = 30,
    polyomino_seed = 31,
    recursive_tile_darts = 32,
    recursive_tile_words = 33,
    recursive_tilings = 34,
    voronoi_darts = 35,
    sample_elimination = 39,
    tile_packing = 41,
    texture_windows = 42,
    texture_variants = 43,
    texture_scanlines = 44,
    beatty_tiling = 53,
    ammann_tiling = 54,
    tiling_search = 55,
    edge_curves = 56,
    isohedral_points = 57,
    mesh_colors = 58,
    hyperuniformity_test = 60,
    variance_windows = 61,
    texture_quilting = 64,
    class_darts = 70,
    mri_mask = 71,
    dither_mask = 72,
    region_envelope = 73,
    varied_darts = 80,
    varied_candidates = 81,
    class_tile_filling = 90,
    surface_darts = 100,
    surface_candidates = 101,
    surface_coverage = 102,
    class_labels = 103,
};

/// The 64-bit key of one independent stream.
using StreamKey = std::array<std::uint32_t, 2>;

/// Four independent uniform 32-bit words for a 128-bit counter: Philox4x32-10
/// (Salmon, Moraes, Dror, Shaw: Parallel random numbers: as easy as 1, 2, 3, SC 2011).
std::array<std::uint32_t, 4> philox(const std::array<std::uint32_t, 4>& counter, const StreamKey& key);

/// The stream of a purpose and a realization under a seed: the seed is the Philox key, the rest its counter,
/// so that streams that differ in anything share nothing.
StreamKey stream_key(std::uint64_t seed, Purpose purpose, std::uint32_t realization, std::uint32_t attempt = 0);

}
