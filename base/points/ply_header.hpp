// The header of a PLY file (Turk 1994, "The PLY polygon file format").
//
// CGAL reads PLY as well, but says neither the line nor the reason where a file is wrong.
#pragma once

#include "base/points/point_file_formats.hpp"

#include <bit>
#include <string>
#include <vector>

namespace poissonlab {

/// The types of PLY's numbers; float64 has the older name double, and so on.
enum class PlyType
{
    int8,
    uint8,
    int16,
    uint16,
    int32,
    uint32,
    float32,
    float64
};

std::size_t size_of(PlyType type);

/// The number of that type in the first bytes of `bytes`, which are enough.
double load_ply_value(std::string_view bytes, PlyType type, std::endian order);

struct PlyProperty
{
    std::string name;
    PlyType type = PlyType::float32;
    std::size_t offset = 0; ///< bytes from the start of its element, in binary files
};

/// A table of the file: `count` rows with the same properties.
struct PlyElement
{
    std::string name;
    std::size_t count = 0;
    std::vector<PlyProperty> properties;
    std::size_t row_bytes = 0; ///< in binary files
    bool has_lists = false;    ///< rows have no fixed size
};

struct PlyHeader
{
    bool ascii = true;
    std::endian byte_order = std::endian::little;
    std::vector<PlyElement> elements;
    std::string_view body; ///< what follows the header
    int lines = 0;         ///< how many lines the header has
};

/// Throws InputError with file and line.
PlyHeader read_ply_header(const PointFileContent& file);

/// Columns of an element without lists, row after row: `element` and `columns` count as the header has them. Numbers
/// lie in the file's range, and are mapped from it. Throws InputError, also where an element with lists comes before it
/// in a binary file.
std::vector<double> read_ply_columns(const PointFileContent& file, const PlyHeader& header, std::size_t element,
                                     const std::vector<std::size_t>& columns);

}
