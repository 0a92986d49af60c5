// The vectors by which points of a Penrose tiling move away from its corners.
#pragma once

#include "kernels/common/tile_sampling/penrose.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>

namespace poissonlab {

/// A movement in the frame of a point, in units of 2^-vector_bits of its level's scale: along its direction, and to the
/// left of it.
struct PenroseVector
{
    std::int32_t along = 0;
    std::int32_t left = 0;

    bool operator==(const PenroseVector&) const = default;
};

inline constexpr int vector_bits = 14;

/// Neither part of a vector is more than that many scales.
inline constexpr int longest_vector = 2;

/// A row for each of the importances between one level and the next, in equal ratios; in it a vector for each
/// structural index. The table of zeros leaves points at the corners of the tiling.
struct PenroseTable
{
    std::array<std::array<PenroseVector, contract::penrose::INDICES>, contract::penrose::ROWS> rows{};

    bool operator==(const PenroseTable&) const = default;
};

/// The table in a text file with its checksum. Throws StorageError.
void write_penrose_table(const std::filesystem::path& file, const PenroseTable& table);

/// The table of such a file; nothing for files that are missing, damaged, or of another size.
std::optional<PenroseTable> read_penrose_table(const std::filesystem::path& file);

}
