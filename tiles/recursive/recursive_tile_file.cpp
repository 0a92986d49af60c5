#include "tiles/recursive/recursive_tile_file.hpp"

#include "base/errors/errors.hpp"
#include "base/files/byte_order.hpp"
#include "base/files/whole_file.hpp"
#include "base/files/xxh64_bytes.hpp"

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <utility>

namespace poissonlab {
namespace {

constexpr std::string_view recursive_magic = "RECWANG1";
constexpr std::size_t head_bytes = 20;
constexpr std::size_t checksum_bytes = 8;

std::size_t tile_bytes(std::uint32_t points_per_tile)
{
    return recursive_cells + std::size_t{2} * recursive_cells * points_per_tile;
}

template <class T>
void append(std::string& bytes, T value)
{
    for (std::size_t i = 0; i < sizeof(T); ++i) bytes.push_back(static_cast<char>(value >> 8 * i & 0xFF));
}

RecursiveTileSet tiles_in(std::string_view bytes)
{
    if (!bytes.starts_with(recursive_magic) || bytes.size() < head_bytes + checksum_bytes)
        throw InputError("is not a file of recursive Wang tiles");
    const auto points = load<std::uint32_t>(bytes.substr(8), std::endian::little);
    if (points > max_recursive_points ||
        bytes.size() != head_bytes + even_wang_tiles * tile_bytes(points) + checksum_bytes)
        throw InputError(fmt::format("has {} bytes, which do not fit {} points per tile", bytes.size(), points));
    const std::string_view content = bytes.substr(0, bytes.size() - checksum_bytes);
    if (xxh64_bytes(content) != load<std::uint64_t>(bytes.substr(content.size()), std::endian::little))
        throw InputError("is damaged: its checksum is another one");
    RecursiveTiles tiles;
    std::string_view rest = content.substr(head_bytes);
    for (RecursiveTile& tile : tiles) {
        for (std::uint8_t& child : tile.children) {
            child = static_cast<std::uint8_t>(rest[0]);
            rest.remove_prefix(1);
        }
        for (std::size_t i = 0; i < std::size_t{recursive_cells} * points; ++i) {
            tile.links.push_back({load<std::uint16_t>(rest, std::endian::little)});
            rest.remove_prefix(2);
        }
    }
    return {points, load<std::uint64_t>(bytes.substr(12), std::endian::little), std::move(tiles)};
}

}

void write_recursive_tiles(const std::filesystem::path& file, const RecursiveTileSet& tiles)
{
    std::string bytes(recursive_magic);
    append(bytes, tiles.points_per_tile());
    append(bytes, tiles.seed());
    for (std::size_t i = 0; i < even_wang_tiles; ++i) {
        for (const std::uint8_t child : tiles.tile(i).children) append(bytes, child);
        for (const RecursiveLink link : tiles.tile(i).links) append(bytes, link.word);
    }
    append(bytes, xxh64_bytes(bytes));
    write_whole_file(file, bytes);
}

RecursiveTileSet read_recursive_tiles(const std::filesystem::path& file)
{
    const std::string bytes = read_whole_file(file);
    try {
        return tiles_in(bytes);
    } catch (const InputError& error) {
        throw InputError(fmt::format("{}: {}", file.string(), error.what()));
    }
}

}
