// Dart throwing of one set that need not fit in memory, by one process or several: blocks of the torus, put together.
//
// Each block is made by whichever process is free (host/sampling/darts/darts_in_blocks.hpp says why the result is that
// of the whole torus) and kept on disk, beside the file to be written, until all are there; then the file is written
// piece by piece, in the order in which darts fall. Bytes do not depend on blocks or processes.
#pragma once

#include "base/crew/placed_pieces.hpp"
#include "host/kinds/distribution_place.hpp"
#include "host/sampling/dart_throwing.hpp"
#include "host/sampling/darts/dart_request.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

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

// Points of blocks on disk, each block's in the order of darts, so that any interval of the order can be read back from
// all of them: the first half of sorting more points than memory holds.

/// A division of the order of darts into intervals: each batch into equal ones of time.
class DartIntervals
{
public:
    /// Chooses intervals of some hundred thousand points at most, for a set of so many points.
    explicit DartIntervals(std::uint64_t points);

    std::size_t count() const { return std::size_t{most_batches} << bits_; }

    /// The interval of a point, by the first two words of an OrderedDart.
    std::size_t interval_of(std::uint32_t batch, std::uint32_t time) const;

private:
    static constexpr std::uint32_t most_batches = 128; ///< later ones, if there ever are any, are in one interval

    unsigned bits_;
};

/// The intervals before which pieces begin, and the number of all intervals: each piece has some million points, unless
/// one interval alone has more, or it is the last one.
std::vector<std::size_t> dart_pieces(std::span<const std::uint64_t> points_of_intervals);

/// Writes the points of a block, which are in their order, and adds their numbers to those of intervals. Throws
/// StorageError.
template <int D>
void write_run(const std::filesystem::path& file, std::span<const OrderedDart<D>> darts, const DartIntervals& intervals,
               std::vector<std::uint64_t>& points_of_intervals);

/// Appends the points of the intervals `first` ... `end` - 1 of a file that write_run() has made. Throws StorageError.
template <int D>
void read_run(const std::filesystem::path& file, const DartIntervals& intervals, std::size_t first, std::size_t end,
              std::vector<OrderedDart<D>>& darts);

}
