// Reads a point set from a PLY file, ascii or binary: the properties x, y and z of the element `vertex`.
#include "base/files/text_lines.hpp"
#include "base/points/ply_header.hpp"
#include "base/points/point_file_formats.hpp"
#include "base/points/unit_coordinates.hpp"
#include "base/text/decimal_commas.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace poissonlab {

namespace {

/// The element `vertex`, and the columns of its coordinates.
struct Vertices
{
    std::size_t element = 0; ///< index in the header
    const PlyElement* table = nullptr;
    std::vector<std::size_t> columns; ///< of x, y and, where there is one, z
    std::size_t class_column = 0;     ///< if classes are asked for
};

Vertices find_vertices(const PointFileContent& file, const PlyHeader& header)
{
    const auto fail = [&file](std::string_view value, std::string_view allowed) {
        fail_in_point_file(file, 0, value, allowed);
    };
    Vertices vertices;
    const auto table = std::ranges::find(header.elements, "vertex", &PlyElement::name);
    if (table == header.elements.end()) fail("PLY header", "must have an `element vertex`");
    vertices.element = static_cast<std::size_t>(table - header.elements.begin());
    vertices.table = &*table;

    for (const char* axis : {"x", "y", "z"}) {
        const auto property = std::ranges::find(table->properties, axis, &PlyProperty::name);
        if (property != table->properties.end()) {
            vertices.columns.push_back(static_cast<std::size_t>(property - table->properties.begin()));
        } else if (*axis != 'z') {
            fail("PLY header", "the element `vertex` must have the properties x and y");
        }
    }
    const std::string wanted = file.has_classes() ? file.classes.column : "class";
    const auto found = std::ranges::find(table->properties, wanted, &PlyProperty::name);
    vertices.class_column = static_cast<std::size_t>(found - table->properties.begin());
    const bool is_there = found != table->properties.end();
    if (is_there && !file.has_classes()) file.tell("the classes of the points are left out");
    if (!is_there && file.has_classes())
        fail("PLY header", fmt::format("the element `vertex` must have the property {} with the classes", wanted));
    if (file.has_classes() && std::ranges::count(vertices.columns, vertices.class_column) > 0)
        fail(wanted, "is a coordinate; classes must be another property of the element `vertex`");
    if (table->has_lists) fail("PLY header", "the element `vertex` must not have lists");
    if (table->count == 0) fail("no points", "the element `vertex` must have at least one row");
    return vertices;
}

[[noreturn]] void fail_truncated(const PointFileContent& file, const PlyElement& table)
{
    fail_in_point_file(file, 0, fmt::format("element {} {}", table.name, table.count),
                       "the file ends before it has that many rows");
}

/// Throws when a file of `bytes` cannot have the rows of a table, each `row_bytes` at least.
/// No memory is allocated for a count before it went through here.
void check_room(const PointFileContent& file, const PlyElement& table, std::size_t bytes, std::size_t row_bytes)
{
    if (row_bytes > 0 && table.count > bytes / row_bytes) fail_truncated(file, table);
}

/// The class that a number of a property stands for. It has as many digits as the property's type needs, whether the
/// file is ascii or binary. Not-a-number is no class.
std::string class_name(double value, PlyType type)
{
    if (std::isnan(value)) return {};
    if (value == 0) value = 0; // without a sign
    if (type == PlyType::float32 && std::abs(value) <= double{std::numeric_limits<float>::max()})
        return fmt::format("{}", static_cast<float>(value));
    return fmt::format("{}", value);
}

/// Coordinates from the lines of an ascii body.
std::vector<double> read_ascii(const PointFileContent& file, const PlyHeader& header, const Vertices& vertices)
{
    LineReader lines(header.body, header.lines);
    const auto next_row = [&](const PlyElement& table) {
        do {
            if (!lines.next()) fail_truncated(file, table);
        } while (trimmed(lines.line()).empty());
    };

    // Skip the tables before.
    for (std::size_t e = 0; e < vertices.element; ++e) {
        check_room(file, header.elements[e], header.body.size() + 1, 2);
        for (std::size_t row = 0; row < header.elements[e].count; ++row) next_row(header.elements[e]);
    }

    // Each number takes two bytes at least, but for the last of a file without an end of line.
    const std::size_t width = vertices.table->properties.size();
    check_room(file, *vertices.table, lines.rest().size() + 1, 2 * width);
    std::vector<double> coordinates;
    coordinates.reserve(vertices.table->count * vertices.columns.size());
    std::vector<std::string_view> row;
    UnitCoordinates units(file);
    for (std::size_t i = 0; i < vertices.table->count; ++i) {
        next_row(*vertices.table);
        if (lines.line().find(',') != std::string_view::npos)
            fail_in_point_file(file, lines.number(), lines.line(),
                               "blanks separate the numbers of PLY" + decimal_comma_words(lines.line()));
        row.clear();
        for (WordReader words(lines.line()); words.next();) row.push_back(words.word());
        if (row.size() != width) {
            fail_in_point_file(file, lines.number(), fmt::format("{} numbers", row.size()),
                               fmt::format("must be {}, as the header says", width));
        }
        for (std::size_t axis = 0; axis < vertices.columns.size(); ++axis) {
            const std::string_view word = row[vertices.columns[axis]];
            coordinates.push_back(units(number_in(file, lines.number(), word), axis, 0, [&] {
                return CoordinatePlace{lines.number(), std::string(word)};
            }));
        }
        if (!file.has_classes()) continue;
        const std::string_view word = row[vertices.class_column];
        double value = 0;
        if (!parse_number(word, value))
            fail_in_point_file(file, lines.number(), word, "must be a number, as in all of PLY");
        file.classes.take(class_name(value, vertices.table->properties[vertices.class_column].type));
    }
    units.finish();

    // Points that the header does not count would be lost without a word.
    const bool last = vertices.element + 1 == header.elements.size();
    while (last && lines.next()) {
        if (!trimmed(lines.line()).empty()) {
            fail_in_point_file(file, lines.number(), lines.line(),
                               fmt::format("the header says that there are {} vertices", vertices.table->count));
        }
    }
    return coordinates;
}

double rounding_of(PlyType type)
{
    return type == PlyType::float64 ? half_ulp_of_double : type == PlyType::float32 ? half_ulp_of_float : 0;
}

/// Coordinates from a binary body.
std::vector<double> read_binary(const PointFileContent& file, const PlyHeader& header, const Vertices& vertices)
{
    // Skip the tables before.
    std::string_view body = header.body;
    for (std::size_t e = 0; e < vertices.element; ++e) {
        const PlyElement& table = header.elements[e];
        if (table.has_lists) {
            fail_in_point_file(file, 0, fmt::format("element {}", table.name),
                               "an element with lists must come after the vertices in a binary file");
        }
        check_room(file, table, body.size(), table.row_bytes);
        body.remove_prefix(table.count * table.row_bytes);
    }

    const std::size_t row_bytes = vertices.table->row_bytes;
    check_room(file, *vertices.table, body.size(), row_bytes);
    std::vector<double> coordinates;
    coordinates.reserve(vertices.table->count * vertices.columns.size());
    UnitCoordinates units(file);
    for (std::size_t i = 0; i < vertices.table->count; ++i) {
        for (std::size_t axis = 0; axis < vertices.columns.size(); ++axis) {
            const PlyProperty& property = vertices.table->properties[vertices.columns[axis]];
            const std::string_view bytes = body.substr(i * row_bytes + property.offset);
            const double value = load_ply_value(bytes, property.type, header.byte_order);
            coordinates.push_back(units(value, axis, rounding_of(property.type),
                                        [&] { return place_at_byte(file.bytes.size() - bytes.size(), value); }));
        }
        if (!file.has_classes()) continue;
        const PlyProperty& property = vertices.table->properties[vertices.class_column];
        const std::string_view bytes = body.substr(i * row_bytes + property.offset);
        file.classes.take(class_name(load_ply_value(bytes, property.type, header.byte_order), property.type));
    }
    units.finish();

    const std::size_t left = body.size() - vertices.table->count * row_bytes;
    if (vertices.element + 1 == header.elements.size() && left > 0) {
        fail_in_point_file(file, 0, fmt::format("{} bytes after the vertices", left),
                           fmt::format("the header says that there are {} vertices", vertices.table->count));
    }
    return coordinates;
}

}

std::vector<PointSet> read_ply_points(const PointFileContent& file)
{
    const PlyHeader header = read_ply_header(file);
    const Vertices vertices = find_vertices(file, header);
    std::vector<double> coordinates =
        header.ascii ? read_ascii(file, header, vertices) : read_binary(file, header, vertices);
    return {PointSet{static_cast<int>(vertices.columns.size()), std::move(coordinates)}};
}

}
