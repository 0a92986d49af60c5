// Files of points in which each number has a place that is known before any is written: NumPy and HDF5. Pieces may be
// written in any order, by any thread, and by several processes into one file. Memory does not depend on the file.
//
// .npy     float64, N x dimension.
// .h5      HDF5: /points (N x dimension, float64, in chunks) with the attributes `domain`, where there is one, and
//          `comment`.
// .hdf5, .h5part  particles in 3D, see particle_file.hpp.
#pragma once

#include "base/points/point_file.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace poissonlab {

/// The numbers that a file states about its points.
struct PointFileHead
{
    int dimension = 2;
    std::uint64_t points = 0;
    double side = 1;                         ///< coordinates are in [0, side); 0: anywhere
    bool fills_square = true;                ///< points are in all of that square (cube), not in a part that is lower
    std::string unit = "sides of the torus"; ///< of lengths
    std::string comment{};
};

/// True for names of files with known places.
bool has_known_places(const std::filesystem::path& path);

/// Throws InputError where the format does not take such points.
void check_head(const std::filesystem::path& path, const PointFileHead& head);

/// Throws InputError where the disk has no room for the file, and says how many points it has room for. Each point
/// takes `scratch` bytes more there while the file is made.
void check_room(const std::filesystem::path& path, const PointFileHead& head, std::uint64_t scratch = 0);

/// Rows of numbers in a file.
struct PlacedColumn
{
    enum class Content
    {
        points, ///< all coordinates of a point in a row
        axis,   ///< one coordinate, divided by the side
        number, ///< of the point, from 1 on
    };

    Content content = Content::points;
    std::size_t axis = 0;
    std::uint64_t rows_per_chunk = 0;
    std::vector<std::uint64_t> chunks; ///< the bytes of the file at which they begin
};

/// Makes the file without the numbers of its points. `target` is the file's name for the user, and says its format.
/// Throws StorageError.
void create_placed_file(const std::filesystem::path& file, const std::filesystem::path& target,
                        const PointFileHead& head);

/// Puts points at their places in a file that create_placed_file() has made, with the same arguments.
class PlacedFile
{
public:
    /// Throws StorageError.
    PlacedFile(const std::filesystem::path& file, const std::filesystem::path& target, const PointFileHead& head);
    ~PlacedFile();
    PlacedFile(const PlacedFile&) = delete;
    PlacedFile& operator=(const PlacedFile&) = delete;

    /// Writes whole points, of which `first` are before. May be called by several threads. Throws StorageError.
    void put(std::uint64_t first, std::span<const double> coordinates) const;

    /// Throws StorageError where the system finds only now that it cannot write.
    void close();

private:
    [[noreturn]] void fail() const;
    void put_rows(const PlacedColumn& column, std::uint64_t first, std::span<const std::byte> rows,
                  std::size_t row_bytes) const;

    std::filesystem::path target_;
    std::size_t dimension_;
    double side_;
    std::vector<PlacedColumn> columns_;
    int file_ = -1;
};

/// Writes a file with known places from points that come in their order, in pieces. Whole or not at all. Throws
/// InputError when `write` hands over another number of points than the head says, StorageError.
void write_placed_points(const std::filesystem::path& path, const PointFileHead& head,
                         const std::function<void(const PointSink& sink)>& write);

}
