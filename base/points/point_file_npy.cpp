// Reads point sets from NumPy's .npy format, versions 1 to 3
// (https://numpy.org/doc/stable/reference/generated/numpy.lib.format.html). The readers of
// libraries (xtensor) do not say what is wrong with a file, and do not compare its shape with its size.
#include "base/files/byte_order.hpp"
#include "base/points/point_file_formats.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>

namespace poissonlab {

namespace {

constexpr std::string_view allowed_shapes = "must be (N, 2), (N, 3), (K, N, 2) or (K, N, 3)";

/// The content of a .npy file's header, and the place at which the numbers start.
struct NpyLayout
{
    std::endian byte_order = std::endian::little;
    std::size_t value_bytes = 8; ///< 4: float32, 8: float64
    bool fortran_order = false;
    std::size_t realizations = 1;
    std::size_t points = 0;
    std::size_t dimension = 0;
    std::size_t data_offset = 0;

    /// The place of coordinate `axis` of a point, in values.
    std::size_t index(std::size_t realization, std::size_t point, std::size_t axis) const
    {
        return fortran_order ? realization + realizations * (point + points * axis)
                             : (realization * points + point) * dimension + axis;
    }
};

[[noreturn]] void fail_truncated(const PointFileContent& file)
{
    fail_in_point_file(file, 0, fmt::format("ends after {} bytes", file.bytes.size()),
                       "must have a whole NumPy header");
}

/// The header's dictionary, a Python literal. Sets `data_offset`.
std::string_view header_text(const PointFileContent& file, std::size_t& data_offset)
{
    constexpr std::size_t version_offset = npy_magic.size();
    constexpr std::size_t length_offset = version_offset + 2;
    if (file.bytes.size() < length_offset + 4) fail_truncated(file);

    const bool short_length = file.bytes[version_offset] == 1;
    const std::string_view length_bytes = file.bytes.substr(length_offset);
    const std::size_t length = short_length ? load<std::uint16_t>(length_bytes, std::endian::little)
                                            : load<std::uint32_t>(length_bytes, std::endian::little);
    const std::size_t text_offset = length_offset + (short_length ? 2 : 4);
    if (length > file.bytes.size() - text_offset) fail_truncated(file);
    data_offset = text_offset + length;
    return file.bytes.substr(text_offset, length);
}

/// The text after `'key':` in the dictionary.
std::string_view value_of(const PointFileContent& file, std::string_view header, std::string_view key)
{
    const std::string quoted = fmt::format("'{}':", key);
    const std::size_t at = header.find(quoted);
    if (at == std::string_view::npos) {
        fail_in_point_file(file, 0, "NumPy header", fmt::format("must have the key '{}'", key));
    }
    std::string_view value = header.substr(at + quoted.size());
    while (value.starts_with(' ')) value.remove_prefix(1);
    return value;
}

void read_type(const PointFileContent& file, std::string_view value, NpyLayout& layout)
{
    const std::string_view type = value.substr(0, value.find_first_of(",}"));
    if (type == "'<f8'" || type == "'>f8'") {
        layout.value_bytes = 8;
    } else if (type == "'<f4'" || type == "'>f4'") {
        layout.value_bytes = 4;
    } else {
        fail_in_point_file(file, 0, fmt::format("type {}", type), "must be float32 or float64 ('<f4' or '<f8')");
    }
    layout.byte_order = type[1] == '>' ? std::endian::big : std::endian::little;
}

/// The numbers of a tuple such as `(100, 2)`. Empty when it is not made of numbers.
std::vector<std::size_t> read_tuple(std::string_view tuple)
{
    std::vector<std::size_t> numbers;
    tuple.remove_prefix(1);
    while (!tuple.empty()) {
        std::size_t number = 0;
        const auto [stop, error] = std::from_chars(tuple.data(), tuple.data() + tuple.size(), number);
        if (error != std::errc()) return {};
        numbers.push_back(number);
        tuple.remove_prefix(static_cast<std::size_t>(stop - tuple.data()));
        while (tuple.starts_with(',') || tuple.starts_with(' ')) tuple.remove_prefix(1);
    }
    return numbers;
}

void read_shape(const PointFileContent& file, std::string_view value, NpyLayout& layout)
{
    const std::string_view tuple = value.substr(0, value.find(')'));
    std::vector<std::size_t> shape;
    if (tuple.starts_with('(')) shape = read_tuple(tuple);
    const std::size_t axes = shape.size();
    if ((axes != 2 && axes != 3) || (shape.back() != 2 && shape.back() != 3)) {
        fail_in_point_file(file, 0, fmt::format("shape {})", tuple), allowed_shapes);
    }
    if (axes == 3) layout.realizations = shape[0];
    layout.points = shape[axes - 2];
    layout.dimension = shape[axes - 1];
}

/// Sees that the file holds just as many values as its shape says, however large the numbers there are.
void check_size(const PointFileContent& file, const NpyLayout& layout)
{
    if (layout.points == 0 || layout.realizations == 0) {
        fail_in_point_file(file, 0, "no points", "N and K of the shape must be at least 1");
    }
    const std::size_t present = file.bytes.size() - layout.data_offset;
    std::size_t declared = 0;
    const bool overflow = __builtin_mul_overflow(layout.points, layout.realizations, &declared) ||
                          __builtin_mul_overflow(declared, layout.dimension * layout.value_bytes, &declared);
    if (overflow) fail_in_point_file(file, 0, "shape", "declares more values than any file can hold");
    if (declared != present) {
        fail_in_point_file(file, 0, fmt::format("{} bytes of coordinates", present),
                           fmt::format("must be {}, as the shape says", declared));
    }
}

/// A coordinate of the unit torus, along the axis.
double unit_coordinate_at(const PointFileContent& file, const NpyLayout& layout, std::size_t axis, std::size_t index)
{
    const std::size_t offset = layout.data_offset + index * layout.value_bytes;
    const std::string_view bytes = file.bytes.substr(offset);
    const double value =
        layout.value_bytes == 8 ? load<double>(bytes, layout.byte_order) : load<float>(bytes, layout.byte_order);
    if (!is_coordinate(value, file.domain[axis])) fail_coordinate_at_byte(file, axis, offset, value);
    return to_unit(value, file.domain[axis]);
}

}

namespace {

NpyLayout read_npy_layout(const PointFileContent& file)
{
    NpyLayout layout;
    const std::string_view header = header_text(file, layout.data_offset);
    read_type(file, value_of(file, header, "descr"), layout);
    layout.fortran_order = value_of(file, header, "fortran_order").starts_with("True");
    read_shape(file, value_of(file, header, "shape"), layout);
    check_size(file, layout);
    return layout;
}

}

NpyShape shape_of_npy_sets(const PointFileContent& file)
{
    const NpyLayout layout = read_npy_layout(file);
    return {layout.realizations, layout.points, static_cast<int>(layout.dimension)};
}

void stream_npy_points(const PointFileContent& file, const PieceSink& sink)
{
    constexpr std::size_t points_of_piece = std::size_t{1} << 18;
    const NpyLayout layout = read_npy_layout(file);
    if (layout.realizations != 1)
        fail_in_point_file(file, 0, fmt::format("{} sets", layout.realizations),
                           "a file that is read in pieces has one");
    std::vector<double> piece;
    for (std::size_t n = 0; n < layout.points;) {
        const std::size_t end = std::min(layout.points, n + points_of_piece);
        piece.clear();
        for (; n < end; ++n)
            for (std::size_t axis = 0; axis < layout.dimension; ++axis)
                piece.push_back(unit_coordinate_at(file, layout, axis, layout.index(0, n, axis)));
        const std::size_t done =
            layout.fortran_order ? 0 : layout.data_offset + n * layout.dimension * layout.value_bytes;
        sink(static_cast<int>(layout.dimension), piece, file.bytes.data() + done);
    }
}

std::vector<PointSet> read_npy_points(const PointFileContent& file)
{
    const NpyLayout layout = read_npy_layout(file);
    std::vector<PointSet> sets(layout.realizations);
    for (std::size_t k = 0; k < layout.realizations; ++k) {
        sets[k].dimension = static_cast<int>(layout.dimension);
        sets[k].coordinates.reserve(layout.points * layout.dimension);
        for (std::size_t n = 0; n < layout.points; ++n) {
            for (std::size_t axis = 0; axis < layout.dimension; ++axis) {
                sets[k].coordinates.push_back(unit_coordinate_at(file, layout, axis, layout.index(k, n, axis)));
            }
        }
    }
    return sets;
}

}
