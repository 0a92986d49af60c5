// The readers behind read_points, one a format, and the errors that they share.
#pragma once

#include "base/geometry/point_set.hpp"
#include "base/points/point_file.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace poissonlab {

/// The content of a point file, the name by which errors call it, and what its coordinates can be.
struct PointFileContent
{
    std::string name;
    std::string_view bytes;
    PointDomain domain = {};
};

/// Takes the unit coordinates of a set that is read in pieces, each of whole points, and the place in the file up to
/// which it is not needed any more.
using PieceSink = std::function<void(int dimension, std::span<const double> coordinates, const char* done)>;

// They read files of one set in pieces, and else do as those below.
void stream_text_points(const PointFileContent& file, const PieceSink& sink);
void stream_npy_points(const PointFileContent& file, const PieceSink& sink);

/// The sizes that the head of a .npy file has.
struct NpyShape
{
    std::uint64_t sets = 0, points = 0; ///< points of each set
    int dimension = 2;
};
NpyShape shape_of_npy_sets(const PointFileContent& file);

// Each throws InputError; what they accept is described at read_points.
std::vector<PointSet> read_text_points(const PointFileContent& file);
std::vector<PointSet> read_ply_points(const PointFileContent& file);
std::vector<PointSet> read_npy_points(const PointFileContent& file);
std::vector<PointSet> read_utk_points(const PointFileContent& file);

/// write_points_in_pieces() for .usda.
void write_usd_points(const std::filesystem::path& path, int dimension, std::size_t points, const std::string& comment,
                      const std::function<void(const PointSink& sink)>& write);

inline constexpr std::string_view ply_magic = "ply";
inline constexpr std::string_view npy_magic = "\x93NUMPY";
/// What is before the numbers of a .npy file of float64, points x dimension.
std::string npy_header(std::uint64_t points, int dimension);

inline constexpr std::string_view hdf5_magic = "\x89HDF\r\n\x1a\n";
inline constexpr std::string_view utk_magic = "UTK!", swapped_utk_magic = "!KTU"; ///< 0x214B5455 of either byte order

/// The domain that a comment before the points declares: `# domain LOW:HIGH`, in PLY `comment domain LOW:HIGH`.
PointDomain declared_domain(const PointFileContent& file);

/// The first line of comma-separated values in 2D and 3D.
inline constexpr std::string_view csv_header_2d = "x,y", csv_header_3d = "x,y,z";

/// False for NaN and infinite numbers as well.
inline bool is_coordinate(double value, const CoordinateRange& range)
{
    return value >= range.low && value < range.high && value > any_coordinates.low;
}

/// The coordinate mapped from its range to [0, 1); unchanged if that is its range, or if the range has no end.
inline double to_unit(double value, const CoordinateRange& range)
{
    if (range.high == any_coordinates.high) return value;
    // The quotient can round to 1.
    return std::min((value - range.low) / (range.high - range.low), 1 - 0x1p-53);
}

/// Appends the number in `word` to `coordinates`. Throws InputError when it is no coordinate along the axis.
void append_coordinate(const PointFileContent& file, int line, std::size_t axis, std::string_view word,
                       std::vector<double>& coordinates);

/// Throws InputError for a coordinate of a binary file.
[[noreturn]] void fail_coordinate_at_byte(const PointFileContent& file, std::size_t axis, std::size_t offset,
                                          double value);

/// Throws InputError `file:line: value: allowed`; line 0 is left out.
[[noreturn]] void fail_in_point_file(const PointFileContent& file, int line, std::string_view value,
                                     std::string_view allowed);

}
