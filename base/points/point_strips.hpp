// The points of a set that need not fit in memory, kept on disk in strips along the last axis: what measures ask for
// are points near each other.
#pragma once

#include "base/geometry/point_set.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

namespace poissonlab {

class PointStrips
{
public:
    /// An empty set of about `expected` points, in a folder that is there. Strips have some million points, and are
    /// higher than several mean distances of neighbours.
    PointStrips(std::filesystem::path folder, int dimension, std::uint64_t expected);

    /// Adds whole points, coordinates in [0, 1). Throws StorageError.
    void add(std::span<const double> coordinates);

    /// Puts what was added onto the disk: afterwards points can be read. Throws StorageError.
    void finish();

    int dimension() const { return dimension_; }
    std::uint64_t size() const { return points_; }
    std::size_t count() const { return buffers_.size(); }

    /// The bytes that a point takes on the disk.
    static std::uint64_t bytes_per_point(int dimension)
    {
        return sizeof(double) * static_cast<std::uint64_t>(dimension);
    }

    /// The last coordinate at which a strip begins.
    double begin_of(std::size_t strip) const { return static_cast<double>(strip) / static_cast<double>(count()); }

    /// The points of a strip, in the order in which they were added. Throws StorageError.
    PointSet strip(std::size_t number) const;

    /// Appends the points of other strips whose last coordinate is less than `below` before the begin of the strip, or
    /// less than `above` behind its end, both at most 1; on the torus, or, in a window, up to its borders. Each point
    /// comes once. Throws StorageError.
    void append_around(std::size_t number, double below, double above, bool is_window, PointSet& points) const;

private:
    std::filesystem::path file_of(std::size_t strip) const;
    void write_out(std::size_t strip);
    std::vector<double> read(std::size_t strip) const;

    std::filesystem::path folder_;
    int dimension_;
    std::uint64_t points_ = 0;
    std::vector<std::vector<double>> buffers_; ///< of each strip, not on the disk yet
};

}
