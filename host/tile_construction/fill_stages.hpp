// The number of tries of fillings, and their random numbers: every stage of a construction has its own.
#pragma once

#include <cstdint>

namespace poissonlab {

/// Fillings of a tile before a piece of its border is made again.
inline constexpr std::uint32_t max_tile_attempts = 8;

/// Tiles with chains, and all tiles after joint relaxation, get this many fillings: with a relative radius of 0.85 a
/// third of fillings fail, and a chain or strip that is made again, or goes back, is one of many tiles, some of which
/// fail then.
inline constexpr std::uint32_t patient_tile_attempts = 48;

/// The most rounds in which pieces are made again for tiles that could not be filled.
inline constexpr std::uint32_t max_rounds = 12;

/// Rounds of fillings of a tile until it has the moments of all.
inline constexpr std::uint32_t moment_rounds = 4;

/// Joint iterations at the end that move insides of tiles alone: borders are final before tiles are mended.
inline constexpr std::uint32_t last_joint_iterations = 3;

/// Random numbers of a round begin here.
inline constexpr std::uint32_t attempts_a_round = 64;

/// Stages of boundary_stages() have lower numbers.
inline constexpr std::uint32_t frame_stage = 8;
inline constexpr std::uint32_t interior_stage = 9;
inline constexpr std::uint32_t chain_stage = 10;
inline constexpr std::uint32_t inside_stage = 11; ///< inside of chains
inline constexpr std::uint32_t repair_stage = 12; ///< after joint relaxation
inline constexpr std::uint32_t moment_stage = 13; ///< while tiles get equal moments

}
