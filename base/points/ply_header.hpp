// The header of a PLY file (Turk 1994, "The PLY polygon file format").
#pragma once

#include "base/points/point_file_formats.hpp"

#include <bit>
#include <optional>
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

/// A property of any kind: of lists, how the number of entries is stored, which comes before them.
struct PlyColumn
{
    std::string name;
    PlyType type = PlyType::float32; ///< of the entries, too
    std::optional<PlyType> count;
};

/// A table of the file: `count` rows with the same properties.
struct PlyElement
{
    std::string name;
    std::size_t count = 0;
    std::vector<PlyColumn> columns;      ///< all properties
    std::vector<PlyProperty> properties; ///< those that are no lists
    std::size_t row_bytes = 0;           ///< of these, in binary files
    bool has_lists = false;              ///< rows have no fixed size
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

}
