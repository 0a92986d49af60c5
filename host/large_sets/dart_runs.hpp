// Points of blocks on disk, each block's in the order of darts, so that any interval of the order can be read back from
// all of them: the first half of sorting more points than memory holds.
#pragma once

#include "host/sampling/darts/dart_request.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

namespace poissonlab {

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
