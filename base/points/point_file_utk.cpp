// Reads point sets from the binary files of UTK, the uniformity tool kit (https://utk-team.github.io/utk, file formats
// of its executables): 20 bytes of header, four bytes each, and then the coordinates, set after set and point after
// point:
//
//     "UTK!", the code of the type and three bytes that are not used, number of sets, points of each, dimensions
//
// Numbers have the byte order of the machine that wrote them, which the magic number shows. UTK's own programs write
// the first set again and again where there are several (2024); such files are read as they are.
#include "base/files/byte_order.hpp"
#include "base/points/point_file_formats.hpp"

#include <fmt/format.h>

#include <cstdint>

namespace poissonlab {
namespace {

constexpr std::size_t utk_header_bytes = 20;

struct UtkLayout
{
    std::endian byte_order = std::endian::little;
    std::uint8_t type = 5;
    std::size_t sets = 0, points = 0, dimension = 0;

    std::size_t value_bytes() const { return type == 1 || type == 3 || type == 5 ? 8 : 4; }
};

UtkLayout read_layout(const PointFileContent& file)
{
    if (file.bytes.size() < utk_header_bytes)
        fail_in_point_file(file, 0, fmt::format("ends after {} bytes", file.bytes.size()),
                           "must have a whole UTK header of 20");
    UtkLayout layout;
    layout.byte_order = file.bytes.starts_with(utk_magic) ? std::endian::little : std::endian::big;
    layout.type = static_cast<std::uint8_t>(file.bytes[utk_magic.size()]);
    const auto number = [&](std::size_t offset) {
        return load<std::uint32_t>(file.bytes.substr(offset), layout.byte_order);
    };
    layout.sets = number(8);
    layout.points = number(12);
    layout.dimension = number(16);
    return layout;
}

void check_layout(const PointFileContent& file, const UtkLayout& layout)
{
    if (layout.type > 5) fail_in_point_file(file, 0, fmt::format("type {}", layout.type), "must be 0 to 5");
    if (layout.dimension != 2 && layout.dimension != 3)
        fail_in_point_file(file, 0, fmt::format("{} dimensions", layout.dimension), "must be 2 or 3");
    if (layout.sets == 0 || layout.points == 0)
        fail_in_point_file(file, 0, fmt::format("{} sets of {} points", layout.sets, layout.points),
                           "must be at least 1 each");
    const std::size_t present = file.bytes.size() - utk_header_bytes;
    std::size_t declared = 0;
    const bool overflow = __builtin_mul_overflow(layout.sets, layout.points, &declared) ||
                          __builtin_mul_overflow(declared, layout.dimension * layout.value_bytes(), &declared);
    if (overflow || declared != present)
        fail_in_point_file(file, 0, fmt::format("{} bytes of coordinates", present),
                           fmt::format("must be {} x {} x {} x {}, as the header says", layout.sets, layout.points,
                                       layout.dimension, layout.value_bytes()));
}

/// The number at the begin of `bytes`.
double number_of(std::string_view bytes, const UtkLayout& layout)
{
    const std::endian order = layout.byte_order;
    switch (layout.type) {
    case 0:
        return load<std::int32_t>(bytes, order);
    case 1:
        return static_cast<double>(load<std::int64_t>(bytes, order));
    case 2:
        return load<std::uint32_t>(bytes, order);
    case 3:
        return static_cast<double>(load<std::uint64_t>(bytes, order));
    case 4:
        return static_cast<double>(load<float>(bytes, order));
    default:
        return load<double>(bytes, order);
    }
}

}

std::vector<PointSet> read_utk_points(const PointFileContent& file)
{
    const UtkLayout layout = read_layout(file);
    check_layout(file, layout);
    std::vector<PointSet> sets(layout.sets);
    std::size_t offset = utk_header_bytes;
    for (PointSet& set : sets) {
        set.dimension = static_cast<int>(layout.dimension);
        set.coordinates.reserve(layout.points * layout.dimension);
        for (std::size_t i = 0; i < layout.points * layout.dimension; ++i, offset += layout.value_bytes()) {
            const double value = number_of(file.bytes.substr(offset), layout);
            const std::size_t axis = i % layout.dimension;
            if (!is_coordinate(value, file.domain[axis])) fail_coordinate_at_byte(file, axis, offset, value);
            set.coordinates.push_back(to_unit(value, file.domain[axis]));
        }
    }
    return sets;
}

}
