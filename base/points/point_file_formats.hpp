// The readers behind read_points, one a format, and the errors that they share.
#pragma once

#include "base/geometry/point_set.hpp"
#include "base/points/point_file.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace poissonlab {

/// The content of a point file, the name by which errors call it, and what its coordinates can be.
struct PointFileContent
{
    std::string name;
    std::string_view bytes;
    CoordinateRange range = {};
};

// Each throws InputError; what they accept is described at read_points.
std::vector<PointSet> read_text_points(const PointFileContent& file);
std::vector<PointSet> read_ply_points(const PointFileContent& file);
std::vector<PointSet> read_npy_points(const PointFileContent& file);

inline constexpr std::string_view ply_magic = "ply";
inline constexpr std::string_view npy_magic = "\x93NUMPY";

/// False for NaN as well.
inline bool is_coordinate(double value, const CoordinateRange& range)
{
    return value >= range.low && value < range.high;
}

/// The coordinate mapped from its range to [0, 1); unchanged if that is its range.
double to_unit(double value, const CoordinateRange& range);

/// Appends the number in `word` to `coordinates`. Throws InputError when it is no coordinate.
void append_coordinate(const PointFileContent& file, int line, std::string_view word, std::vector<double>& coordinates);

/// Throws InputError for a coordinate of a binary file.
[[noreturn]] void fail_coordinate_at_byte(const PointFileContent& file, std::size_t offset, double value);

/// Throws InputError `file:line: value: allowed`; line 0 is left out.
[[noreturn]] void fail_in_point_file(const PointFileContent& file, int line, std::string_view value,
                                     std::string_view allowed);

}
