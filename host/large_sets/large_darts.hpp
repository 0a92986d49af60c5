// Dart throwing of one set that need not fit in memory, by one process or several: blocks of the torus, put together.
//
// Each block is made by whichever process is free (host/sampling/darts/darts_in_blocks.hpp says why the result is that
// of the whole torus) and kept on disk, beside the file to be written, until all are there; then the file is written
// piece by piece, in the order in which darts fall. Bytes do not depend on blocks or processes.
#pragma once

#include "base/crew/placed_pieces.hpp"
#include "host/kinds/distribution_place.hpp"
#include "host/sampling/dart_throwing.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>

namespace poissonlab {

struct LargeDarts
{
    DartThrowingRequest darts;         ///< `points` of them, or to saturation
    std::uint32_t block_side = 0;      ///< cells of level 0 along each axis, halo included, at most
    std::uint64_t expected_points = 0; ///< nearly
};

/// The largest block side, up to the one that is fast, whose buffers take no more than `most_bytes` on the device, or
/// by the reference where there is none. Throws InputError, a line about the option --memory, where no block has room.
std::uint32_t block_side_for(const DartThrowingRequest& darts, std::uint64_t most_bytes,
                             const std::optional<DeviceInfo>& device);

/// Writes the set. `head` lacks the number of points. To be called by all processes of the crew. Returns the number of
/// points, in the process that leads. Throws InputError where the set is saturated before it has its points, or the
/// disk has no room, StorageError.
std::uint64_t write_large_darts(const std::filesystem::path& path, PointFileHead head, const LargeDarts& set,
                                const DistributionPlace& place, Crew& crew);

}
