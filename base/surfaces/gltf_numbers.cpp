#include "base/surfaces/gltf_numbers.hpp"

#include "base/files/byte_order.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace poissonlab {
namespace {

/// Places without numbers are all 0; only so many of them.
constexpr std::size_t most_without_view = std::size_t{1} << 22;

std::size_t size_of_component(std::int64_t type)
{
    return type == 5120 || type == 5121 ? 1 : type == 5122 || type == 5123 ? 2 : type == 5125 || type == 5126 ? 4 : 0;
}

double loaded_component(std::string_view bytes, std::int64_t type, bool is_normalized)
{
    const auto fraction = [&](auto value) {
        using Whole = decltype(value);
        const auto number = static_cast<double>(value);
        return is_normalized ? std::max(number / static_cast<double>(std::numeric_limits<Whole>::max()), -1.0) : number;
    };
    constexpr auto order = std::endian::little;
    switch (type) {
    case 5120:
        return fraction(load<std::int8_t>(bytes, order));
    case 5121:
        return fraction(load<std::uint8_t>(bytes, order));
    case 5122:
        return fraction(load<std::int16_t>(bytes, order));
    case 5123:
        return fraction(load<std::uint16_t>(bytes, order));
    case 5125:
        return fraction(load<std::uint32_t>(bytes, order));
    default:
        return static_cast<double>(load<float>(bytes, order));
    }
}

}

/// Rows of numbers in a buffer.
struct GltfNumbers::Rows
{
    std::string_view bytes;
    std::size_t stride = 0, component = 0;
    std::int64_t type = 0;
    bool is_normalized = false;

    double at(std::size_t row, std::size_t column) const
    {
        return loaded_component(bytes.substr(row * stride + column * component), type, is_normalized);
    }
};

GltfNumbers::GltfNumbers(GltfFile& file)
    : file_(file), accessors_(file.list("accessors")), views_(file.list("bufferViews"))
{}

GltfNumbers::Rows GltfNumbers::rows_at(const StoredObject& place, const StoredObject& form, std::size_t count,
                                       std::size_t width)
{
    Rows rows;
    rows.type = form.integer("componentType", 0);
    rows.component = size_of_component(rows.type);
    if (rows.component == 0) throw form.error("componentType", "must be 5120 to 5123, 5125 or 5126");
    rows.is_normalized = form.has("normalized") && form.boolean("normalized");
    const StoredObject& view = named_in(views_, place, "bufferView");
    const std::string_view buffer = file_.buffer(view);
    const std::size_t begin = count_or(view, "byteOffset", 0), size = count_or(view, "byteLength", 0);
    if (begin > buffer.size() || size > buffer.size() - begin)
        throw view.error("byteLength", fmt::format("ends after its buffer, which has {} bytes", buffer.size()));
    const std::size_t row_bytes = width * rows.component, offset = count_or(place, "byteOffset", 0);
    rows.stride = count_or(view, "byteStride", row_bytes);
    if (rows.stride < row_bytes) throw view.error("byteStride", fmt::format("must be at least {}", row_bytes));
    const bool fits =
        offset <= size &&
        (count == 0 || (row_bytes <= size - offset && count - 1 <= (size - offset - row_bytes) / rows.stride));
    if (!fits)
        throw place.error("bufferView", fmt::format("has {} bytes, in which {} rows of {} bytes from {} on do not fit",
                                                    size, count, row_bytes, offset));
    rows.bytes = buffer.substr(begin + offset, size - offset);
    return rows;
}

std::vector<double> GltfNumbers::read(const StoredObject& object, const std::string& member, const std::string& type,
                                      std::size_t width)
{
    const StoredObject& accessor = named_in(accessors_, object, member);
    if (accessor.text("type") != type) throw accessor.error("type", "must be " + type);
    const auto count = static_cast<std::size_t>(accessor.integer("count", 1, static_cast<std::int64_t>(most_in_mesh)));
    const bool has_view = accessor.has("bufferView");
    if (!has_view && !accessor.has("sparse")) throw accessor.error("bufferView", "is missing: there are no numbers");
    if (!has_view && count > most_without_view)
        throw accessor.error("count", fmt::format("without a bufferView, at most {}", most_without_view));
    std::vector<double> values;
    if (has_view) {
        const Rows rows = rows_at(accessor, accessor, count, width);
        values.reserve(count * width);
        for (std::size_t row = 0; row < count; ++row)
            for (std::size_t column = 0; column < width; ++column) values.push_back(rows.at(row, column));
    }
    values.resize(count * width);
    if (accessor.has("sparse")) put_sparse(accessor, width, values);
    return values;
}

std::size_t GltfNumbers::width(const StoredObject& object, const std::string& member) const
{
    const std::string type = named_in(accessors_, object, member).text("type");
    return type == "VEC2" ? 2 : type == "VEC3" ? 3 : type == "VEC4" ? 4 : 1;
}

/// Single rows that replace others.
void GltfNumbers::put_sparse(const StoredObject& accessor, std::size_t width, std::vector<double>& values)
{
    const StoredObject sparse = accessor.object("sparse"), places = sparse.object("indices");
    const auto count = static_cast<std::size_t>(sparse.integer("count", 0));
    const Rows indices = rows_at(places, places, count, 1);
    const Rows rows = rows_at(sparse.object("values"), accessor, count, width);
    for (std::size_t i = 0; i < count; ++i) {
        const double row = indices.at(i, 0);
        if (!(row >= 0) || row >= static_cast<double>(values.size() / width))
            throw places.error("bufferView", fmt::format("{}: there is no such row", row));
        for (std::size_t column = 0; column < width; ++column)
            values[static_cast<std::size_t>(row) * width + column] = rows.at(i, column);
    }
}

}
