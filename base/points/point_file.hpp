// Point sets as files: text and tables, PLY, NumPy, HDF5 and those of UTK, told apart by their first bytes, not by
// their names.
#pragma once

#include "base/geometry/point_set.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace poissonlab {

// The domain of points: which coordinates a file or a user says that there can be.

/// The half-open range [low, high) of coordinates along an axis.
struct CoordinateRange
{
    double low = 0;
    double high = 1;
};

/// All numbers, which stay as they are: of points in units of their own.
inline constexpr CoordinateRange any_coordinates{-std::numeric_limits<double>::infinity(),
                                                 std::numeric_limits<double>::infinity()};

/// The range that `LOW:HIGH` says, or `HIGH` for 0:HIGH, such as "512" or "-1:1". Nothing for any other text, and where
/// LOW is not below HIGH.
std::optional<CoordinateRange> parse_range(std::string_view text);

/// A square (cube), with one range for all axes, or a rectangle (box), with one for each.
class PointDomain
{
public:
    PointDomain(CoordinateRange all = {}) : ranges_{all, all, all} {}

    /// Two or three ranges; a third coordinate that there should not be can be any number. It is here for the module of
    /// files of particles, which links nothing of this room.
    explicit PointDomain(std::span<const CoordinateRange> ranges)
        : ranges_{any_coordinates, any_coordinates, any_coordinates}, dimension_(static_cast<int>(ranges.size()))
    {
        std::ranges::copy(ranges, ranges_.begin());
    }

    const CoordinateRange& operator[](std::size_t axis) const { return ranges_[axis]; }

    /// Returns the dimension of the points that the domain is for; 0: any.
    int dimension() const { return dimension_; }

    /// The length along each axis; none of a domain with one range for all axes.
    std::vector<double> sides() const;

    bool is_square() const; ///< or a cube: all sides are the same

private:
    std::array<CoordinateRange, 3> ranges_;
    int dimension_ = 0;
};

/// The domain that a text says: a range for all axes, as for parse_range(), one for each axis with blanks between them
/// ("0:2 0:1", "10 10 30"), or the lower and the upper corner ("0 0 2 1"). Nothing for any other text.
std::optional<PointDomain> parse_domain(std::string_view text);

/// Its form, in the words of messages.
inline constexpr auto domain_form =
    "LOW:HIGH, two numbers, the first smaller; or HIGH; or one of these for each axis, such as \"0:2 0:1\"";

/// Point options name, in messages, the options of the program that asks for points: formats of fmt; empty: none.
struct PointOptions
{
    const char* domain = "";    ///< of the range's two ends
    const char* region = "";    ///< of the rectangle's two corners
    const char* crs = "";       ///< of coordinates that are longitude and latitude
    const char* particles = ""; ///< of the type of particles
};

/// The classes of points (also called marks) if they are requested: text, tables, PLY and GeoJSON can have them.
struct PointClasses
{
    /// The name of the column or of the property, or the number of the column, counted from 1, in tables without names;
    /// empty: classes are left out.
    std::string column{};
    std::function<void(std::string_view name)> take{}; ///< is called with the class of each point, in their order
};

/// Options for reading a file.
struct PointReading
{
    /// The domain of the coordinates. Not given: the domain that the file declares by a comment `domain LOW:HIGH`
    /// before its points, or `domain LOW:HIGH LOW:HIGH` with a range for each axis, by its attributes, or else [0, 1).
    /// any_coordinates stay as they are, others are mapped to [0, 1).
    std::optional<PointDomain> domain{};

    /// The type of particles of a snapshot; not given: its only one.
    std::optional<int> particles{};

    /// Takes sentences about what was left out, or taken for something else.
    std::function<void(const std::string& sentence)> told{};

    PointOptions options{};
    PointClasses classes{};

    /// The sentence that is told of columns of longitude and latitude; empty: none. With a domain that has ends they
    /// are refused, because degrees are no lengths.
    std::string degrees_sentence{};
};

/// Reads the point sets of a file, one a realization.
///
/// Text: one point a line, 2 or 3 coordinates separated by blanks, a comma or a semicolon; a line with `#` alone
/// separates realizations (as UTK writes them); `# words` is a comment; blank lines are ignored. A first line may hold
/// the number of points alone (as for psa), which must be right then, or names of columns: see text_table.hpp.
/// PLY: ascii and binary (either byte order), vertex properties x, y and, where there is one, z.
/// NPY: float32 or float64 (either byte order), shape (N, 2), (N, 3), (K, N, 2) or (K, N, 3), C or Fortran
/// order.
/// HDF5: see hdf5_reading.hpp.
/// UTK (.bin): a header of 20 bytes, then int32, int64, uint32, uint64, float or double, all sets of one size.
///
/// Points of the plane are often stored as x, y and one number that is always the same: such a coordinate is left out,
/// with a sentence, see flat_points.hpp.
///
/// Throws InputError with file and line (or the byte offset): no points, a coordinate that is not a finite
/// number in its range, lines of unequal length, truncated files, a domain with sides that differ: that is no square.
std::vector<PointSet> read_points(const std::filesystem::path& path, const PointReading& how);
std::vector<PointSet> read_points(const std::filesystem::path& path, std::optional<CoordinateRange> range = {});

/// Reads them for whoever measures points in rectangles and boxes, too: `domain` becomes that of the file.
std::vector<PointSet> read_points_in_box(const std::filesystem::path& path, const PointReading& how,
                                         PointDomain& domain);

/// Reads points that the program itself has written: all of their coordinates, and else as above.
std::vector<PointSet> read_own_points(const std::filesystem::path& path, std::optional<CoordinateRange> range = {});

/// The files that a set is read from where this one is named: all parts of a snapshot, or the file itself.
std::vector<std::filesystem::path> files_of_points(const std::filesystem::path& path);

/// The files without those that are parts of a snapshot of which one is named before; `told` is called with a sentence
/// where some are.
std::vector<std::filesystem::path> without_further_parts(const std::vector<std::filesystem::path>& files,
                                                         const std::function<void(const std::string&)>& told);

/// Writes one point set. The format follows the extension: .ply (ascii, double), .npy (float64, N x
/// dimension), .h5 (HDF5), .hdf5 and .h5part (particles in 3D, see hdf5_points.hpp), .csv (columns x, y and, in 3D, z),
/// .usda (a point instancer of USD, whose positions are floats), .geojson (a feature for each point) and .dxf (points
/// of release 12), which are not read back; .txt, .dat or none is text with 17 significant digits, so that reading back
/// gives the same doubles. `comment`, where the format has room for it, is put at the top. Whole or not at all. Throws
/// StorageError, and InputError for others than point_file_endings().
void write_points(const std::filesystem::path& path, const PointSet& points, const std::string& comment = {});

/// Takes whole points, coordinate after coordinate.
using PointSink = std::function<void(std::span<const double> coordinates)>;

/// Writes points that need not be in memory together, in any range of coordinates: calls `write` with a sink that takes
/// them, `points` points in all. `comment` may declare the range, as for read_points().
void write_points_in_pieces(const std::filesystem::path& path, int dimension, std::size_t points,
                            const std::string& comment, const std::function<void(const PointSink& sink)>& write);

}
