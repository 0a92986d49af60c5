// The readers behind read_points, one a format, and the errors that they share.
#pragma once

#include "base/geometry/point_set.hpp"
#include "base/points/point_file.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
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
    std::function<void(const std::string& sentence)> told = {};
    PointOptions options = {};
    std::string degrees_sentence = {};
    PointClasses classes = {};

    bool has_classes() const { return !classes.column.empty(); }

    void tell(const std::string& sentence) const
    {
        if (told) told(name + ": " + sentence);
    }
};

/// Takes the unit coordinates of a set that is read in pieces, each of whole points, and the place in the file up to
/// which it is not needed any more.
using PieceSink = std::function<void(int dimension, std::span<const double> coordinates, const char* done)>;

// These functions read files of one set in pieces, and read other files as those below do.
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
std::vector<PointSet> read_geojson_points(const PointFileContent& file);
std::vector<PointSet> read_utk_points(const PointFileContent& file);

/// Calls `take` with some points after others: as text they take more room than as numbers.
template <class Take>
void for_pieces_of_text(std::span<const double> coordinates, std::size_t axes, const Take& take)
{
    constexpr std::size_t points_per_piece = 4096;
    while (!coordinates.empty()) {
        const auto piece = coordinates.first(std::min(coordinates.size(), points_per_piece * axes));
        coordinates = coordinates.subspan(piece.size());
        take(piece);
    }
}

/// write_points_in_pieces() for .usda.
void write_usd_points(const std::filesystem::path& path, int dimension, std::size_t points, const std::string& comment,
                      const std::function<void(const PointSink& sink)>& write);

/// The member `crs` of lengths in a system that has no name.
inline constexpr const char* crs_of_lengths = "null";

/// write_points_in_pieces() for .geojson, with the member `crs` if it is not empty: without it, points are in degrees.
/// Each point is a feature, whose number is its property `id`, and `features`, JSON for each point, its property
/// `feature` if they are there.
void write_geojson_points(const std::filesystem::path& path, int dimension, const std::string& crs,
                          const std::string& comment, const std::function<void(const PointSink& sink)>& write,
                          const std::vector<std::string>& features = {});

/// A point as a feature of a list, with a comma before all but the first. `more_properties` begin with a comma.
std::string geojson_feature(std::uint64_t id, const std::string& more_properties, std::span<const double> position);

/// write_points_in_pieces() for .csv, with names of the columns as the first line.
void write_csv_points(const std::filesystem::path& path, int dimension, std::string_view names,
                      const std::function<void(const PointSink& sink)>& write);

/// write_points_in_pieces() for .dxf: entities POINT of AutoCAD's release 12, as text.
void write_dxf_points(const std::filesystem::path& path, int dimension, const std::string& comment,
                      const std::function<void(const PointSink& sink)>& write);

/// The two parts of a DXF file enclose its entities. Lines of the comment are split where release 12 has no room.
std::string dxf_begin(const std::string& comment);
inline constexpr std::string_view dxf_end = "0\nENDSEC\n0\nEOF\n";

/// An object of GeoJSON of this type up to where its points come, with a comma before them.
std::string geojson_begin(const std::string& type, const std::string& crs, const std::string& comment);

inline constexpr std::string_view ply_magic = "ply";
inline constexpr std::string_view npy_magic = "\x93NUMPY";
/// The bytes before the numbers of a .npy file of float64, points x dimension.
std::string npy_header(std::uint64_t points, int dimension);

inline constexpr std::string_view hdf5_magic = "\x89HDF\r\n\x1a\n";
inline constexpr std::string_view utk_magic = "UTK!", swapped_utk_magic = "!KTU"; ///< 0x214B5455 of either byte order

/// The domain that a comment before the points declares: `# domain LOW:HIGH`, in PLY `comment domain LOW:HIGH`, or one
/// range after the other for each axis.
PointDomain declared_domain(const PointFileContent& file);

/// The first line of comma-separated values in 2D and 3D.
inline constexpr std::string_view csv_header_2d = "x,y", csv_header_3d = "x,y,z";
inline constexpr std::string_view csv_header_globe = "longitude,latitude";

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

/// The number in `word`. Throws InputError when it is none.
double number_in(const PointFileContent& file, int line, std::string_view word);

/// The end of the message about a number that is no coordinate: the numbers that are.
std::string allowed_coordinate(double value, const CoordinateRange& range);

/// Throws InputError where a type of particles is asked of a file that has none.
void check_no_particles(const PointReading& how, const std::filesystem::path& path);

/// Throws InputError `file:line: value: allowed`; line 0 is left out.
[[noreturn]] void fail_in_point_file(const PointFileContent& file, int line, std::string_view value,
                                     std::string_view allowed);

}
